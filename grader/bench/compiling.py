"""What does compiling one submission cost? Goals 4 and 5, on the textbook solution."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from grader.bench import goals
from grader.bench.libraries import COMPILE_SECONDS, TEXTBOOK, by_hand
from grader.bench.record import Cost, Goal, Reading
from grader.bench.statistics import interleaved, ratios
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, SANITIZED, workspace
from grader.errors import BuildFault
from grader.sandbox.launch import Order, launch


def compile_cost(command: Sequence[str], source: Path, folder: Path) -> Cost:
    """Run one compiler on one file, without a box: only compilers are compared.

    Raises:
        BuildFault: It does not compile.
    """
    words = [*command, "-c", str(source), "-o", str(folder / "bench.o")]
    outcome = launch(Order(words, COMPILE_SECONDS))
    if outcome.code != 0:
        raise BuildFault(f"{source.name}: {outcome.err.decode(errors='replace')[-500:]}")
    return Cost(outcome.cpu_seconds, outcome.seconds)


def measured(folder: Path, rounds: int) -> list[Reading]:
    """Compile the textbook solution in every way that a grade does, and by hand."""
    graded, sanitized = (workspace(find_compiler(), each) for each in (GRADED, SANITIZED))
    plain = [word for word in by_hand(graded) if not word.startswith("-O")]
    commands = {
        "plain -O2": [*plain, "-O2"],
        "by hand": by_hand(graded),
        "precompiled": graded.compile_command,
        "sanitized": sanitized.compile_command,
    }
    runs = {
        name: lambda command=command: compile_cost(command, TEXTBOOK, folder)  # type: ignore[misc]  # mypy knows no lambda with a default
        for name, command in commands.items()
    }
    cpu = {name: [each.cpu for each in of] for name, of in interleaved(runs, rounds).items()}
    return [
        _compared(goals.SANITIZED, cpu, "sanitized", "plain -O2"),
        _compared(goals.PRECOMPILED, cpu, "precompiled", "by hand"),
    ]


def _compared(goal: Goal, cpu: dict[str, list[float]], above: str, below: str) -> Reading:
    a, b = float(np.median(cpu[above])), float(np.median(cpu[below]))
    return Reading(goal, ratios(cpu[above], cpu[below]), f"{a:.2f} s / {b:.2f} s CPU")
