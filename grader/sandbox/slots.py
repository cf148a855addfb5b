"""Which user is a confined process, when the grader is root?

One user for each process that runs at the same time, so that none can signal another and the
kernel counts each one's threads alone. A lock on a file of ours keeps a number for one process
of one grader; it ends with the descriptor, however the grader ends. The file is empty if it
ended well. If it did not, processes of that user may have outlived it: without namespaces a
compiler's children do. They would count against whoever gets the number next, so they are
killed first.
"""

import fcntl
import os
import re
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

from grader.errors import WorkerFault
from grader.resources import is_root
from grader.sandbox.box import Box, Isolation, Level

FIRST_UID = 60800
"""In a range that neither Debian nor systemd assigns. Source: systemd's UIDS-GIDS document."""

SLOTS = 256
FOLDER = Path("/run/bvhgrade")
PATIENCE_SECONDS = 2.0
"""How long killed processes may take to be gone; after that another number is taken."""

_UID = re.compile(r"^Uid:\t(\d+)", re.MULTILINE)
_STATE = re.compile(r"^State:\t(\w)", re.MULTILINE)


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
        os.pwrite(lock, b"in use", 0)
        yield FIRST_UID + slot
        os.ftruncate(lock, 0)
    finally:
        os.close(lock)


@contextmanager
def settled(box: Box, isolation: Isolation) -> Iterator[Isolation]:
    """Give a box a user of its own, and the folder that it may write to; the level with both.

    Raises:
        WorkerFault: There is no user for it.
    """
    with own_user() as slot:
        uid = slot if isolation.level is not Level.NONE else 0
        if box.writable and uid:
            # Still empty, and in a folder that only we can change: nothing can be a link.
            os.chown(box.writable, uid, uid, follow_symlinks=False)
        yield replace(isolation, uid=uid)


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
            if os.fstat(lock).st_size == 0 or _ended(FIRST_UID + slot):
                return slot, lock
            os.close(lock)
    except OSError as fault:
        message = f"{FOLDER}: {fault.strerror}, but the users of submissions are kept there"
        raise WorkerFault(message) from fault
    message = f"all {SLOTS} users for submissions are in use; grade fewer at a time"
    raise WorkerFault(message)


def _ended(uid: int) -> bool:
    """End every process of a user; tells whether none is left.

    One that has ended counts until its parent takes note. If that is us, because we adopted
    it, we do; else nobody knows when it will be, and another number is there at once.
    """
    deadline = time.monotonic() + PATIENCE_SECONDS
    while left := _processes_of(uid):
        running = [pid for pid, is_zombie in left.items() if not is_zombie]
        adopted = [pid for pid, is_zombie in left.items() if is_zombie and _reaped(pid)]
        if not (running or adopted) or time.monotonic() > deadline:
            return False
        for pid in running:
            _kill(pid, uid)
        if not adopted:
            time.sleep(0.01)
    return True


def _processes_of(uid: int) -> dict[int, bool]:
    """Processes of a user, and whether each has ended already."""
    numbers = [int(entry.name) for entry in os.scandir("/proc") if entry.name.isdecimal()]
    facts = {pid: _user_and_state(pid) for pid in numbers}
    return {pid: state == "Z" for pid, (user, state) in facts.items() if user == uid}


def _user_and_state(pid: int) -> tuple[int, str]:
    """Real user id of a process and the letter of its state; -1 and nothing if it is gone."""
    try:
        text = Path(f"/proc/{pid}/status").read_text(errors="replace")
    except OSError:
        return -1, ""
    user, state = _UID.search(text), _STATE.search(text)
    return (int(user[1]), state[1]) if user and state else (-1, "")


def _reaped(pid: int) -> bool:
    """Take note of the end of a process, if it is our child."""
    try:
        return os.waitpid(pid, os.WNOHANG)[0] == pid
    except ChildProcessError:
        return False


def _kill(pid: int, uid: int) -> None:
    with suppress(ProcessLookupError):
        handle = os.pidfd_open(pid)
        try:
            # The number may have become a stranger's since it was read.
            if _user_and_state(pid)[0] == uid:
                signal.pidfd_send_signal(handle, signal.SIGKILL)
        finally:
            os.close(handle)
