"""Which Python starts a confined process, and may that process read it?"""

import stat
import sys
from functools import cache
from pathlib import Path

SYSTEM_PYTHON = Path("/usr/bin/python3")


@cache
def own_interpreter() -> Path:
    """The Python that runs the grader, without its virtual environment."""
    return Path(getattr(sys, "_base_executable", sys.executable)).resolve()


def reachable_interpreter() -> Path | None:
    """A Python that every user of this machine can start: our own, else the system's."""
    for path in (own_interpreter(), SYSTEM_PYTHON):
        if path.exists() and is_reachable(path.resolve()):
            return path.resolve()
    return None


def libraries_of(interpreter: Path) -> Path:
    """Folder with an interpreter's standard and shared libraries."""
    return interpreter.parent.parent / "lib"


def is_reachable(path: Path) -> bool:
    """Everyone may read this file, or enter this folder, on the whole way to it."""
    try:
        if not path.stat().st_mode & (stat.S_IXOTH if path.is_dir() else stat.S_IROTH):
            return False
        return all(parent.stat().st_mode & stat.S_IXOTH for parent in path.parents)
    except OSError:
        return False
