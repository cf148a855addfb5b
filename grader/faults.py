"""Where does a traceback go? Into a file for a maintainer: nobody else is ever shown one."""

import os
import tempfile
from pathlib import Path

from grader.entries import drop_oldest
from grader.errors import GraderError
from grader.plain import printable
from grader.resources import cache_folder

LONGEST_TRACEBACK = 100_000
"""Characters; it may quote a stranger, and a maintainer prints it."""

ALL_TRACEBACKS = 10 << 20
"""Bytes that are kept; beyond them the oldest ones go."""


def noted(traceback: str) -> str:
    """Write a traceback into a file, and say where, for whoever runs the command.

    It goes into the cache folder, or into a temporary one if that fails. On a full disk it is
    lost, which is said.
    """
    why = ""
    for folder in (_in_the_cache, _temporary):
        try:
            return f"What a maintainer needs is in {_written(folder(), traceback)}"
        except OSError as fault:
            why = fault.strerror or "it cannot be written"
        except GraderError as fault:
            why = str(fault)
    return f"What a maintainer needs could not be kept: {why}"


def _in_the_cache() -> Path:
    folder = cache_folder() / "faults"
    folder.mkdir(mode=0o700, exist_ok=True)
    drop_oldest(folder, ALL_TRACEBACKS)
    return folder


def _temporary() -> Path:
    return Path(tempfile.gettempdir())


def _written(folder: Path, text: str) -> Path:
    handle, name = tempfile.mkstemp(prefix="fault-", suffix=".txt", dir=folder)
    path = Path(name)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", errors="backslashreplace") as file:
            file.write(printable(text, LONGEST_TRACEBACK))
    except OSError:
        path.unlink()
        raise
    return path
