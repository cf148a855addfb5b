"""How long did a process stand in line for a processor?

A process that the clock stops was either waiting of its own accord or kept waiting by others.
The kernel counts the second for each thread; nothing inside a box can change that figure.
"""

from collections.abc import Iterator
from pathlib import Path

_PROC = Path("/proc")


def seconds_in_line(pid: int) -> float:
    """Longest time that a thread of a process or of its descendants waited to be run.

    Returns:
        Seconds since the thread began; 0 if the kernel does not tell.
    """
    return max((_waited(thread) for thread in _threads(pid)), default=0.0)


def _threads(pid: int) -> Iterator[Path]:
    """Folders of all threads; a process may end while it is looked at."""
    waiting = [pid]
    while waiting:
        try:
            threads = list((_PROC / str(waiting.pop()) / "task").iterdir())
        except OSError:
            continue
        yield from threads
        for thread in threads:
            try:
                children = (thread / "children").read_text()
            except OSError:
                continue
            waiting += [int(child) for child in children.split()]


def _waited(thread: Path) -> float:
    """Source: the kernel's scheduler/sched-stats, the second figure, in nanoseconds."""
    try:
        return int((thread / "schedstat").read_text().split()[1]) * 1e-9
    except (OSError, IndexError, ValueError):
        return 0.0
