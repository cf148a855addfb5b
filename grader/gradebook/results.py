"""Whose are the results in a folder, and what do they say?

A student is known by the name of the folder that holds `result.json`, which the course chose or
the platform gave when it packed all submissions. What stands inside of a result says nothing
about that: a submission's own name is the student's to choose.
"""

import json
import re
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grader.errors import UsageError
from grader.gradebook.known import class_of, known_folders
from grader.gradebook.marks import moodle_mark
from grader.gradebook.paths import owner, result_paths, strays_in
from grader.gradebook.strict import damaged, finite, read_plain, refuse
from grader.output import RESULT, STORE, STUDENT, STUDENTS
from grader.plain import one_line
from grader.report.as_json import SCHEMA_VERSION, Json, schema_text
from grader.report.escape import LARGEST_JSON

LARGEST_NAMES = 1 << 16
"""Bytes of a file that says whose folder it is."""

_CANVAS = re.compile(r"[^\W_]+_(?:LATE_)?(?P<canvas>\d+)_\d+_", re.IGNORECASE)
LONGEST_PLACE = 80


@dataclass(frozen=True, slots=True)
class Ids:
    """What a course's own file may call a student; empty where the folder does not tell."""

    accounts: tuple[str, ...] = ()
    """Logins, addresses, numbers: the folder's name if no platform made it."""

    participant: str = ""
    """Moodle's number of the participant in this assignment."""

    canvas: str = ""
    """Canvas's number of the user."""

    full_name: str = ""

    def called(self, field: str) -> tuple[str, ...]:
        """List what stands in one of these fields."""
        if field == "account":
            return self.accounts
        return tuple(filter(None, [getattr(self, field)]))

    @property
    def is_any_name(self) -> bool:
        """Nobody says what kind of name it is: a course named the folder."""
        return self.full_name in self.accounts


NOBODY = Ids()

NOTHING: Json = {
    "checks": [],
    "build": {"diagnostics": []},
    "submission": {"sha256": None},
}
"""Stands for a result that does not count; what is worded in other languages is there."""

_UNKNOWN = (
    f"{STORE} knows no student of this folder, so its result does not count; remove it, or "
    "give `bvhgrade batch` the submission again"
)


@dataclass(frozen=True, slots=True)
class Marked:
    """One result and whose it is."""

    student: str
    """Name of the folder, for people."""

    ids: Ids
    result: Json
    why: str = ""
    """Why there is no result to count, whatever lies in the folder; empty if there is one."""

    @property
    def is_nobody_s(self) -> bool:
        """No student is known to have this folder, so it is matched with no row."""
        return self.ids == NOBODY


def results_in(folder: Path, apart: Collection[str] = ()) -> list[Marked]:
    """Read every result that `result_paths` finds.

    Where `bvhgrade batch` keeps a class, only the folders of those count whom its store knows.

    Args:
        folder: Where they lie.
        apart: Names of folders in a class's own one whose results do not count.

    Raises:
        UsageError: There is none, one is damaged, or a class is not given as a whole.
    """
    home = folder.resolve()
    known = known_folders(home) if (home / STORE).is_file() else None
    found: list[Marked] = []
    strays = () if known is None else strays_in(home)
    for path in [*result_paths(folder), *strays]:
        own = path.parent.resolve()
        if (other := class_of(own)) not in (None, home):
            raise UsageError(
                f"{path}: it belongs to a class, whose store says whether it still counts; "
                f"name the folder of the class, {other}"
            )
        if known is None:
            name = owner(own / RESULT).name
            found.append(Marked(name, ids_of(name), read_result(path)))
        elif own.parent != home / STUDENTS or own.name not in known:
            found.append(Marked(own.relative_to(home).as_posix(), NOBODY, NOTHING, _UNKNOWN))
        elif own.name not in apart:
            found.append(Marked(own.name, _known_by_batch(path), read_result(path)))
    return found


def _known_by_batch(path: Path) -> Ids:
    """Read whose a result is where `bvhgrade batch` wrote it, and no student can put a file."""
    known = read_json(path.with_name(STUDENT), LARGEST_NAMES, 1)
    keys = ("name", "id", "email", "layout")
    return ids_by_batch(*(str(known.get(each, "")) for each in keys))


def ids_by_batch(name: str, id: str, email: str, layout: str) -> Ids:
    """Say who it is, as `bvhgrade batch` knows it from a download."""
    # Moodle's and Canvas's own numbers are no accounts: somebody else's ID number may be equal.
    accounts = {"Moodle": (), "Canvas": (), "Gradescope": (id, email)}.get(layout, (name,))
    # What Canvas calls somebody whose name it hides may be the number of somebody else.
    is_named = layout == "Canvas" and name != f"anon_{id}"
    return Ids(
        accounts=tuple(filter(None, accounts)),
        participant=id if layout == "Moodle" else "",
        canvas=id if is_named else "",
        full_name=name,
    )


def ids_of(name: str) -> Ids:
    """Read what the name of a folder tells.

    Only its beginning counts: a platform appends the file's name, and that is a stranger's.
    """
    if mark := moodle_mark(name):
        return Ids(participant=mark.participant, full_name=mark.full_name)
    if (found := _CANVAS.match(name)) and not name.lower().startswith("anon_"):
        return Ids(canvas=found["canvas"])
    return Ids(accounts=(name,), canvas=name if name.isdecimal() else "", full_name=name)


def read_result(path: Path) -> Json:
    """Read one `result.json`, strictly.

    Raises:
        UsageError: It cannot be read, or is not what the grader writes.
    """
    return parsed_result(read_plain(path, LARGEST_JSON), path)


def parsed_result(content: bytes, path: Path | str) -> Json:
    """Read the content of a `result.json`, strictly.

    Args:
        content: What it holds.
        path: Where that comes from, for who has to look.

    Raises:
        UsageError: It is not what the grader writes.
    """
    from jsonschema import Draft202012Validator
    from jsonschema.exceptions import best_match

    value = parsed_json(content, path, SCHEMA_VERSION)
    fault = best_match(Draft202012Validator(json.loads(schema_text())).iter_errors(value))
    if fault is not None:
        # Not its message, which quotes a whole value.
        place = one_line(fault.json_path)[:LONGEST_PLACE]
        raise damaged(path, f"{place} is not as `bvhgrade schema` says ({fault.validator})")
    return value


def read_json(path: Path, most: int, version: int) -> Json:
    """Read an object of ours from a plain file.

    Args:
        path: The file; a link is refused.
        most: Bytes that it may have.
        version: What it says of its own `schema`.

    Raises:
        UsageError: It cannot be read, or is something else.
    """
    return parsed_json(read_plain(path, most), path, version)


def parsed_json(text: bytes, path: Path | str, version: int) -> Json:
    """Read an object of ours.

    Args:
        text: What it is read from.
        path: Where that comes from, for who has to look.
        version: What it says of its own `schema`.

    Raises:
        UsageError: It is something else.
    """
    try:
        value: Any = json.loads(text, parse_constant=refuse, parse_float=finite)
    except (ValueError, RecursionError) as fault:
        raise damaged(path, f"it is not JSON ({fault})") from fault
    found = value.get("schema") if isinstance(value, dict) else None
    if found != version:
        raise damaged(path, f"schema is {str(found)[:20]}, but {version} is read here")
    result: Json = value
    return result
