"""How is a program started inside a box?

Theory of operation. At every level a confined process is begun as `python start.py SPEC --
TARGET`. It limits itself, changes its user, closes its doors by Landlock and a filter of system
calls, and only then becomes the target. At the best level all that happens inside a namespace
that bubblewrap made, started as an unprivileged user. The paths inside are those outside, so
that one command line serves all levels. A program is what that process executes; a module is
run by a copy of it, which gives up its rights alone (nursery.py).
"""

import os
from contextlib import nullcontext
from pathlib import Path

from grader.errors import WorkerFault
from grader.sandbox import bubblewrap
from grader.sandbox.box import BUBBLES, Box, Isolation
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, Outcome, launch
from grader.sandbox.nursery import Nursery
from grader.sandbox.slots import settled
from grader.sandbox.target import ATTEMPTS, Target
from grader.sandbox.words import specification


def confined(
    target: Target, box: Box, entry: Path, isolation: Isolation, nursery: Nursery | None = None
) -> Outcome:
    """Run a target in a box.

    Args:
        target: What to run.
        box: What it may see, write and use.
        entry: The staged start.py; its folder has to be readable in the box.
        isolation: The level.
        nursery: Keeps boxes of modules for the next one; None to use each once.

    Raises:
        MissingTool: The interpreter or bubblewrap cannot be started.
        WorkerFault: A process cannot be ended or confined, or there is no user for it.
    """
    if not target.is_module:
        return _executed(target, box, entry, isolation)
    if nursery is not None:
        return nursery.run(target, box, entry, isolation)
    with Nursery() as own:
        return own.run(target, box, entry, isolation)


def _executed(target: Target, box: Box, entry: Path, isolation: Isolation) -> Outcome:
    with settled(box, isolation) as level:
        for _ in range(ATTEMPTS):
            entered, outcome = _attempt(target, box, entry, level)
            if entered or outcome.timed_out:
                return outcome
    text = outcome.err.decode(errors="replace").strip()[-500:]
    message = f"a process could not be confined ({isolation.level.value}): {text}"
    raise WorkerFault(message)


def _attempt(
    target: Target, box: Box, entry: Path, isolation: Isolation
) -> tuple[bool, Outcome]:
    """Run a program; also tell whether it was ever reached, or our own part failed before."""
    ready, announce = os.pipe()
    try:
        kept = ",".join(map(str, target.descriptors))
        spec = [
            *specification(box, isolation, waits=False),
            f"ready={announce}",
            f"keep={kept}",
        ]
        command = [str(isolation.interpreter), "-I", "-S", str(entry), *spec, "--"]
        order = Order(
            [*command, target.program, *target.arguments],
            target.seconds,
            target.output_bytes,
            target.folder or Path("/"),
            (*target.descriptors, announce),
            {**PLAIN_ENVIRONMENT, **(target.environment or {})},
        )
        bubble = isolation.level in BUBBLES
        around = bubblewrap.wrapped(order, box, isolation) if bubble else nullcontext(order)
        with around as wrapped:
            outcome = launch(wrapped)
        if bubble:
            outcome = bubblewrap.unwrapped(outcome)
        os.set_blocking(ready, False)
        try:
            return os.read(ready, 1) == b"r", outcome
        except BlockingIOError:
            return False, outcome
    finally:
        os.close(ready)
        os.close(announce)
