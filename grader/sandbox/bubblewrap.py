"""How is bubblewrap told to make a box?

Never started as root: it would map the box to root of the host, and /proc would open doors.
The protection is entirely what the arguments say, so each group of them has its reason.
Source: bwrap(1); the measurements are in docs/security.md.
"""

import os
import re
import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from grader.errors import WorkerFault
from grader.sandbox.box import Box, Isolation
from grader.sandbox.launch import Order, Outcome, launch
from grader.sandbox.visible import DEVICES, hidden_folders, interpreter_paths, system_paths

_USERNS_OPTION = (0, 8)
"""First version with --disable-userns."""

_SIGNAL_BASE = 128
"""Bubblewrap and shells report death by signal N as 128 + N."""

_LAST_SIGNAL = 64


@cache
def find_bubblewrap() -> tuple[str, tuple[int, ...]] | None:
    """Path and version of bwrap; None if it is not installed."""
    path = shutil.which("bwrap")
    if path is None:
        return None
    said = launch(Order([path, "--version"], 10.0)).out.decode(errors="replace")
    numbers = re.search(r"(\d+)\.(\d+)", said)
    return (path, tuple(map(int, numbers.groups()))) if numbers else None


@dataclass(frozen=True, slots=True)
class Interior:
    """What the process in a box is, and what it knows."""

    interpreter: Path
    environment: Mapping[str, str]
    variables: int
    """Descriptor of a file with the same environment, as in /proc."""


def arguments(version: tuple[int, ...], box: Box, interior: Interior) -> Iterator[str]:
    """Options that make a box; the command to run in it comes after them."""
    # --unshare-all alone only tries to make a user namespace, and goes on without one.
    yield from ("--unshare-user", "--unshare-all", "--die-with-parent", "--new-session")
    if version >= _USERNS_OPTION:
        yield "--disable-userns"
    yield from ("--hostname", "box", "--cap-drop", "ALL", "--clearenv")
    for name, value in interior.environment.items():
        yield from ("--setenv", name, value)
    yield from _mounts(box, interior.interpreter)
    if "LD_PRELOAD" in interior.environment:
        yield from _for_sanitizers(interior)
    # Without a limit of size, a writable root would be memory that no limit counts.
    yield from ("--remount-ro", "/")


def _for_sanitizers(interior: Interior) -> Sequence[str]:
    """Two files where /proc would have them.

    A sanitizer takes its options from the first, and opens the second, the program that it
    runs in, before it can name lines of a library.
    """
    data = ["--ro-bind-data", str(interior.variables), "/proc/self/environ"]
    return [*data, "--symlink", str(interior.interpreter), "/proc/self/exe"]


def _mounts(box: Box, interpreter: Path) -> Iterator[str]:
    """There is no /proc: it would show the command line and the environment of bwrap."""
    system = system_paths(box)
    extra = [path for path in interpreter_paths(interpreter) if not _within(path, system)]
    for path in system:
        yield from _shown(path)
    for path in extra:
        yield from ("--ro-bind", str(path), str(path))
    for folder in hidden_folders([*system, *extra]):
        yield from ("--tmpfs", str(folder), "--remount-ro", str(folder))
    yield from ("--dir", "/dev")
    for device in DEVICES:
        yield from ("--dev-bind", device, device)
    for path in box.readable:
        yield from ("--ro-bind", str(path), str(path))
    if box.writable:
        yield from ("--bind", str(box.writable), str(box.writable))


def _shown(path: Path) -> Sequence[str]:
    if path.is_symlink():
        return ("--symlink", os.readlink(path), str(path))  # noqa: PTH115 - the text as it is
    return ("--ro-bind", str(path), str(path))


def _within(path: Path, roots: Sequence[Path]) -> bool:
    return any(path.is_relative_to(root) for root in roots)


@contextmanager
def wrapped(order: Order, box: Box, isolation: Isolation) -> Iterator[Order]:
    """Put a command into bubblewrap, whose own environment is empty.

    Raises:
        WorkerFault: It is not installed any more.
    """
    found = find_bubblewrap()
    if found is None:
        raise WorkerFault("bubblewrap is gone; install the Debian package bubblewrap")
    path, version = found
    environment = order.environment or {}
    given = os.memfd_create("options", os.MFD_CLOEXEC)
    shown = os.memfd_create("environment", os.MFD_CLOEXEC)
    interior = Interior(isolation.interpreter, environment, shown)
    options = list(arguments(version, box, interior))
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


def unwrapped(outcome: Outcome) -> Outcome:
    """Read the exit code as bubblewrap means it; a submission can imitate it by exiting so."""
    number = outcome.code - _SIGNAL_BASE
    return replace(outcome, code=-number) if 0 < number <= _LAST_SIGNAL else outcome


def _fill(file: int, words: Iterable[str]) -> None:
    os.pwrite(file, b"".join(f"{word}\0".encode() for word in words), 0)
