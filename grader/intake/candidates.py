"""Which of many named files is the one to grade, and what to say if there is none or two?"""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from grader.model.stages import SOURCE_NAME
from grader.plain import as_name

MOST_ENTRIES = 20_000
"""A folder or archive with more entries is not searched to its end."""

MOST_COPIES = 8
"""Files called `exercise03.cpp` that are read, to see whether all say the same."""

LONGEST_PATH = 4096
"""Characters of a path that are read; an archive may list ones of 65,535."""

_JUNK = "__MACOSX"
_ALMOST = re.compile(r"exercise.?0?3( ?\(\d+\))?\.(cpp|cc|cxx)(\.txt)?", re.IGNORECASE)
_TELLING = (".cpp", ".cc", ".cxx", ".zip", ".gz", ".tgz", ".rar", ".7z")
_MOST_NAMED = 3


@dataclass(frozen=True, slots=True)
class Fault:
    """Why something cannot be graded: a student's fault, one sentence."""

    reason: str


NOT_A_FILE = Fault("this is a link, a pipe or a device; hand in the file itself")
TOO_MANY = Fault(f"more than {MOST_ENTRIES:,} files; hand in only {SOURCE_NAME}")
DAMAGED = Fault("the archive is damaged; pack it again and open it once before handing it in")


class Damage(Exception):
    """How a reader of an archive leaves it; nobody outside of this package sees one."""

    def __init__(self, fault: Fault = DAMAGED) -> None:
        super().__init__(fault.reason)
        self.fault = fault


@dataclass(frozen=True, slots=True)
class Entry:
    """Whatever lies in a folder or an archive."""

    path: str
    """As the stranger named it; one of a folder ends with `/`. It is compared, never opened."""

    read: Callable[[int], bytes | Fault]
    """Gives at most so many bytes, until the next entry is asked for."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A file called `exercise03.cpp`."""

    path: str
    content: bytes | Fault


def is_junk(path: str) -> bool:
    """Hidden files and what macOS adds to every archive are nobody's solution."""
    return any(
        part == _JUNK or (part.startswith(".") and part not in {".", ".."})
        for part in parts(path)
    )


def parts(path: str) -> list[str]:
    """The folders and the name in a path of any system; only the end of an endless one."""
    return path[-LONGEST_PATH:].replace("\\", "/").split("/")


def is_source(path: str) -> bool:
    """This is the file that the exercise asks for."""
    return parts(path)[-1] == SOURCE_NAME and not is_junk(path)


def choose(entries: Iterable[Entry], most: int) -> Candidate | Fault:
    """Take the only candidate, or one of several that hold the same bytes.

    Args:
        entries: Everything there is; it is looked at in this order, and once.
        most: Bytes of a candidate that are read.
    """
    found = _Found()
    for count, entry in enumerate(entries):
        if count >= MOST_ENTRIES:
            return TOO_MANY
        found.add(entry, most)
    return found.chosen()


@dataclass(slots=True)
class _Found:
    """What is kept of thousands of entries: a few candidates and a few telling names."""

    number: int = 0
    candidates: list[Candidate] = field(default_factory=list)
    almost: list[str] = field(default_factory=list)
    telling: list[str] = field(default_factory=list)

    def add(self, entry: Entry, most: int) -> None:
        if is_source(entry.path):
            self.number += 1
            if self.number <= MOST_COPIES:
                self.candidates.append(Candidate(entry.path, entry.read(most)))
        elif not is_junk(entry.path):
            self._remember(entry.path)

    def _remember(self, path: str) -> None:
        if _ALMOST.fullmatch(parts(path)[-1]):
            self.almost = [*self.almost, path][:_MOST_NAMED]
        elif path.lower().endswith(_TELLING):
            self.telling = [*self.telling, path][:_MOST_NAMED]

    def chosen(self) -> Candidate | Fault:
        if not self.number:
            return self._none()
        files = [one for one in self.candidates if one.content != NOT_A_FILE]
        if self.number <= MOST_COPIES and len({one.content for one in files}) <= 1:
            return [*files, *self.candidates][0]
        names = ", ".join(f"`{as_name(one.path)}`" for one in self.candidates[:_MOST_NAMED])
        return Fault(
            f"{self.number:,} files are called {SOURCE_NAME} ({names}), but exactly one is "
            "graded; hand in only that one"
        )

    def _none(self) -> Fault:
        named = [*self.almost, *self.telling][:_MOST_NAMED]
        names = ", ".join(f"`{as_name(path)}`" for path in named)
        instead = f"; there is {names}" if names else ""
        return Fault(f"no file is called {SOURCE_NAME}{instead}")
