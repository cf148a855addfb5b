"""How is a file of ours read that somebody could have changed? Strictly, through no link."""

import math
import os
import stat
from pathlib import Path

from grader.errors import UsageError

_READ = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


def read_plain(path: Path, most: int) -> bytes:
    """Read a plain file of the size that it may have.

    Raises:
        UsageError: It is none, or cannot be read.
    """
    try:
        with open(os.open(path, _READ), "rb") as file:  # noqa: PTH123 - a descriptor, not a path
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise damaged(path, "it is not a file")
            data = file.read(most + 1)
    except OSError as fault:
        raise damaged(path, fault.strerror or "it cannot be read") from fault
    if len(data) > most:
        raise damaged(path, f"it has more than {most:,} bytes")
    return data


def finite(text: str) -> float:
    """Read a number; Python takes `1e999` for infinity.

    Raises:
        ValueError: It is no finite one.
    """
    return float(text) if math.isfinite(float(text)) else refuse(text)


def refuse(name: str) -> float:
    """Refuse what Python takes for a number, and JSON does not.

    Raises:
        ValueError: Always.
    """
    raise ValueError(f"{name} is no number")


def damaged(path: Path | str, reason: str) -> UsageError:
    """Word that a file is not what the grader wrote."""
    return UsageError(f"{path}: {reason}; grade this submission again")
