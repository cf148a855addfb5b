"""How does a result get into a folder? Tried first, and then as a whole file or not at all."""

import secrets
from contextlib import suppress
from pathlib import Path

from grader.errors import OutputFault, UsageError

OUTPUT = "bvhgrade-out"
"""Where `check` and `grade` write, unless told otherwise."""

RESULT = "result.json"
VIEWS = "views.json"
"""What can be seen of the submission: `report.html` is made from it and from the result."""

PAGE = "report.html"
CLASS_PAGE = "class.html"
STORE = "batch.sqlite"
"""A folder with this file holds the results of a class, and is nobody's submission."""

STUDENTS = "students"
"""Holds a folder for each student of a class."""

STUDENT = "student.json"
"""Whose folder it is, where a whole class was graded."""


def ready(
    folder: Path,
    name: str = RESULT,
    submission: Path | None = None,
    remedy: str = "name another folder with -o",
) -> Path:
    """Create an output folder and prove that a result can be written into it.

    Args:
        folder: Where the result goes.
        name: Of the file that will be written.
        submission: What is graded, if the folder may lie within it or beside it.
        remedy: What whoever typed the command can do.

    Raises:
        UsageError: It cannot be, so grading need not start.
    """
    try:
        refuse_link(folder, submission)
        folder.mkdir(parents=True, exist_ok=True)
        if (folder / name).is_dir():
            raise UsageError(f"{folder / name} is a folder, but the result goes there.")
        trial = folder / f".{name}-{secrets.token_hex(8)}"
        trial.touch(exist_ok=False)
        trial.unlink()
    except OSError as fault:
        reason = fault.strerror or "it cannot be written"
        raise UsageError(f"{folder}: {reason}, but the result goes there; {remedy}.") from fault
    return folder


def refuse_link(folder: Path, submission: Path | None = None) -> None:
    """Refuse an output folder that is a link: a submission could have brought it.

    It would lead into somebody else's folder. Of the folders above, those that hold the
    submission as well are the user's own, and all if nothing but the root holds both.

    Raises:
        UsageError: It is one, or lies behind one.
    """
    own = folder.absolute()
    near = own.parent if submission is None else submission.absolute()
    if own.parts[:2] != near.parts[:2]:
        near = own.parent
    for part in (own, *own.parents):
        if part in (near, *near.parents):
            return
        if part.is_symlink():
            raise UsageError(
                f"{part} is a link, which a submission could have brought, and nothing is "
                "written through it; remove it, or choose the folder that it leads to."
            )


def write_whole(path: Path, text: str) -> None:
    """Write a file of text so that a reader sees the old one or the new one, never a part.

    Raises:
        OutputFault: It could not be written; what was there before is untouched.
    """
    write_bytes_whole(path, text.encode("utf-8"), "call again when it can be")


def write_bytes_whole(path: Path, data: bytes, remedy: str) -> None:
    """Write a file so that a reader sees the old one or the new one, never a part.

    Raises:
        OutputFault: It could not be written; what was there before is untouched.
    """
    unfinished = path.with_name(f".{path.name}-{secrets.token_hex(8)}")
    try:
        with unfinished.open("xb") as file:
            file.write(data)
        if path.exists() and not path.is_symlink():
            # Who may read a gradebook stays as it was.
            unfinished.chmod(path.stat().st_mode & 0o777)
        unfinished.replace(path)
    except OSError as fault:
        raise OutputFault(
            f"{path} could not be written: {fault.strerror}; {remedy}."
        ) from fault
    finally:
        with suppress(OSError):
            unfinished.unlink()
