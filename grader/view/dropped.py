"""How does a file that is dropped onto a page come to the desk? Through a folder of ours.

It is bounded before anything of it is kept, and read as every other file is.
"""

import re
from contextlib import ExitStack
from io import BufferedIOBase
from pathlib import Path, PurePosixPath

from grader.counterexample.reading import LARGEST
from grader.errors import UsageError
from grader.sandbox.scratch import scratch_folder
from grader.view.asked import Unanswered
from grader.view.desk import Load
from grader.view.subject import Subject, of_file

LARGEST_MESH = 200_000_000
"""Bytes; as text a million faces take 70 million."""

CHUNK = 1 << 20
LONGEST_NAME = 60
"""Characters, of which each may take four bytes of the 255 that a file's name has."""


def most_bytes(name: str) -> int:
    """Return how large a file of this name may be."""
    return LARGEST if name.lower().endswith(".json") else LARGEST_MESH


def kept(name: str, size: int, body: BufferedIOBase) -> Load:
    """Keep a file until it is read, once.

    Args:
        name: As the page says it is called.
        size: Bytes that the page says it has; negative if it does not say.
        body: What it is in, from here on.

    Returns:
        What reads it, and removes it.

    Raises:
        UsageError: It is too large, or did not arrive whole.
        Unanswered: There is no room for it.
    """
    if not 0 <= size <= most_bytes(name):
        raise UsageError(f"{name}: a file of its kind may have {most_bytes(name):,} bytes")
    with ExitStack() as held:
        try:
            folder = held.enter_context(scratch_folder())
            # It is for nobody else of this machine.
            folder.chmod(0o700)
            file = folder / safe_name(name)
            _copy(body, size, file)
        except OSError as fault:
            raise Unanswered(f"{name} cannot be kept here: {fault.strerror}") from fault
        left = held.pop_all()
    return lambda: _read(file, left)


def _read(file: Path, left: ExitStack) -> Subject:
    with left:
        try:
            return of_file(file)
        except UsageError as fault:
            # Nobody knows our folder.
            raise UsageError(str(fault).replace(f"{file.parent}/", "")) from fault


def _copy(body: BufferedIOBase, size: int, file: Path) -> None:
    with file.open("wb") as written:
        while size:
            part = body.read(min(size, CHUNK))
            if not part:
                raise UsageError(f"{file.name} did not arrive whole")
            size -= written.write(part)


def safe_name(name: str) -> str:
    """Make a name of a file, with its ending, of whatever a page says."""
    last = PurePosixPath(name.replace("\\", "/")).name
    return re.sub(r"[^\w.-]", "_", last)[-LONGEST_NAME:].strip(".") or "file"
