"""Which level of isolation does this machine really give?

Before the first submission is graded, a program of ours tries from inside a box what a hostile
one would try. A level is used only if nothing succeeds, for a worker and for a compiler; what
it could not prove is not claimed.
"""

import os
import secrets
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import cache
from itertools import chain
from pathlib import Path

from grader import resources
from grader.errors import GraderError, MissingTool, UsageError
from grader.resources import is_root
from grader.sandbox.box import BUBBLES, LETTERS, Bounds, Box, Isolation, Level
from grader.sandbox.bubblewrap import find_bubblewrap
from grader.sandbox.confine import confined
from grader.sandbox.interpreter import (
    is_reachable,
    own_interpreter,
    reachable_interpreter,
)
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.stage import INSIDE, staged
from grader.sandbox.target import Target

VARIABLE = "BVHGRADE_ISOLATION"
"""Environment variable with which an operator demands one level: A, B or C."""

PROBE_SECONDS = 20.0
PROBE_MEMORY = 512 << 20
PROBE_FILES = 32


def unconfined() -> Isolation:
    """No isolation but resource limits: for code of our own, or by explicit choice."""
    return Isolation(Level.NONE, own_interpreter())


@cache
def proved_isolation(wanted: str = "") -> Isolation:
    """The best level that holds on this machine, proved once for each process.

    Args:
        wanted: Letter of the only level to try; empty for all, or for what the environment
            variable says.

    Raises:
        UsageError: There is no such level.
        MissingTool: No level holds; with the reasons and what to do.
    """
    letter = (wanted or os.environ.get(VARIABLE, "")).upper()
    if letter and letter not in LETTERS:
        known = ", ".join(LETTERS)
        raise UsageError(f"{VARIABLE}={letter}: there is no such level, but {known}")
    reasons: list[str] = []
    for level in LETTERS[letter] if letter else chain(*LETTERS.values()):
        try:
            isolation = _candidate(level, tuple(reasons))
            flaws = flaws_of(isolation)
        except GraderError as fault:
            flaws = [str(fault)]
        if not flaws:
            return isolation
        reasons.append(f"{level.value}: {'; '.join(flaws)}")
    what = "\n".join(reasons)
    message = (
        f"no way to isolate submissions holds on this machine; nothing is run.\n{what}\n"
        "Install the Debian package bubblewrap, use a kernel with Landlock (5.13 or newer), or "
        "pass --unsafe-no-isolation for code that you would run yourself"
    )
    raise MissingTool(message)


def _candidate(level: Level, unproved: tuple[str, ...]) -> Isolation:
    """Find what a level needs.

    Raises:
        MissingTool: Something is not there.
    """
    cache_folder = resources.shared_cache("entry")
    if is_root() and not is_reachable(cache_folder):
        message = (
            f"{cache_folder} cannot be entered by the unprivileged user that compiles; set "
            "BVHGRADE_CACHE to a folder below others that everyone may enter"
        )
        raise MissingTool(message)
    if level is Level.USER and not is_root():
        raise MissingTool("only root can become another user")
    if level not in BUBBLES:
        return Isolation(level, own_interpreter(), unproved)
    if find_bubblewrap() is None:
        raise MissingTool("bubblewrap is not installed (Debian package bubblewrap)")
    interpreter = reachable_interpreter() if is_root() else own_interpreter()
    if interpreter is None:
        message = (
            f"{own_interpreter()} cannot be read by an unprivileged user, and there is no "
            "/usr/bin/python3; install the Debian package python3"
        )
        raise MissingTool(message)
    return Isolation(level, interpreter, unproved)


def flaws_of(isolation: Isolation) -> list[str]:
    """Say what can be done from inside the boxes of a level; empty if nothing."""
    shared = isolation.level is not Level.USER
    with _bait(shared) as (folder, secret), ThreadPoolExecutor(2) as pool:
        boxes = [(kind, _box(kind, folder)) for kind in ("worker", "compiler")]
        futures = [pool.submit(_probe, kind, box, secret, isolation) for kind, box in boxes]
        flaws = [flaw for future in futures for flaw in future.result()]
    return flaws if shared else [flaw for flaw in flaws if not flaw.startswith(_OPEN_TO_ALL)]


_OPEN_TO_ALL = (
    "a compiler writes to ",
    "a worker reads /etc/",
    "a compiler reads /etc/",
    "a worker opens the root",
    "a compiler opens the root",
)
"""Another user alone is not kept from what every user may do; level C does not claim it."""


@contextmanager
def _bait(shared: bool) -> Iterator[tuple[Path, Path]]:
    """A folder like that of a submission, and a file that a box may not read.

    Args:
        shared: Whether every user of the machine may read the file.
    """
    with scratch_folder() as folder, scratch_folder() as outside:
        secret = outside / "secret"
        secret.write_text(secrets.token_hex())
        secret.chmod(0o644 if shared else 0o600)
        yield folder, secret


def _box(kind: str, folder: Path) -> Box:
    bounds = Bounds(10, PROBE_MEMORY, 1 << 20, PROBE_FILES, 64, 8 << 20)
    readable = (staged(_PROBE).parent,)
    if kind == "worker":
        return Box(readable, bounds)
    own = folder / "own"
    own.mkdir(mode=0o700)
    return Box(readable, bounds, own, starts_programs=True)


_PROBE = (INSIDE / "probe.py",)


def _probe(kind: str, box: Box, secret: Path, isolation: Isolation) -> Sequence[str]:
    """Run the probe in a box; what it could do."""
    out_of_reach = [secret, *_answers(), Path(f"/proc/{os.getpid()}/environ")]
    target = Target(
        program="probe",
        arguments=[
            kind,
            str(os.getpid()),
            str(box.bounds.memory_bytes),
            str(box.bounds.open_files),
            str(box.writable or "-"),
            *map(str, out_of_reach),
        ],
        seconds=PROBE_SECONDS,
        output_bytes=64 << 10,
        folder=box.writable,
    )
    outcome = confined(target, box, staged(_PROBE), isolation)
    lines = outcome.out.decode(errors="replace").splitlines()
    if "done" not in lines:
        last = outcome.err.decode(errors="replace").strip().splitlines()[-1:]
        why = last[0] if last else f"status {outcome.code}"
        return [f"a {kind} does not start ({why})"]
    return [f"a {kind} {line}" for line in lines if line != "done"]


def _answers() -> list[Path]:
    """Files of ours with answers, which a wheel may have put among the system's libraries."""
    found = [resources.reference_source(), *resources.scenes_folder().glob("*.answers")]
    return [*found[:2], Path("/etc/passwd")]
