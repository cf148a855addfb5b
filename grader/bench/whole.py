"""What does a whole grade cost, against running the same by hand? Goals 1 and 3."""

import sys
import time
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path

from grader.bench import goals
from grader.bench.compiling import compile_cost
from grader.bench.libraries import TEXTBOOK, by_hand
from grader.bench.programs import grader_cost, program
from grader.bench.record import Cost, Goal, Reading
from grader.bench.statistics import interleaved, ratios, spread
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, workspace
from grader.errors import WorkerFault
from grader.model.stages import Stop
from grader.model.trials import Trial
from grader.resources import reference_source
from grader.run.requests import request
from grader.run.session import Allowance, Engine, run_job
from grader.run.trials import is_sanitized
from grader.sandbox.nursery import Nursery
from grader.sandbox.selftest import unconfined
from grader.solution import GENEROUS, Solution

SEED = 41
_ALLOWED = Allowance(600.0, 3600.0)


def measured(folder: Path, library: Path, rounds: int) -> list[Reading]:
    """Grade the model solution, and compile and run it by hand, in turns.

    By hand means: compile the one file with the graded flags and without anything precompiled,
    then build every tree and trace every ray of the grade's plain trials, one after the other
    and unconfined, and look at no result. The sanitized builds are the grade's alone.
    """
    trials = [each for each in Solution().plan(SEED).trials if not is_sanitized(each)]
    command = by_hand(workspace(find_compiler(), GRADED))
    words = ("-o", folder / "graded", "--seed", str(SEED), "--quiet")

    def hand() -> Cost:
        compiled = compile_cost(command, reference_source(), folder)
        return _sum([compiled, _run(library, trials)])

    runs: dict[str, Callable[[], Cost]] = {
        "grade": lambda: grader_cost("grade", unseen(reference_source(), folder), *words),
        "hand": hand,
    }
    costs = interleaved(runs, rounds)
    return [
        _compared(goals.WALL, costs, lambda cost: cost.wall),
        _compared(goals.CPU, costs, lambda cost: cost.cpu),
    ]


def overhead(folder: Path, rounds: int) -> list[Reading]:
    """Compare what each program adds to compiling one file, with nothing else to be done."""
    command = [*by_hand(workspace(find_compiler(), GRADED)), "-c", str(TEXTBOOK)]
    command += ["-o", str(folder / "overhead.o")]
    test = folder / "test_overhead.py"
    test.write_text(
        f"import subprocess\n\ndef test_it():\n    subprocess.run({command!r}, check=True)\n"
    )
    words = ("-o", folder / "overhead", "--only", "build.compiles", "--quiet")
    runs: dict[str, Callable[[], Cost]] = {
        "hand": lambda: _cost(command),
        "ours": lambda: grader_cost("grade", unseen(TEXTBOOK, folder), *words),
    }
    if find_spec("pytest") is not None:
        tested = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(test)]
        runs["pytest"] = lambda: _cost(tested)
    costs = interleaved(runs, rounds)
    added = {
        name: [
            max(1e-3, one.wall - hand.wall) for one, hand in zip(of, costs["hand"], strict=True)
        ]
        for name, of in costs.items()
    }
    missing = Reading(goals.CHECK50, None, "check50 is not installed")
    if "pytest" not in added:
        return [Reading(goals.PYTEST, None, "pytest is not installed"), missing]
    a, b = spread(added["ours"]).median, spread(added["pytest"]).median
    ratio = ratios(added["ours"], added["pytest"])
    return [Reading(goals.PYTEST, ratio, f"{a:.2f} s / {b:.2f} s"), missing]


def unseen(source: Path, folder: Path) -> Path:
    """Write a file that says the same, and that nobody has compiled before."""
    path = folder / "unseen.cpp"
    path.write_text(f"{source.read_text()}// {time.time_ns()}\n")
    return path


def _cost(command: Sequence[str]) -> Cost:
    outcome = program(command)
    return Cost(outcome.cpu_seconds, outcome.seconds)


def _run(library: Path, trials: Sequence[Trial]) -> Cost:
    """Run trials one after the other, without a box and without a look at what they bring."""
    costs = []
    with Nursery() as nursery:
        engine = Engine(library, GENEROUS, unconfined(), nursery=nursery)
        for trial in trials:
            for job in request(trial).jobs:
                ending, _ = run_job(job, engine, _ALLOWED)
                if ending.stop is not Stop.FINISHED:
                    raise WorkerFault(f"{trial.name}: {ending.detail}")
                costs.append(Cost(ending.cpu_seconds, ending.seconds))
    return _sum(costs)


def _sum(costs: Sequence[Cost]) -> Cost:
    return Cost(sum(each.cpu for each in costs), sum(each.wall for each in costs))


def _compared(goal: Goal, costs: dict[str, list[Cost]], of: Callable[[Cost], float]) -> Reading:
    grade, hand = ([of(cost) for cost in costs[name]] for name in ("grade", "hand"))
    detail = f"{spread(grade).median:.2f} s / {spread(hand).median:.2f} s"
    return Reading(goal, ratios(grade, hand), detail)
