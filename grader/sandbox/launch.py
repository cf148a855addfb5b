"""How does one process run within limits, and what did it leave behind?

Theory of operation. The child gets its own session, an environment that we spell out, no
standard input, and only the descriptors that we name. One loop watches three things: the two
output pipes and a pidfd of the child. Output beyond the cap is read and dropped, so that a
flood neither blocks the child nor fills our memory. The loop ends when the child ends or its
time is over, never when the pipes close: a grandchild may hold them for hours. Then the whole
process group is killed and the child is reaped by wait4, which tells the CPU time that it
used; nothing in the child can forge that.
"""

import os
import selectors
import signal
import subprocess
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from grader.errors import MissingTool

CHUNK = 65536
PIPE_LIMIT = 1 << 20
"""Largest size of a pipe without privileges. Source: fs.pipe-max-size in proc(5)."""

DROPPED = b"\n[...]\n"
PLAIN_ENVIRONMENT = {"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8"}
"""What a child sees of our environment: nothing of the caller's tokens and paths."""


@dataclass(frozen=True, slots=True)
class Order:
    """One process to start, and its bounds."""

    argv: Sequence[str]
    seconds: float
    """Wall time after which the process group is killed."""

    output_bytes: int = 1 << 20
    """How much is kept of each of the two output streams; the middle is dropped."""

    folder: Path | None = None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] | None = None


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a process ended and what it printed; the bytes are hostile."""

    code: int
    """Exit status, or the negative number of the signal that ended it."""

    timed_out: bool
    out: bytes
    err: bytes
    seconds: float
    cpu_seconds: float


class _Stream:
    """One output pipe: keeps the beginning and the end up to a cap, and drops the middle.

    A compiler's first error comes early, a sanitizer's report last.
    """

    def __init__(self, descriptor: int, cap: int) -> None:
        os.set_blocking(descriptor, False)
        self.descriptor = descriptor
        self._half = cap // 2
        self._head = bytearray()
        self._tail = bytearray()
        self._dropped = False

    @property
    def kept(self) -> bytes:
        """What was printed, with a mark where something was dropped."""
        return bytes(self._head) + DROPPED * self._dropped + bytes(self._tail)

    def drain(self) -> int | None:
        """Read what is there; the number of bytes, 0 at the end, None if nothing waits."""
        try:
            chunk = os.read(self.descriptor, CHUNK)
        except BlockingIOError:
            return None
        room = self._half - len(self._head)
        self._head += chunk[:room]
        self._tail += chunk[room:]
        surplus = len(self._tail) - self._half
        if surplus > 0:
            del self._tail[:surplus]
            self._dropped = True
        return len(chunk)


def launch(order: Order) -> Outcome:
    """Run one process to its end or its deadline.

    Raises:
        MissingTool: The program does not exist or may not be started.
    """
    started = time.monotonic()
    try:
        child = subprocess.Popen(
            list(order.argv),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=order.folder,
            env=dict(PLAIN_ENVIRONMENT if order.environment is None else order.environment),
            pass_fds=order.descriptors,
            start_new_session=True,
        )
    except OSError as error:
        message = f"{order.argv[0]} cannot be started: {error.strerror}; is it installed?"
        raise MissingTool(message) from error
    with child:
        try:
            streams = [_Stream(pipe.fileno(), order.output_bytes) for pipe in _pipes(child)]
            timed_out = not _watch(child.pid, streams, started + order.seconds)
        finally:
            code, cpu_seconds = _reap(child)
        for stream in streams:
            _drain_all(stream)
    out, err = (stream.kept for stream in streams)
    return Outcome(code, timed_out, out, err, time.monotonic() - started, cpu_seconds)


def _pipes(child: subprocess.Popen[bytes]) -> list[IO[bytes]]:
    return [pipe for pipe in (child.stdout, child.stderr) if pipe is not None]


def _watch(pid: int, streams: list[_Stream], deadline: float) -> bool:
    """Drain the pipes until the child ends; False if the deadline came first."""
    pidfd = os.pidfd_open(pid)
    try:
        with selectors.DefaultSelector() as selector:
            selector.register(pidfd, selectors.EVENT_READ)
            for stream in streams:
                selector.register(stream.descriptor, selectors.EVENT_READ, stream)
            while (left := deadline - time.monotonic()) > 0:
                for key, _ in selector.select(left):
                    if key.data is None:
                        return True
                    if key.data.drain() == 0:
                        selector.unregister(key.fd)
            return False
    finally:
        os.close(pidfd)


def _reap(child: subprocess.Popen[bytes]) -> tuple[int, float]:
    """Kill what is left of the process group; exit code and CPU seconds of the child."""
    # The child still holds its process id as a zombie, so the group cannot be a stranger's.
    os.killpg(child.pid, signal.SIGKILL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, usage.ru_utime + usage.ru_stime


def _drain_all(stream: _Stream) -> None:
    """Take what the dead child left in the pipe, and no more than a pipe can hold.

    A process that left the group may still write, as fast as this reads.
    """
    for _ in range(PIPE_LIMIT // CHUNK):
        if not stream.drain():
            return
