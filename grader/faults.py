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

    It goes into the cache folder, or into a temporary one if that fails.
    """
    return f"What a maintainer needs is in {_kept(traceback)}"


def _kept(text: str) -> Path:
    try:
        folder = cache_folder() / "faults"
        folder.mkdir(mode=0o700, exist_ok=True)
        drop_oldest(folder, ALL_TRACEBACKS)
    except (GraderError, OSError):
        folder = Path(tempfile.gettempdir())
    handle, name = tempfile.mkstemp(prefix="fault-", suffix=".txt", dir=folder)
    with os.fdopen(handle, "w", encoding="utf-8", errors="backslashreplace") as file:
        file.write(printable(text, LONGEST_TRACEBACK))
    return Path(name)
