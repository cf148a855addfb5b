"""A target for boxes of the tests: imports first, then runs lines that a test gives."""

import ctypes
import fcntl
import mmap
import os
import resource
import signal
import socket
import sys
import threading
import time
from collections.abc import Sequence

__all__ = [
    "called",
    "ctypes",
    "fcntl",
    "library",
    "main",
    "mmap",
    "os",
    "resource",
    "signal",
    "socket",
    "sys",
    "threading",
    "time",
]

library = ctypes.CDLL(None, use_errno=True)


def called(number: int, *arguments: object) -> int:
    """Make a system call; its result, or the negative number of its fault."""
    result = int(library.syscall(number, *arguments))
    return result if result >= 0 else -ctypes.get_errno()


def main(arguments: Sequence[str]) -> None:
    """Run lines of Python, which find all these modules."""
    exec(arguments[0], {**globals(), "arguments": arguments[1:]})  # noqa: S102 - a test's own
    sys.stdout.flush()
    os._exit(0)
