"""Which of many named files is the one to grade, and what to say if there is none or two?"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from grader.intake.screen import SOURCE_NAME, printable

MOST_ENTRIES = 20_000
"""A folder or archive with more entries is not searched to its end."""

_JUNK = "__MACOSX"
_TELLING = (".cpp", ".cc", ".cxx", ".zip", ".gz", ".tgz", ".rar", ".7z")
_MOST_NAMED = 3


@dataclass(frozen=True, slots=True)
class Fault:
    """Why something cannot be graded: a student's fault, one sentence."""

    reason: str


@dataclass(frozen=True, slots=True)
class Candidate:
    """A file called `exercise03.cpp` that has not been read yet."""

    path: str
    """Where it lies in the folder or archive, as the stranger named it."""

    read: Callable[[int], bytes | Fault]
    """Gives at most so many bytes of it."""


def is_junk(path: str) -> bool:
    """Hidden files and what macOS adds to every archive are nobody's solution."""
    return any(
        part == _JUNK or (part.startswith(".") and part not in {".", ".."})
        for part in parts(path)
    )


def parts(path: str) -> list[str]:
    """The folders and the name in a path of any system."""
    return path.replace("\\", "/").split("/")


def is_source(path: str) -> bool:
    """This is the file that the exercise asks for."""
    return parts(path)[-1] == SOURCE_NAME and not is_junk(path)


def choose(found: list[Candidate], others: Iterable[str]) -> Candidate | Fault:
    """Take the only candidate.

    Args:
        found: Every candidate.
        others: Paths of the other files, of which telling ones are named if there is none.
    """
    if len(found) == 1:
        return found[0]
    if found:
        names = ", ".join(f"`{printable(one.path)}`" for one in found[:_MOST_NAMED])
        return Fault(
            f"{len(found)} files are called {SOURCE_NAME} ({names}), but exactly one is "
            "graded; hand in only that one"
        )
    telling = [o for o in others if o.lower().endswith(_TELLING) and not is_junk(o)]
    names = ", ".join(f"`{printable(other)}`" for other in telling[:_MOST_NAMED])
    instead = f"; there is {names}" if names else ""
    return Fault(f"no file is called {SOURCE_NAME}{instead}")
