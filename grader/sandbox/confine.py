"""How is a program started inside a box?

Theory of operation. At every level the confined process is `python start.py SPEC -- TARGET`:
it limits itself, changes its user, closes its doors by Landlock and a filter of system calls,
and only then becomes the target. At the best level all that happens inside a namespace that
bubblewrap made, started as an unprivileged user. The paths inside are those outside, so that
one command line serves all levels.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from grader.errors import WorkerFault
from grader.sandbox import bubblewrap
from grader.sandbox.box import BUBBLES, Bounds, Box, Isolation, Level
from grader.sandbox.filters import compiler_filter, worker_filter
from grader.sandbox.inside import landlock
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, Outcome, launch
from grader.sandbox.slots import own_user
from grader.sandbox.visible import DEVICES, system_paths

ATTEMPTS = 2
"""A failure of ours before anything foreign ran is tried again."""

_SIGNAL_BASE = 128
"""Bubblewrap and shells report death by signal N as 128 + N."""

_LAST_SIGNAL = 64


@dataclass(frozen=True, slots=True)
class Target:
    """What a box runs."""

    program: str
    """A module beside enter.py, or the absolute path of a program."""

    arguments: Sequence[str]
    seconds: float
    """Wall time."""

    output_bytes: int
    folder: Path | None = None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] | None = None
    """Added to the plain environment."""


def confined(target: Target, box: Box, entry: Path, isolation: Isolation) -> Outcome:
    """Run a target in a box.

    Args:
        target: What to run.
        box: What it may see, write and use.
        entry: The staged start.py; its folder has to be readable in the box.
        isolation: The level.

    Raises:
        MissingTool: The interpreter or bubblewrap cannot be started.
        WorkerFault: A process cannot be ended, or there is no user for it.
    """
    with own_user() as slot:
        uid = slot if isolation.level is not Level.NONE else 0
        if box.writable and uid:
            # Still empty, and in a folder that only we can change: nothing can be a link.
            os.chown(box.writable, uid, uid, follow_symlinks=False)
        for _ in range(ATTEMPTS):
            entered, outcome = _attempt(target, box, entry, replace(isolation, uid=uid))
            if entered or outcome.timed_out:
                return outcome
    text = outcome.err.decode(errors="replace").strip()[-500:]
    message = f"a process could not be confined ({isolation.level.value}): {text}"
    raise WorkerFault(message)


def _attempt(
    target: Target, box: Box, entry: Path, isolation: Isolation
) -> tuple[bool, Outcome]:
    """Run a target; also tell whether it was ever reached, or our own part failed before."""
    ready, announce = os.pipe()
    try:
        kept = ",".join(map(str, target.descriptors))
        spec = [*_specification(box, isolation), f"ready={announce}", f"keep={kept}"]
        command = [str(isolation.interpreter), "-I", "-S", str(entry), *spec, "--"]
        order = Order(
            [*command, target.program, *target.arguments],
            target.seconds,
            target.output_bytes,
            target.folder or Path("/"),
            (*target.descriptors, announce),
            {**PLAIN_ENVIRONMENT, **(target.environment or {})},
        )
        if isolation.level in BUBBLES:
            with _wrapped(order, box, isolation) as wrapped:
                outcome = _unwrapped(launch(wrapped))
        else:
            outcome = launch(order)
        os.set_blocking(ready, False)
        try:
            return os.read(ready, 1) == b"r", outcome
        except BlockingIOError:
            return False, outcome
    finally:
        os.close(ready)
        os.close(announce)


def _specification(box: Box, isolation: Isolation) -> Iterator[str]:
    """Words for enter.py."""
    yield from _limits(box.bounds, isolation)
    if isolation.level not in BUBBLES:
        yield f"parent={os.getpid()}"
    if isolation.level is Level.NONE:
        return
    if isolation.uid and isolation.level not in BUBBLES:
        yield f"uid={isolation.uid}"
    if isolation.level in (Level.NAMESPACES, Level.PROCESS):
        yield "landlock=" + "\n".join(_rules(box))
    code = compiler_filter() if box.starts_programs else worker_filter()
    yield f"filter={code.hex()}"


def _limits(bounds: Bounds, isolation: Isolation) -> Iterator[str]:
    # Elsewhere the kernel would count everything that the caller runs on this machine.
    namespace = isolation.level in BUBBLES
    alone = isolation.uid or namespace
    named = {
        "cpu": bounds.cpu_seconds,
        "room" if bounds.beyond_reserved else "memory": bounds.memory_bytes,
        "file": bounds.file_bytes,
        "files": bounds.open_files,
        # Bubblewrap's first process of a namespace is one too.
        "tasks": bounds.tasks + namespace if alone and bounds.tasks else 0,
        "stack": bounds.stack_bytes,
    }
    yield from (f"{name}={value}" for name, value in named.items() if value)


def _rules(box: Box) -> Iterator[str]:
    """Rights and paths; what is missing on this machine is left out inside."""
    # A sanitizer reads the program that it runs in before it can name lines of a library.
    yield f"{landlock.READ}=/proc/self/exe"
    right = landlock.RUN if box.starts_programs else landlock.READ
    for path in (*system_paths(box), *box.readable):
        yield f"{right}={path}"
    for device in DEVICES:
        yield f"{landlock.READ | landlock.WRITE_FILE}={device}"
    if box.writable:
        yield f"{landlock.OWN}={box.writable}"


@contextmanager
def _wrapped(order: Order, box: Box, isolation: Isolation) -> Iterator[Order]:
    """Put a command into bubblewrap, whose own environment is empty."""
    found = bubblewrap.find_bubblewrap()
    if found is None:
        raise WorkerFault("bubblewrap is gone; install the Debian package bubblewrap")
    path, version = found
    environment = order.environment or {}
    given = os.memfd_create("options", os.MFD_CLOEXEC)
    shown = os.memfd_create("environment", os.MFD_CLOEXEC)
    interior = bubblewrap.Interior(isolation.interpreter, environment, shown)
    options = list(bubblewrap.arguments(version, box, interior))
    if order.folder:
        options += ["--chdir", str(order.folder)]
    read, write = os.pipe()
    try:
        _fill(shown, (f"{name}={value}" for name, value in environment.items()))
        _fill(given, options)
        argv = [path, "--args", str(given), "--info-fd", str(write), "--", *order.argv]
        yield replace(
            order,
            argv=argv,
            folder=None,
            descriptors=(*order.descriptors, given, shown, write),
            environment={},
            uid=isolation.uid,
            report=read,
        )
    finally:
        for descriptor in (given, shown, read, write):
            os.close(descriptor)


def _fill(file: int, words: Iterable[str]) -> None:
    os.pwrite(file, b"".join(f"{word}\0".encode() for word in words), 0)


def _unwrapped(outcome: Outcome) -> Outcome:
    """Read the exit code as bubblewrap means it; a submission can imitate it by exiting so."""
    number = outcome.code - _SIGNAL_BASE
    return replace(outcome, code=-number) if 0 < number <= _LAST_SIGNAL else outcome
