"""Runs lines of Python as a worker, and programs as a compiler, in real boxes."""

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from grader.resources import is_root
from grader.sandbox.box import Bounds, Box, Isolation, Level
from grader.sandbox.confine import confined
from grader.sandbox.launch import Outcome
from grader.sandbox.stage import staged
from grader.sandbox.target import Target

LEVELS = ("A", "B")
SNIPPET = (Path(__file__).with_name("snippet.py"),)
SYSTEM_PYTHON = "/usr/bin/python3"
WORKER_BOUNDS = Bounds(20, 1 << 30, 1 << 20, 32, 64, 8 << 20)
COMPILER_BOUNDS = Bounds(20, 2 << 30, 16 << 20, 256, 32, 64 << 20)


@dataclass(frozen=True, slots=True)
class Given:
    """What a test gives a box beyond the usual."""

    bounds: Bounds | None = None
    seconds: float = 60.0
    output_bytes: int = 64 << 10
    descriptors: tuple[int, ...] = ()
    readable: tuple[Path, ...] = ()
    words: Sequence[str] = ()
    resident_bytes: int = 0


def counts_tasks(isolation: Isolation) -> bool:
    """Tell whether the kernel counts the tasks of a box alone.

    Without a namespace it counts all that a user runs, which is more than the box unless the
    grader is root and gives each box a user of its own: then there is no limit.
    """
    return isolation.level is Level.NAMESPACES or is_root()


def as_worker(isolation: Isolation, code: str, given: Given | None = None) -> Outcome:
    """Run lines of Python in the box of a worker; see snippet.py for what they find."""
    given = given or Given()
    entry = staged(SNIPPET)
    box = Box((entry.parent, *given.readable), given.bounds or WORKER_BOUNDS)
    target = Target(
        "snippet",
        [textwrap.dedent(code), *given.words],
        given.seconds,
        given.output_bytes,
        descriptors=given.descriptors,
    )
    return confined(target, box, entry, isolation)


def as_compiler(
    isolation: Isolation, own: Path, argv: Sequence[str], given: Given | None = None
) -> Outcome:
    """Run a program in the box of a compiler, which writes to `own`."""
    given = given or Given()
    entry = staged()
    own.mkdir(mode=0o700, exist_ok=True)
    bounds = given.bounds or COMPILER_BOUNDS
    box = Box((entry.parent, *given.readable), bounds, own, starts_programs=True)
    target = Target(
        program=argv[0],
        arguments=argv[1:],
        seconds=given.seconds,
        output_bytes=given.output_bytes,
        folder=own,
        descriptors=given.descriptors,
        environment={"TMPDIR": str(own)},
    )
    return confined(target, box, entry, isolation)


def python_as_compiler(
    isolation: Isolation, own: Path, code: str, given: Given | None = None
) -> Outcome:
    """Run lines of Python by the system's interpreter in the box of a compiler."""
    argv = [SYSTEM_PYTHON, "-I", "-S", "-c", textwrap.dedent(code)]
    return as_compiler(isolation, own, argv, given)


def bounded(bounds: Bounds, **changed: object) -> Given:
    """Give a box with other bounds."""
    return Given(replace(bounds, **changed))  # type: ignore[arg-type]  # named by the test
