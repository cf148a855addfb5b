"""Which user is a confined process, when the grader is root?

One user for each process that runs at the same time, so that none can signal another and the
kernel counts each one's threads alone. A lock on a file of ours keeps a number for one process
of one grader; it ends with the descriptor, however the grader ends.
"""

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from grader.errors import WorkerFault
from grader.resources import is_root

FIRST_UID = 60800
"""In a range that neither Debian nor systemd assigns. Source: systemd's UIDS-GIDS document."""

SLOTS = 256
FOLDER = Path("/run/bvhgrade")


@contextmanager
def own_user() -> Iterator[int]:
    """A user id that nobody else uses meanwhile; 0 if the grader is not root.

    Raises:
        WorkerFault: The locks cannot be kept, or all are taken.
    """
    if not is_root():
        yield 0
        return
    slot, lock = _free_slot()
    try:
        yield FIRST_UID + slot
    finally:
        os.close(lock)


def _free_slot() -> tuple[int, int]:
    try:
        FOLDER.mkdir(mode=0o700, exist_ok=True)
        for slot in range(SLOTS):
            lock = os.open(FOLDER / str(slot), os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o600)
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                os.close(lock)
                continue
            return slot, lock
    except OSError as fault:
        message = f"{FOLDER}: {fault.strerror}, but the users of submissions are kept there"
        raise WorkerFault(message) from fault
    message = f"all {SLOTS} users for submissions are in use; grade fewer at a time"
    raise WorkerFault(message)
