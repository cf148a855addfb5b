"""What does compiling one submission cost? Goals 4 and 5, on the textbook solution."""

import hashlib
import resource
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np

from grader.bench import goals
from grader.bench.libraries import COMPILE_SECONDS, TEXTBOOK, by_hand
from grader.bench.record import Cost, Goal, Reading
from grader.bench.statistics import interleaved, ratios
from grader.build.compile import compile_submission
from grader.build.compiler import find_compiler
from grader.build.compiling import Compilation
from grader.build.workspace import GRADED, SANITIZED, workspace
from grader.errors import BuildFault
from grader.model.stages import SOURCE_NAME, Submission
from grader.sandbox.launch import Order, launch
from grader.sandbox.selftest import unconfined
from grader.score.rubric import load_rubric


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
    commands: dict[str, Sequence[str]] = {
        "plain -O2": [*plain, "-O2"],
        "by hand": by_hand(graded),
        "precompiled": graded.compile_command,
        "sanitized": sanitized.compile_command,
    }
    runs = {
        name: partial(compile_cost, command, TEXTBOOK, folder)
        for name, command in commands.items()
    }
    cpu = {name: [each.cpu for each in of] for name, of in interleaved(runs, rounds).items()}
    cpu["unchanged"] = [_again(folder / f"again-{number}") for number in range(rounds)]
    return [
        _compared(goals.SANITIZED, cpu, "sanitized", "plain -O2"),
        _compared(goals.PRECOMPILED, cpu, "precompiled", "by hand"),
        _compared(goals.UNCHANGED, cpu, "unchanged", "by hand"),
    ]


def _again(folder: Path) -> float:
    """Compile a file twice; CPU seconds of the second time, those of children included."""
    text = TEXTBOOK.read_bytes()
    same = Submission("textbook", SOURCE_NAME, text, hashlib.sha256(text).hexdigest())
    limits, begun = load_rubric().limits.compiler, 0.0
    for number in range(2):
        begun = _cpu_seconds()
        order = Compilation(folder / str(number), unconfined(), limits, frozenset())
        compile_submission(same, order)
    return _cpu_seconds() - begun


def _cpu_seconds() -> float:
    """Of this process and of all children that it has waited for."""
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, who))


def _compared(goal: Goal, cpu: dict[str, list[float]], above: str, below: str) -> Reading:
    a, b = float(np.median(cpu[above])), float(np.median(cpu[below]))
    return Reading(goal, ratios(cpu[above], cpu[below]), f"{a:.3f} s / {b:.3f} s CPU")
