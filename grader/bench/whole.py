"""What does a whole grade cost, against running the same by hand? Goal 1."""

import hashlib
import json
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from grader.bench import goals
from grader.bench.compiling import compile_cost
from grader.bench.libraries import without_headers
from grader.bench.programs import grader_cost
from grader.bench.record import Cost, Floor, Goal, Reading
from grader.bench.statistics import interleaved, ratios, spread
from grader.build.compile import compile_submission
from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.build.compiling import TRUSTED, Compilation
from grader.build.workspace import GRADED, SANITIZED, with_real_depth, workspace
from grader.errors import BuildFault, WorkerFault
from grader.model.stages import SOURCE_NAME, Stop, Submission
from grader.model.trials import RebuildTrial, RepeatTrial, Trial
from grader.oracle.plan import deeper_trials
from grader.output import RESULT
from grader.resources import reference_source
from grader.run.job import Job
from grader.run.requests import asked, request
from grader.run.session import Allowance, Engine, run_job
from grader.run.trials import Engines, at_once, is_sanitized
from grader.sandbox.selftest import unconfined
from grader.solution import GENEROUS, Solution

SEED = 41
PATIENCE = 3600
"""Seconds for a compiler on a busy machine."""

ROOMY = replace(GENEROUS, memory_mib=1 << 15)
"""All trials of a build in one process keep all their meshes."""

_ALLOWED = Allowance(600.0, 3600.0)


def measured(folder: Path, rounds: int) -> tuple[list[Reading], Floor]:
    """Grade the model solution, and compile and run it by hand, in turns.

    By hand means: compile the one file with each of the flags of a grade and without anything
    precompiled, then build every tree and trace every ray of the trials, all of it one after
    the other and unconfined, and look at no result. Once with the graph of calls, the sanitized
    builds and their trials, as a grade has them, and once without.
    """
    trials = [*Solution().plan(SEED).trials, *deeper_trials(SEED)]
    plain = [trial for trial in trials if not is_sanitized(trial)]
    watched = [trial for trial in trials if is_sanitized(trial)]
    own, *others = _commands()
    engines = _engines(folder / "by-hand")

    def compiled(commands: Sequence[Sequence[str]]) -> Cost:
        return _sum([compile_cost(command, reference_source(), folder) for command in commands])

    runs: dict[str, Callable[[], Cost]] = {
        "grade": lambda: graded_cost(unseen(reference_source(), folder), folder / "graded"),
        "build": lambda: compiled([without_headers(own)]),
        "builds": lambda: compiled([without_headers(command) for command in others]),
        "precompiled": lambda: compiled([own, *others]),
        "run": lambda: _run(engines, plain),
        "sanitized": lambda: _run(engines, watched),
    }
    costs = interleaved(runs, rounds)
    costs["plain"] = _summed(costs, "build", "run")
    costs["both"] = _summed(costs, "plain", "builds", "sanitized")
    readings = [
        _compared(goals.WALL, costs, "both", lambda cost: cost.wall),
        _compared(goals.CPU, costs, "both", lambda cost: cost.cpu),
        _compared(goals.PLAIN_WALL, costs, "plain", lambda cost: cost.wall),
        _compared(goals.PLAIN_CPU, costs, "plain", lambda cost: cost.cpu),
    ]
    return readings, _floor(costs)


def _commands() -> list[tuple[str, ...]]:
    """All compilations of a grade, that of the graded library first."""
    graded, small = (workspace(find_compiler(), each) for each in (GRADED, SANITIZED))
    graph = (*graded.graph_command, "-S")
    deep = with_real_depth(small.compile_command)
    return [graded.compile_command, graph, small.compile_command, deep]


def _floor(costs: dict[str, list[Cost]]) -> Floor:
    """Spread over all cores what no grade can do without."""
    cores = at_once()
    least = _summed(costs, "precompiled", "run", "sanitized")
    return Floor(
        spread([cost.cpu / cores for cost in least]).median,
        spread([cost.wall for cost in costs["grade"]]).median,
        cores,
    )


def _summed(costs: dict[str, list[Cost]], *names: str) -> list[Cost]:
    """Add up some runs, round by round."""
    return [_sum(each) for each in zip(*(costs[name] for name in names), strict=True)]


def graded_cost(source: Path, out: Path) -> Cost:
    """Grade a file, the CPU time of all workers included.

    The kernel forgets that of a process which is killed with its namespace. So the time on the
    clock that the result says of its workers is taken for it: a little more than they used.
    """
    cost = grader_cost("grade", source, "-o", out, "--seed", str(SEED), "--quiet")
    workers = json.loads((out / RESULT).read_text())["timing"]["submission"]
    return Cost(cost.cpu + float(workers), cost.wall)


def _engines(folder: Path) -> Engines:
    """Build the model solution in every way that a grade runs it."""
    text = reference_source().read_bytes()
    own = Submission("reference", SOURCE_NAME, text, hashlib.sha256(text).hexdigest())
    limits = replace(TRUSTED, seconds=PATIENCE, wall_seconds=PATIENCE)
    build = compile_submission(own, Compilation(folder, unconfined(), limits))
    runtime = sanitizer_runtime(find_compiler())
    graded, small, deep = (
        Engine(library, ROOMY, unconfined(), preload) if library else None
        for library, preload in (
            (build.library, ""),
            (build.sanitized, runtime),
            (build.deep, runtime),
        )
    )
    if graded is None:
        raise BuildFault(f"the model solution does not compile: {build.diagnostics[:3]}")
    return Engines(graded, small, deep)


def unseen(source: Path, folder: Path) -> Path:
    """Write a file that says the same, and that nobody has compiled before."""
    path = folder / "unseen.cpp"
    path.write_text(f"{source.read_text()}// {time.time_ns()}\n")
    return path


def _run(engines: Engines, trials: Sequence[Trial]) -> Cost:
    """Run trials without a box and without a look at what they bring.

    By hand nobody starts a process for each. So those of one build share a process, and of
    those that need two the start of a further one is taken off.
    """
    shared: dict[Path, tuple[Engine, Job]] = {}
    further: list[tuple[Engine, Job]] = []
    for trial in trials:
        engine = engines.of(trial)
        if engine is None:
            continue
        if isinstance(trial, RebuildTrial | RepeatTrial):
            further += [(engine, job) for job in request(trial).jobs]
        else:
            asked(shared.setdefault(engine.library, (engine, Job()))[1], trial)
    start = _cost_of(engines.graded, Job())
    begun = [_cost_of(*each) for each in (*shared.values(), *further)]
    whole, extra = _sum(begun), len(further)
    return Cost(whole.cpu - extra * start.cpu, whole.wall - extra * start.wall)


def _cost_of(engine: Engine, job: Job) -> Cost:
    ending, _ = run_job(job, engine, _ALLOWED)
    if ending.stop is not Stop.FINISHED:
        raise WorkerFault(f"the model solution did not come back: {ending.detail}")
    return Cost(ending.cpu_seconds, ending.seconds)


def _sum(costs: Sequence[Cost]) -> Cost:
    return Cost(sum(each.cpu for each in costs), sum(each.wall for each in costs))


def _compared(
    goal: Goal, costs: dict[str, list[Cost]], hand: str, of: Callable[[Cost], float]
) -> Reading:
    above, below = ([of(cost) for cost in costs[name]] for name in ("grade", hand))
    detail = f"{spread(above).median:.2f} s / {spread(below).median:.2f} s"
    return Reading(goal, ratios(above, below), detail)
