"""How much memory does a process hold just now?

A sanitizer maps terabytes before the limit of address space is set, so no limit sees what of
them is filled: that takes a look now and then.
"""

import os
from pathlib import Path

LOOK_SECONDS = 0.05
"""How often; memory is filled at some gigabytes each second."""

_PROC = Path("/proc")


def resident_bytes(pid: int) -> int:
    """Bytes of a process that lie in memory; 0 if the kernel does not tell.

    Source: the kernel's filesystems/proc, the second figure of statm, in pages.
    """
    try:
        pages = int((_PROC / str(pid) / "statm").read_text().split()[1])
    except (OSError, IndexError, ValueError):
        return 0
    return pages * os.sysconf("SC_PAGE_SIZE")
