"""How does a process end for certain, with all that it started, and what did it use?

The grader adopts orphans (PR_SET_CHILD_SUBREAPER). So the first process of a namespace becomes
our child when bubblewrap ends, and once it is reaped the kernel has removed every process of
that namespace: nothing inside can outlive that. It also has the CPU time of all processes that
ended before; the time of those that were killed with it is lost.
"""

import ctypes
import os
import re
import select
import signal
import subprocess
from contextlib import suppress
from functools import cache

from grader.errors import WorkerFault

PR_SET_CHILD_SUBREAPER = 36
PATIENCE_SECONDS = 30.0
"""A killed process that is still there after this is stuck in the kernel."""

_REPORT = re.compile(rb'"child-pid"\s*:\s*(\d{1,10})')


def adopt_orphans() -> None:
    """Make orphaned descendants children of this process, from now on."""
    _adopt_orphans_of(os.getpid())


@cache
def _adopt_orphans_of(pid: int) -> None:
    """For each process anew: a fork knows what its parent has called, but has not its right."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def reap(child: subprocess.Popen[bytes], report: int | None) -> tuple[int, float]:
    """Kill a child and everything that it started.

    Args:
        child: Leader of a process group of its own.
        report: Read end of the pipe into which bubblewrap wrote the number of its namespace's
            first process, before it ran anything foreign; None for any other program.

    Returns:
        Exit code, negative for a signal, and the CPU seconds of all of them.

    Raises:
        WorkerFault: A process does not end although it was killed.
    """
    # The child still holds its process id as a zombie, so the group cannot be a stranger's.
    os.killpg(child.pid, signal.SIGKILL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    seconds = usage.ru_utime + usage.ru_stime
    first = _first_process(report)
    if first:
        seconds += _reap_one(first)
    while rest := _reap_orphan(child.pid):
        seconds += rest
    return child.returncode, seconds


def _first_process(report: int | None) -> int:
    if report is None:
        return 0
    os.set_blocking(report, False)
    try:
        found = _REPORT.search(os.read(report, 4096))
    except BlockingIOError:
        return 0
    return int(found.group(1)) if found else 0


def _reap_one(pid: int) -> float:
    """End a namespace with its first process.

    The end of bubblewrap does so only if it came after its child had asked for that.
    """
    try:
        pidfd = os.pidfd_open(pid)
    except ProcessLookupError:
        return 0.0
    try:
        # Fails if it is not our child: the number may be a stranger's by now.
        os.waitid(os.P_PIDFD, pidfd, os.WEXITED | os.WNOHANG | os.WNOWAIT)
        with suppress(ProcessLookupError):
            signal.pidfd_send_signal(pidfd, signal.SIGKILL)
        if not select.select([pidfd], [], [], PATIENCE_SECONDS)[0]:
            message = f"process {pid} of a submission does not end although it was killed"
            raise WorkerFault(message)
        _, _, usage = os.wait4(pid, 0)
    except ChildProcessError:
        # Bubblewrap has waited for it and added its time to its own.
        return 0.0
    finally:
        os.close(pidfd)
    return usage.ru_utime + usage.ru_stime


def _reap_orphan(group: int) -> float:
    """Reap one more process of a killed group that has become ours; 0 if there is none."""
    try:
        _, _, usage = os.wait4(-group, 0)
    except ChildProcessError:
        return 0.0
    return max(usage.ru_utime + usage.ru_stime, 1e-9)
