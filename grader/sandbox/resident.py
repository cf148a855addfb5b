"""How much memory does a process hold just now?

A sanitizer maps terabytes before the limit of address space is set, so no limit sees what of
them is filled: that takes a look now and then. Who only reads there fills no page, but tables
of pages: 4 KiB for each 2 MiB.
"""

import re
from pathlib import Path

LOOK_SECONDS = 0.05
"""How often; memory is filled at some gigabytes each second."""

_PROC = Path("/proc")
_HELD = re.compile(rb"^Vm(?:RSS|PTE):\s+(\d+) kB$", re.MULTILINE)


def resident_bytes(pid: int) -> int:
    """Bytes of a process that lie in memory, tables of pages included; 0 if nobody tells.

    A process whose first thread has ended tells nothing of itself; its other threads do.
    Source: the kernel's filesystems/proc, VmRSS and VmPTE in status.
    """
    threads = _PROC / str(pid) / "task"
    try:
        return next(filter(None, map(_held, threads.iterdir())), 0)
    except OSError:
        return 0


def _held(thread: Path) -> int:
    try:
        told = (thread / "status").read_bytes()
    except OSError:
        return 0
    return sum(int(each) for each in _HELD.findall(told)) * 1024
