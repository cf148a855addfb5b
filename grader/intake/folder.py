"""What lies in a folder that a stranger filled, while somebody may still be changing it?

Theory of operation: every step is taken from the descriptor of the folder before it and none
through a link, so that a folder which becomes a link between two steps is not entered, and a
file which does is not read. A folder of ten million files costs as much as one of 20,001.
"""

import os
import stat
from collections.abc import Iterator
from functools import partial
from itertools import islice

from grader.intake.candidates import MOST_ENTRIES, NOT_A_FILE, Entry, Fault, is_junk
from grader.plain import as_name

DEEPEST = 16
"""Folders inside folders that are searched."""

_NEVER_WAITING = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC | os.O_NOCTTY


def folder_entries(folder: int, unread: list[OSError], inside: str = "") -> Iterator[Entry]:
    """Everything below a folder in sorted order; hidden folders are named but not entered.

    Args:
        folder: An open descriptor of it.
        unread: Gets what kept us from looking into a folder.
        inside: Where it lies in the first one: empty, or ending with `/`.
    """
    for name, is_folder in _listed(folder):
        path = inside + name
        if not is_folder:
            yield Entry(path, partial(_content, folder, path))
            continue
        yield Entry(path + "/", lambda _: NOT_A_FILE)
        if is_junk(name) or inside.count("/") >= DEEPEST:
            continue
        try:
            below = os.open(name, _NEVER_WAITING | os.O_DIRECTORY, dir_fd=folder)
        except OSError as fault:
            unread.append(_named(fault, path))
            continue
        try:
            yield from folder_entries(below, unread, path + "/")
        finally:
            os.close(below)


def _listed(folder: int) -> list[tuple[str, bool]]:
    """The names in a folder, no more of them than are wanted, and which are folders."""
    with os.scandir(folder) as entries:
        few = islice(entries, MOST_ENTRIES + 1)
        return sorted((entry.name, entry.is_dir(follow_symlinks=False)) for entry in few)


def _content(folder: int, path: str, most: int) -> bytes | Fault:
    try:
        handle = opened(path.rpartition("/")[2], folder)
        if isinstance(handle, Fault):
            return handle
        with os.fdopen(handle, "rb") as file:
            return file.read(most)
    except OSError as fault:
        raise _named(fault, path) from fault


def _named(fault: OSError, path: str) -> OSError:
    return OSError(fault.errno, f"{as_name(path)} in it: {fault.strerror}")


def opened(path: str | os.PathLike[str], folder: int | None = None) -> int | Fault:
    """Open a file or a folder to read, and nothing that is a link or could make us wait.

    It is looked at twice: a device may do something when it is opened, and what was looked at
    may be another thing by then.

    Args:
        path: Where it lies; its last part is not followed.
        folder: Descriptor of the folder to start from.

    Raises:
        OSError: It is not there, or may not be read.
    """
    if not _is_plain(os.stat(path, dir_fd=folder, follow_symlinks=False)):
        return NOT_A_FILE
    handle = os.open(path, _NEVER_WAITING, dir_fd=folder)
    if _is_plain(os.fstat(handle)):
        return handle
    os.close(handle)
    return NOT_A_FILE


def _is_plain(status: os.stat_result) -> bool:
    return stat.S_ISREG(status.st_mode) or stat.S_ISDIR(status.st_mode)
