"""How does one process run within limits, and what did it leave behind?

Theory of operation. The child gets its own session, an environment that we spell out, no
standard input, and only the descriptors that we name. One loop watches three things: the two
output pipes and a pidfd of the child. Output beyond the cap is read and dropped, so that a
flood neither blocks the child nor fills our memory. The loop ends when the child ends or its
time is over, never when the pipes close: a grandchild may hold them for hours. Then everything
that was started is killed and reaped, which tells the CPU time that it used.
"""

import os
import selectors
import signal
import subprocess
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from grader.errors import Interrupted, MissingTool
from grader.sandbox.delay import seconds_in_line
from grader.sandbox.reaping import adopt_orphans, reap
from grader.sandbox.streams import Stream

GLANCE_SECONDS = 0.5
"""How often a process that takes long is looked at."""

PLAIN_ENVIRONMENT = {"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8"}
"""What a child sees of our environment: nothing of the caller's tokens and paths."""


@dataclass(frozen=True, slots=True)
class Order:
    """One process to start, and its bounds."""

    argv: Sequence[str]
    seconds: float
    """Wall time after which everything that was started is killed."""

    output_bytes: int = 1 << 20
    """How much is kept of each of the two output streams; the middle is dropped."""

    folder: Path | None = None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] | None = None
    uid: int = 0
    """User and group to become before the program starts; 0 to stay."""

    report: int | None = None
    """Read end of the pipe that bubblewrap reports to."""


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
    delayed_seconds: float = 0.0
    """How long it stood in line for a processor, as far as that was seen."""

    exhausted: bool = False
    """Whether it was ended because it held more memory than it may."""


class _Running:
    """Children that live now, so that an interrupted grader can end them all at once."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._children: set[int] = set()
        self._stopped = threading.Event()

    def start(self, order: Order) -> subprocess.Popen[bytes]:
        """Start a child, and end it again if the grader is stopped meanwhile.

        Raises:
            MissingTool: The program does not exist or may not be started.
            Interrupted: The grader is being stopped.
        """
        with self._lock:
            if self._stopped.is_set():
                raise Interrupted("the grader was asked to stop")
            child = _start(order)
            self._children.add(child.pid)
            if self._stopped.is_set():
                # The signal came while the child was being started.
                self.stop()
            return child

    def forget(self, child: subprocess.Popen[bytes]) -> None:
        # Before it is reaped: afterwards the number may be a stranger's.
        with self._lock:
            self._children.discard(child.pid)

    def is_stopped(self) -> bool:
        return self._stopped.is_set()

    def again(self) -> None:
        self._stopped.clear()

    def stop(self) -> None:
        self._stopped.set()
        # Without the lock: this runs in a signal handler, whose thread may hold it.
        for pid in tuple(self._children):
            with suppress(ProcessLookupError):
                os.killpg(pid, signal.SIGKILL)


_running = _Running()


def stop_everything() -> None:
    """End every process that was started, and start no more; safe in a signal handler."""
    _running.stop()


def is_stopped() -> bool:
    """Whether everything was ended by `stop_everything`."""
    return _running.is_stopped()


def start_again() -> None:
    """Let processes be started after `stop_everything`, once all that it ended is gone."""
    _running.again()


def launch(order: Order) -> Outcome:
    """Run one process to its end or its deadline.

    Raises:
        MissingTool: The program does not exist or may not be started.
        Interrupted: The grader is being stopped.
        WorkerFault: A process cannot be ended.
    """
    started = time.monotonic()
    child = begin(order)
    with child:
        try:
            streams = [Stream(pipe.fileno(), order.output_bytes) for pipe in _pipes(child)]
            finished, delayed = _watch(child.pid, streams, started + order.seconds)
        finally:
            code, cpu_seconds = finish(child, order.report)
        for stream in streams:
            stream.drain_all()
    out, err = (stream.kept for stream in streams)
    seconds = time.monotonic() - started
    return Outcome(code, not finished, out, err, seconds, cpu_seconds, delayed)


def begin(order: Order) -> subprocess.Popen[bytes]:
    """Start one process; whoever does has to `finish` it.

    Raises:
        MissingTool: The program does not exist or may not be started.
        Interrupted: The grader is being stopped.
    """
    adopt_orphans()
    return _running.start(order)


def finish(child: subprocess.Popen[bytes], report: int | None) -> tuple[int, float]:
    """Kill a process and everything that it started; see `reap`."""
    _running.forget(child)
    return reap(child, report)


def _start(order: Order) -> subprocess.Popen[bytes]:
    user = order.uid or None
    try:
        return subprocess.Popen(
            list(order.argv),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=order.folder,
            env=dict(PLAIN_ENVIRONMENT if order.environment is None else order.environment),
            pass_fds=order.descriptors,
            start_new_session=True,
            user=user,
            group=user,
            extra_groups=[] if user else None,
            umask=0o077 if user else -1,
        )
    except OSError as error:
        message = f"{order.argv[0]} cannot be started: {error.strerror}; is it installed?"
        raise MissingTool(message) from error


def _pipes(child: subprocess.Popen[bytes]) -> list[IO[bytes]]:
    return [pipe for pipe in (child.stdout, child.stderr) if pipe is not None]


def _watch(pid: int, streams: list[Stream], deadline: float) -> tuple[bool, float]:
    """Drain the pipes until the child ends or the deadline comes.

    Returns:
        Whether it ended in time, and how long it was seen to stand in line.
    """
    delayed, glance = 0.0, time.monotonic() + GLANCE_SECONDS
    pidfd = os.pidfd_open(pid)
    try:
        with selectors.DefaultSelector() as selector:
            selector.register(pidfd, selectors.EVENT_READ)
            for stream in streams:
                selector.register(stream.descriptor, selectors.EVENT_READ, stream)
            while (left := deadline - time.monotonic()) > 0:
                if time.monotonic() >= glance:
                    delayed = max(delayed, seconds_in_line(pid))
                    glance = time.monotonic() + GLANCE_SECONDS
                for key, _ in selector.select(min(left, GLANCE_SECONDS)):
                    if key.data is None:
                        return True, delayed
                    if key.data.drain() == 0:
                        selector.unregister(key.fd)
            return False, max(delayed, seconds_in_line(pid))
    finally:
        os.close(pidfd)
