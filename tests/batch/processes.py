"""What do the processes of this machine take? Read from `/proc`, for tests and measurements."""

import os
from collections.abc import Iterable
from pathlib import Path

PROC = Path("/proc")


def descendants(pid: int) -> list[int]:
    """Name all that a process started, directly or not."""
    found: list[int] = []
    waiting = [pid]
    while waiting:
        for thread in _listed(PROC / str(waiting.pop()) / "task"):
            children = [int(child) for child in _text(thread / "children").split()]
            found += children
            waiting += children
    return found


def named(word: str, pids: Iterable[int]) -> list[int]:
    """Keep those that were started with a word in their command."""
    return [pid for pid in pids if word in _text(PROC / str(pid) / "cmdline").split("\0")]


def memory_peak(pid: int) -> float:
    """Most MiB that a process had so far; 0 if it is gone."""
    return _mib(pid, "status", "VmHWM")


def memory_sum(pids: Iterable[int]) -> float:
    """MiB of several processes now, each page counted once among those that share it."""
    return sum(_mib(pid, "smaps_rollup", "Pss") for pid in pids)


def cpu_seconds(pid: int) -> float:
    """CPU time of a process, without that of others that it started; 0 if it is gone."""
    fields = _text(PROC / str(pid) / "stat").rpartition(")")[2].split()
    return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK") if fields else 0.0


def _mib(pid: int, name: str, key: str) -> float:
    for line in _text(PROC / str(pid) / name).splitlines():
        if line.startswith(f"{key}:"):
            return int(line.split()[1]) / 1024
    return 0.0


def _listed(folder: Path) -> list[Path]:
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _text(path: Path) -> str:
    """Read a file of a process that may end meanwhile."""
    try:
        return path.read_text(errors="replace")
    except OSError:
        return ""
