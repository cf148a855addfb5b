"""How does one box, in which a process waits, run one target after the other?

The grader gives each request output pipes of its own and watches them and the socket. The
number of a copy, as this machine has it, comes from the kernel with its first message. Whoever
waits in the box ends the copy, which is its child: so the CPU time is told in every case. If no
answer comes, the whole box is ended.
"""

import selectors
import socket
import subprocess
import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack, nullcontext, suppress
from dataclasses import dataclass
from pathlib import Path
from struct import Struct
from typing import IO, NoReturn

from grader.errors import GraderError, Interrupted, WorkerFault
from grader.sandbox import bubblewrap
from grader.sandbox.box import BUBBLES, Box, Isolation
from grader.sandbox.delay import seconds_in_line
from grader.sandbox.inside import channel
from grader.sandbox.launch import (
    GLANCE_SECONDS,
    PLAIN_ENVIRONMENT,
    Order,
    Outcome,
    finish,
    is_stopped,
)
from grader.sandbox.resident import LOOK_SECONDS, resident_bytes
from grader.sandbox.slots import settled
from grader.sandbox.streams import Stream, pipe
from grader.sandbox.target import START_SECONDS, Target
from grader.sandbox.words import specification

END_SECONDS = 30.0
"""A copy that is still there so long after it was killed is stuck in the kernel."""

_CREDENTIALS = Struct("3i")
"""The kernel's struct ucred: process, user, group."""

_KILLED = -9

Starter = Callable[[Order], subprocess.Popen[bytes]]


class NotReached(GraderError):
    """Our own part failed before anything foreign ran, for the reason in the text."""


class BoxLost(GraderError):
    """The box ended while a target ran in it, which a target cannot bring about by itself."""

    def __init__(self, outcome: Outcome) -> None:
        """Keep what is known of the target."""
        super().__init__("the box of a process was ended from outside")
        self.outcome = outcome


@dataclass(slots=True)
class _Case:
    """One target in a box, as far as it has come."""

    begun: float
    deadline: float
    glance: float
    """When it is looked at next."""

    pid: int = 0
    """Number of the copy on this machine, once it is ready."""

    delayed: float = 0.0
    enough: bool = False  # somebody wants it to end
    exhausted: bool = False
    """Whether it held more memory than it may."""

    stopped: bool = False
    """Whether its time was over, or its memory."""


class KeptBox:
    """A box in which a process waits; use it from one thread at a time."""

    def __init__(
        self, target: Target, box: Box, entry: Path, isolation: Isolation, start: Starter
    ) -> None:
        """Start it.

        Args:
            target: Its program, folder and environment are those of all targets of the box.
            box: What they may see, write and use; the limit of CPU time is each one's own.
            entry: The staged start.py.
            isolation: The level.
            start: Starts a process from a thread that lives as long as the box: the kernel
                ends it with that thread.

        Raises:
            NotReached: It did not come to wait.
            MissingTool: The interpreter or bubblewrap cannot be started.
            WorkerFault: There is no user for it.
            Interrupted: The grader is being stopped.
        """
        self._held = ExitStack()
        try:
            level = self._held.enter_context(settled(box, isolation))
            self._control, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            self._held.enter_context(self._control)
            with theirs:
                self._control.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1)
                order = _order(target, box, entry, level, theirs.fileno())
                bubble = isolation.level in BUBBLES
                wrapped = (
                    bubblewrap.wrapped(order, box, level) if bubble else nullcontext(order)
                )
                order = self._held.enter_context(wrapped)
                self._child = start(order)
            self._held.enter_context(self._child)
            self._held.callback(finish, self._child, order.report)
            self._words = [Stream(pipe.fileno(), 4096) for pipe in _pipes(self._child)]
            self._greeted()
        except BaseException:
            self.close()
            raise
        self.alive = True
        """Whether it can take another target."""

    def close(self) -> None:
        """End everything in it.

        Raises:
            WorkerFault: A process does not end although it was killed.
        """
        self.alive = False
        self._held.close()

    def run(self, target: Target, cpu_seconds: int) -> Outcome:
        """Run a target.

        Raises:
            NotReached: Our own part failed before the target began.
            BoxLost: Somebody ended the box, and the target with it.
            WorkerFault: It does not end although it was killed.
        """
        with pipe() as out, pipe() as err:
            streams = [Stream(pipe.read, target.output_bytes) for pipe in (out, err)]
            data = channel.request(cpu_seconds, list(target.arguments))
            files = (out.write, err.write, *target.descriptors)
            try:
                socket.send_fds(self._control, [data], files)
            except OSError:
                self._lost("it is gone")
            out.close_write()
            err.close_write()
            begun = time.monotonic()
            case = _Case(begun, begun + START_SECONDS, begun + GLANCE_SECONDS)
            code, seconds = self._watch(case, target, streams)
            lasted = time.monotonic() - case.begun
            for stream in streams:
                stream.drain_all()
        kept = [stream.kept for stream in streams]
        if not case.pid:
            raise NotReached(kept[1].decode(errors="replace").strip()[-500:])
        # Its end may have crossed the word that its time was over.
        stopped = case.stopped and code == _KILLED
        timed_out, exhausted = stopped and not case.exhausted, stopped and case.exhausted
        ended = Outcome(
            code, timed_out, kept[0], kept[1], lasted, seconds, case.delayed, exhausted
        )
        if not self.alive:
            raise BoxLost(ended)
        return ended

    def _watch(
        self, case: _Case, target: Target, streams: Sequence[Stream]
    ) -> tuple[int, float]:
        """Drain the pipes until the copy ends; its exit code and CPU seconds."""
        with selectors.DefaultSelector() as selector:
            selector.register(self._control, selectors.EVENT_READ)
            for stream in streams:
                selector.register(stream.descriptor, selectors.EVENT_READ, stream)
            if target.until is not None:
                selector.register(target.until, selectors.EVENT_READ, case)
            while True:
                for key, _ in selector.select(self._next_look(case, target)):
                    if key.data is None:
                        if (ended := self._heard(case, target)) is not None:
                            return ended
                    elif _is_over(key.data):
                        selector.unregister(key.fd)

    def _next_look(self, case: _Case, target: Target) -> float:
        """Look at a copy now and then, and stop it in time; seconds until the next look."""
        now, limit = time.monotonic(), target.resident_bytes
        runs = case.pid and not case.stopped
        if runs and limit:
            case.exhausted = resident_bytes(case.pid) > limit
        if now >= case.deadline or (runs and (case.enough or case.exhausted)):
            self._stop(case)
        elif now >= case.glance and case.pid:
            case.delayed = max(case.delayed, seconds_in_line(case.pid))
            case.glance = now + GLANCE_SECONDS
        return max(0.0, min(case.deadline - now, LOOK_SECONDS if limit else GLANCE_SECONDS))

    def _stop(self, case: _Case) -> None:
        """Have a copy ended whose time is over, or whose memory."""
        if not case.pid:
            self._lost("its process did not begin in time")
        if case.stopped:
            raise WorkerFault("a process of a submission does not end although it was killed")
        case.delayed = max(case.delayed, seconds_in_line(case.pid))
        case.stopped, case.deadline = True, time.monotonic() + END_SECONDS
        with suppress(OSError):
            self._control.send(channel.STOP)

    def _heard(self, case: _Case, target: Target) -> tuple[int, float] | None:
        """Take a message; exit code and CPU seconds if it says that the copy has ended."""
        data, pid = self._receive()
        if data == channel.READY:
            case.pid, case.begun = pid, time.monotonic()
            case.deadline = case.begun + target.seconds
            return None
        if data:
            return channel.read_end(data)
        if not case.pid:
            self._lost("it ended")
        # Whoever ended the box, a copy that ran was ended with it.
        self.alive = False
        return _KILLED, 0.0

    def _greeted(self) -> None:
        self._control.settimeout(START_SECONDS)
        try:
            data, _ = self._receive()
        except TimeoutError:
            data = b""
        if data != channel.HERE:
            self._lost("no process came to wait in it")
        self._control.settimeout(None)

    def _receive(self) -> tuple[bytes, int]:
        """A message and the number of the process that sent it; empty if the box is gone."""
        room = socket.CMSG_SPACE(_CREDENTIALS.size)
        try:
            data, ancillary, _, _ = self._control.recvmsg(256, room)
        except ConnectionError:
            return b"", 0
        for level, kind, held in ancillary:
            if (level, kind) == (socket.SOL_SOCKET, socket.SCM_CREDENTIALS):
                return data, _CREDENTIALS.unpack(held)[0]
        return data, 0

    def _lost(self, why: str) -> NoReturn:
        """Say what the box itself said last, after its end."""
        self.alive = False
        for stream in self._words:
            stream.drain_all()
        if is_stopped():
            raise Interrupted("the grader was asked to stop")
        said = self._words[-1].kept.decode(errors="replace").strip()[-500:]
        raise NotReached(said or why)


def _is_over(source: Stream | _Case) -> bool:
    """Read a pipe, or take note that a case is to end; whether there is no more to come."""
    if isinstance(source, _Case):
        source.enough = True
    return isinstance(source, _Case) or source.drain() == 0


def _order(target: Target, box: Box, entry: Path, isolation: Isolation, control: int) -> Order:
    """Word how the process that waits is started."""
    spec = [*specification(box, isolation, waits=True), f"ready={control}", "keep="]
    command = [str(isolation.interpreter), "-I", "-S", str(entry), *spec, "--"]
    return Order(
        [*command, target.program],
        START_SECONDS,
        folder=target.folder or Path("/"),
        descriptors=(control,),
        environment={**PLAIN_ENVIRONMENT, **(target.environment or {})},
    )


def _pipes(child: subprocess.Popen[bytes]) -> Sequence[IO[bytes]]:
    return [pipe for pipe in (child.stdout, child.stderr) if pipe is not None]
