"""How do many submissions get graded at once? By clerks: processes of ours, an order at a time.

They run this very program and hold what it holds, so none needs a box; the boxes are theirs.
Not a pool of `concurrent.futures`, which is lost as a whole when one of its processes dies:
here the death of a clerk is news of one order, and the next order gets a new clerk. Each is the
leader of a session, so that Ctrl-C reaches only the office, which knows what to keep. A clerk
whose office is gone, however it ended, sees its socket closed and ends with all its boxes.
"""

import os
import pickle
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import IO, Any, Self

from grader.errors import MissingTool
from grader.plain import printable
from grader.sandbox.letters import Ended, post, received
from grader.sandbox.scratch import scratch_folder

PATIENCE_SECONDS = 10.0
"""How long clerks may take to end their boxes; after that they are killed."""

LAST_WORDS = 2000
"""Characters of what a dead clerk printed that are kept."""


@dataclass(frozen=True, slots=True)
class Told:
    """A clerk says how far it is."""

    ticket: int
    what: Any


@dataclass(frozen=True, slots=True)
class Done:
    """A clerk has finished an order, and its function returned this."""

    ticket: int
    result: Any


@dataclass(frozen=True, slots=True)
class Gone:
    """A clerk died, or was ended because its time was over; nobody knows what it would say."""

    ticket: int
    why: str
    said: str = ""
    """What it printed last: often a traceback, so it is for a maintainer only."""


@dataclass(frozen=True, slots=True)
class Notice:
    """Something that concerns no single order, for whoever waits for all of them."""

    sentence: str


News = Told | Done | Gone | Notice


@dataclass(slots=True)
class _Clerk:
    """One process, and what it works on."""

    child: subprocess.Popen[bytes]
    desk: socket.socket
    words: IO[bytes]
    ticket: int = -1
    """-1 if it is free."""

    deadline: float = 0.0


class Office:
    """Clerks that do one order after the other; all end with the block that it heads."""

    def __init__(self, entry: str, size: int, seconds: float) -> None:
        """Start nothing yet.

        Args:
            entry: Module and function that does an order, `package.module:function`; it takes
                the order, and a function to which it may say how far it is.
            size: How many clerks at most.
            seconds: Wall time of an order after which something is wrong with the clerk.
        """
        self._entry, self._size, self._seconds = entry, size, seconds
        self._clerks: list[_Clerk] = []
        self._selector = selectors.DefaultSelector()
        # A killed clerk leaves its files behind; here they go with the office.
        self._scratch = scratch_folder()

    def __enter__(self) -> Self:
        """Begin the block."""
        self._folder = self._scratch.__enter__()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        fault: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End every clerk, with all that it started."""
        try:
            for clerk in self._clerks:
                clerk.desk.close()
            deadline = time.monotonic() + PATIENCE_SECONDS
            for clerk in self._clerks:
                _end(clerk, max(0.0, deadline - time.monotonic()))
                clerk.words.close()
            self._selector.close()
        finally:
            self._scratch.__exit__(kind, fault, trace)

    @property
    def is_full(self) -> bool:
        """Every clerk has an order."""
        return self.busy >= self._size

    @property
    def busy(self) -> int:
        """How many orders are being done."""
        return sum(clerk.ticket >= 0 for clerk in self._clerks)

    def give(self, ticket: int, order: Any) -> None:  # noqa: ANN401 - whatever the entry takes
        """Let a free clerk do an order, or a new one if none waits.

        Args:
            ticket: What the news of it are known by.
            order: Anything that can be pickled.

        Raises:
            MissingTool: A process cannot be started.
        """
        for dead in [
            one for one in self._clerks if one.ticket < 0 and one.child.poll() is not None
        ]:
            # It died without an order, so this one is not to suffer for it.
            self._lost(dead, "it ended")
        clerk = next((one for one in self._clerks if one.ticket < 0), None) or self._hired()
        clerk.ticket, clerk.deadline = ticket, time.monotonic() + self._seconds
        # A new one reads nothing before it has imported all that it needs, which takes its time
        # on a busy machine.
        clerk.desk.settimeout(self._seconds)
        with suppress(OSError):
            # One that is dead is seen by its socket, as one that dies later is.
            post(clerk.desk, order)
        # From now on one that stops in the middle of a letter would stop us all.
        clerk.desk.settimeout(PATIENCE_SECONDS)

    def news(self) -> Iterator[News]:
        """Wait until something happens, and tell it."""
        waiting = [clerk.deadline for clerk in self._clerks if clerk.ticket >= 0]
        left = max(0.0, min(waiting) - time.monotonic()) if waiting else 0.0
        for key, _ in self._selector.select(left):
            yield from self._heard(key.data)
        for clerk in list(self._clerks):
            if clerk.ticket >= 0 and time.monotonic() >= clerk.deadline:
                yield self._lost(clerk, f"it did not end within {self._seconds:.0f} s")

    def _hired(self) -> _Clerk:
        with ExitStack() as undone:
            try:
                words = undone.enter_context(tempfile.TemporaryFile(dir=self._folder))
                ours, theirs = map(undone.enter_context, socket.socketpair())
            except OSError as fault:
                message = f"no clerk can be started: {fault.strerror or fault}"
                raise MissingTool(message) from fault
            child = _started(self._entry, theirs.fileno(), words, self._folder)
            theirs.close()
            undone.pop_all()
        clerk = _Clerk(child, ours, words)
        self._clerks.append(clerk)
        self._selector.register(ours, selectors.EVENT_READ, clerk)
        return clerk

    def _heard(self, clerk: _Clerk) -> Iterator[News]:
        try:
            kind, what = received(clerk.desk)
        except (Ended, OSError, pickle.UnpicklingError, EOFError):
            idle = clerk.ticket < 0
            lost = self._lost(clerk, "it ended")
            if not idle:
                yield lost
            return
        if kind == "told":
            yield Told(clerk.ticket, what)
            return
        ticket, clerk.ticket = clerk.ticket, -1
        yield Done(ticket, what)

    def _lost(self, clerk: _Clerk, why: str) -> Gone:
        """Dismiss a clerk for good."""
        self._selector.unregister(clerk.desk)
        self._clerks.remove(clerk)
        clerk.desk.close()
        code = _end(clerk, 0.0 if why else PATIENCE_SECONDS)
        return Gone(clerk.ticket, f"{why} ({_worded(code)})", _last_words(clerk))


def _started(entry: str, desk: int, words: IO[bytes], folder: Path) -> subprocess.Popen[bytes]:
    # The modules that we have, and not whatever lies where the command was typed.
    found = os.pathsep.join(place for place in sys.path if place)
    command = [sys.executable, "-P", "-m", "grader.sandbox.clerk", entry, str(desk)]
    try:
        return subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=words,
            stderr=words,
            env={**os.environ, "PYTHONPATH": found, "TMPDIR": str(folder)},
            pass_fds=(desk,),
            start_new_session=True,
        )
    except OSError as fault:
        message = f"{sys.executable} cannot be started: {fault.strerror}; grade fewer at a time"
        raise MissingTool(message) from fault


def _end(clerk: _Clerk, patience: float) -> int:
    """Wait for the end of a clerk that was told of it, or bring it about."""
    try:
        code = clerk.child.wait(patience)
    except subprocess.TimeoutExpired:
        with suppress(ProcessLookupError):
            os.killpg(clerk.child.pid, signal.SIGKILL)
        code = clerk.child.wait()
    return code


def _last_words(clerk: _Clerk) -> str:
    with clerk.words as file:
        size = file.seek(0, os.SEEK_END)
        file.seek(max(0, size - LAST_WORDS))
        return printable(file.read().decode(errors="replace").strip(), LAST_WORDS)


def _worded(code: int) -> str:
    if code >= 0:
        return f"exit status {code}"
    try:
        return signal.Signals(-code).name
    except ValueError:
        return f"signal {-code}"
