"""How does a process forbid itself every file that it does not name?

Landlock's calls have the same numbers on every architecture. What a kernel does not know yet
is left out of what it is asked to handle; the filter of system calls covers the rest.
Source: the kernel's userspace-api/landlock; linux/landlock.h.
"""

from __future__ import annotations

import ctypes
import os

# A constant that type checkers know: `collections` would cost every box 3 ms.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

CREATE, ADD_RULE, RESTRICT = 444, 445, 446
VERSION_FLAG = 1
PATH_BENEATH = 1

EXECUTE, WRITE_FILE, READ_FILE, READ_DIR, REMOVE_FILE = 1, 2, 4, 8, 1 << 5
MAKE_REG, TRUNCATE = 1 << 8, 1 << 14
READ = READ_FILE
RUN = READ_FILE | READ_DIR | EXECUTE
OWN = READ_FILE | READ_DIR | WRITE_FILE | REMOVE_FILE | MAKE_REG | TRUNCATE
_OF_FILES = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE
_FILE_RIGHTS = (0, 13, 14, 15, 15, 16)
"""How many rights to files the versions 0 to 5 know."""

_TCP = 0b11
_SCOPES = 0b11
"""No abstract sockets and no signals to anyone outside."""


class Ruleset(ctypes.Structure):
    """The kernel's struct landlock_ruleset_attr of version 6."""

    _fields_ = (
        ("files", ctypes.c_uint64),
        ("network", ctypes.c_uint64),
        ("scopes", ctypes.c_uint64),
    )


class Beneath(ctypes.Structure):
    """The kernel's struct landlock_path_beneath_attr."""

    _layout_ = "ms"
    _pack_ = 1
    _fields_ = (("allowed", ctypes.c_uint64), ("parent", ctypes.c_int32))


def version(library: ctypes.CDLL) -> int:
    """Ask which version the kernel speaks; 0 for none."""
    return max(0, int(library.syscall(CREATE, None, ctypes.c_size_t(0), VERSION_FLAG)))


def restrict(library: ctypes.CDLL, rules: Iterable[tuple[int, str]]) -> None:
    """Allow these rights below these paths and nothing else; missing paths are left out.

    Raises:
        OSError: The kernel refuses.
    """
    known = version(library)
    files = (1 << _FILE_RIGHTS[min(known, 5)]) - 1
    ruleset = Ruleset(files, _TCP if known >= 4 else 0, _SCOPES if known >= 6 else 0)
    size = 24 if known >= 6 else 16 if known >= 4 else 8
    handle = _called(library, CREATE, ctypes.byref(ruleset), ctypes.c_size_t(size), 0)
    for allowed, path in rules:
        try:
            parent = os.open(path, os.O_PATH | os.O_CLOEXEC)
        except FileNotFoundError:
            continue
        if not os.path.isdir(path):  # noqa: PTH112 - pathlib costs 8 ms
            allowed &= _OF_FILES
        rule = Beneath(allowed & files, parent)
        _called(library, ADD_RULE, handle, PATH_BENEATH, ctypes.byref(rule), 0)
        os.close(parent)
    _called(library, RESTRICT, handle, 0)
    os.close(handle)


def _called(library: ctypes.CDLL, number: int, *arguments: object) -> int:
    result = int(library.syscall(number, *arguments))
    if result < 0:
        code = ctypes.get_errno()
        raise OSError(code, f"landlock {number}: {os.strerror(code)}")
    return result
