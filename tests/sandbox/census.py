"""Counts processes: which are there, which are left, which nobody reaped."""

import os
import subprocess
import time
from pathlib import Path


def _words(pid: Path, name: str) -> bytes:
    try:
        return (pid / name).read_bytes()
    except OSError:
        return b""


def _all() -> list[Path]:
    return [path for path in Path("/proc").iterdir() if path.name.isdigit()]


def with_word(word: str) -> set[int]:
    """Processes that live and have a word in their command line."""
    found = {int(pid.name) for pid in _all() if word.encode() in _words(pid, "cmdline")}
    return found - {os.getpid()}


def state_of(pid: int) -> str:
    """Letter of a process's state; empty if there is none."""
    text = _words(Path("/proc") / str(pid), "stat")
    return text.rpartition(b") ")[2][:1].decode()


def zombies() -> set[int]:
    """Children of this process that ended and were not waited for."""
    mine = str(os.getpid()).encode()
    rows = {int(pid.name): _words(pid, "stat").rpartition(b") ")[2].split() for pid in _all()}
    return {pid for pid, row in rows.items() if row[:2] == [b"Z", mine]}


def wait_for_words(process: "subprocess.Popen[bytes]", *words: str) -> set[int]:
    """Wait until a process has all these words in its command line; all that have the first.

    Another process, which should bring that about, must not end before.
    """
    while process.poll() is None:
        found = [with_word(word) for word in words]
        if set.intersection(*found):
            return found[0]
        time.sleep(0.02)
    raise AssertionError(f"ended without a process with {words}: {process.communicate()}")


def all_gone(pids: set[int]) -> bool:
    """Wait until processes have ended; orphans that became ours are reaped on the way."""
    for _ in range(1500):
        for pid in pids:
            try:
                os.waitpid(pid, os.WNOHANG)
            except ChildProcessError:
                continue
        if not [pid for pid in pids if state_of(pid) not in {"", "Z", "X"}]:
            return True
        time.sleep(0.02)
    return False
