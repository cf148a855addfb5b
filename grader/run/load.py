"""Was the machine busy with something else while a submission ran?

A submission that the clock stopped, and not its own CPU time, was either waiting of its
own accord or kept waiting by others. Only the first is its fault. What others use cannot be
forged from inside a box: it is what the machine did, less what the grader and its children did.
"""

import os
import resource
import time

CROWDED = 0.5
"""Share of the machine's time that others may take before a stop by the clock is our fault.

A worker gets three times its CPU time by the clock, so with less than that it has had its time.
"""

_BUSY = (0, 1, 2, 5, 6, 7)
"""Fields of a processor's line that are work: user, nice, system, interrupts, steal.

Source: proc_stat(5).
"""


class MachineLoad:
    """What the machine has done since a moment."""

    def __init__(self) -> None:
        self._wall = time.monotonic()
        self._busy = _machine_seconds()
        self._own = _own_seconds()

    def others(self) -> float:
        """Share of all processors' time that went to others; 0 if the kernel does not tell."""
        elapsed = (time.monotonic() - self._wall) * (os.cpu_count() or 1)
        busy = _machine_seconds() - self._busy
        own = _own_seconds() - self._own
        return max(0.0, busy - own) / elapsed if elapsed > 0 else 0.0

    def crowded(self) -> bool:
        """Others took so much that waiting proves nothing."""
        return self.others() > CROWDED


def _machine_seconds() -> float:
    """CPU seconds that all processors have worked since the machine started."""
    try:
        with open("/proc/stat", encoding="ascii") as file:  # noqa: PTH123 - one line of a special file
            fields = file.readline().split()[1:]
    except OSError:
        return 0.0
    return sum(int(fields[k]) for k in _BUSY) / os.sysconf("SC_CLK_TCK")


def _own_seconds() -> float:
    """CPU seconds of this process and of all children that were waited for."""
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in used)
