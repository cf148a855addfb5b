"""How does one path become one grade? The stages of the grader, in order."""

import time
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

from grader.build.compile import compile_submission
from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.build.compiling import Compilation
from grader.intake.locate import locate
from grader.model.cases import BuildCase, Case, SourceCase
from grader.model.grade import Grade, Limits, Rubric
from grader.model.stages import Build, Further, Rejected, Submission
from grader.model.trials import ConstructTrial, Trial
from grader.options import Options
from grader.oracle.plan import Plan
from grader.quick import SLOW_BUILDS, is_quick
from grader.rounds import Rounds, budget_of, hopeful, waves
from grader.run.session import Engine
from grader.run.trials import Engines, build_of
from grader.sandbox.box import Isolation
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.selftest import proved_isolation, unconfined
from grader.selection import Selection, select
from grader.solution import Solution
from grader.summary import Stages, Summary, timed

NOTHING = Plan((), ())
"""The plan of a run that only compiles."""

SHORTEST_COMPILATION = 10
"""Wall seconds that compiling may always take; ordinary files take 3."""


def grade_one(path: Path, options: Options) -> Grade:
    """Grade one submission.

    Raises:
        UsageError: The path, the rubric or the name of a check is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    return grade_with(path, options, (options.seed,))[0]


def grade_with(path: Path, options: Options, seeds: Sequence[int]) -> list[Grade]:
    """Grade one submission with several seeds, and compile it once.

    Args:
        path: The submission.
        options: How to grade; its seed is replaced.
        seeds: A grade for each.

    Raises:
        UsageError: The path, the rubric or the name of a check is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    before: Stages = []
    with timed("intake", options.progress, before):
        selection = select(options.rubric, options.only, options.for_student)
        submission = locate(path, selection.rubric.limits.source_kib << 10)
    return _grades(submission, selection, options, seeds, before)


def grade_located(submission: Submission | Rejected, options: Options) -> Grade:
    """Grade a submission that was read already.

    Raises:
        UsageError: The rubric or the name of a check is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    selection = select(options.rubric, options.only, options.for_student)
    return _grades(submission, selection, options, (options.seed,), [])[0]


def withheld_grade(submission: Submission | Rejected, options: Options, reason: str) -> Grade:
    """Make the grade of a submission that we failed to judge: every check is BROKEN.

    Raises:
        UsageError: The rubric or the name of a check is wrong.
    """
    selection = select(options.rubric, options.only, options.for_student)
    summary = _summary(selection, options, [])
    summary.failed_to_judge(reason)
    return summary.grade(submission, None, ())


def _grades(
    submission: Submission | Rejected,
    selection: Selection,
    options: Options,
    seeds: Sequence[int],
    before: Stages,
) -> list[Grade]:
    """Grade with several seeds, and compile once; `before` is what was done already."""
    with timed("isolation", options.progress, before):
        isolation_of(options)
    # Each begins when the one before it is done, for the sake of its times.
    summaries = (_summary(selection, replace(options, seed=seed), before) for seed in seeds)
    if isinstance(submission, Rejected):
        return [_rejected(submission, each) for each in summaries]
    limits = selection.rubric.limits
    with scratch_folder() as folder, Nursery() as nursery, ThreadPoolExecutor(1) as aside:
        further = selection.further - SLOW_BUILDS if options.quick else selection.further
        order = _compilation(folder, limits, options, further)
        building = aside.submit(compile_submission, submission, order)
        return [_graded(submission, building, nursery, each) for each in summaries]


def _rejected(submission: Rejected, summary: Summary) -> Grade:
    summary.examine([BuildCase("build", (submission.reason,))])
    return summary.grade(submission, None, ())


def _summary(selection: Selection, options: Options, before: Stages) -> Summary:
    return Summary(selection, options, isolation_of(options).level.value, before)


def _graded(
    submission: Submission, building: Future[Build], nursery: Nursery, summary: Summary
) -> Grade:
    """Grade with one seed what is being compiled."""
    selection, options = summary.selection, summary.options
    with summary.stage("build and plan"):
        solution = None if selection.runs_nothing else Solution()
        plan = _plan(solution, options.seed, selection, summary) if solution else NOTHING
        build = building.result()
    summary.examine(_build_cases(build))
    if build.library is None or solution is None:
        return summary.grade(submission, build, ())
    trials = selection.useful([_as_read(trial, selection.rubric) for trial in plan.trials])
    if options.quick:
        trials = tuple(filter(is_quick, trials))
    summary.broken(plan.faults)
    with summary.stage("run and verify"):
        limits = selection.rubric.limits
        engines = _engines(build, limits, isolation_of(options), nursery)
        budget = budget_of(limits, options, summary.elapsed(), build.own_seconds)
        run = Rounds(engines, solution, selection.rubric, options, budget)
        first, then = waves(trials)
        summary.examine(run.cases(first))
        summary.examine(run.cases([trial for trial in then if hopeful(trial, summary)]))
        further = run.further_trials()
        summary.examine(run.cases(further) if further else run.small_depths)
        deeper = selection.useful(run.deeper_trials(summary))
        summary.examine(run.cases(deeper))
    return run.grade(summary, submission, build, (*trials, *further, *deeper))


def engines_for(
    path: Path, folder: Path, nursery: Nursery, options: Options, trial: Trial
) -> Engines | str:
    """Compile a submission for one trial; why it could not be, if so.

    Raises:
        UsageError: The path or the rubric is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    further = frozenset(filter(None, [build_of(trial)]))
    found = compiled(path, folder, options, further)
    if isinstance(found, Rejected):
        return found.reason
    _, build = found
    if build.library is None:
        return "it does not compile; bvhgrade check says why"
    limits = select(options.rubric, ()).rubric.limits
    return _engines(build, limits, isolation_of(options), nursery)


def compiled(
    path: Path, folder: Path, options: Options, further: frozenset[Further]
) -> tuple[Submission, Build] | Rejected:
    """Find a submission and compile it.

    Raises:
        UsageError: The path or the rubric is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    limits = select(options.rubric, ()).rubric.limits
    submission = locate(path, limits.source_kib << 10)
    if isinstance(submission, Rejected):
        return submission
    order = _compilation(folder, limits, options, further)
    return submission, compile_submission(submission, order)


def isolation_of(options: Options) -> Isolation:
    """Prove the level that a submission is run at, or take none if the caller insists."""
    return proved_isolation() if options.isolated else unconfined()


def _compilation(
    folder: Path, limits: Limits, options: Options, further: frozenset[Further]
) -> Compilation:
    """Leave half of the time to the runs: what is compiled twice in a row has to fit."""
    given, most = limits.compiler, options.most_seconds(limits) / 4
    wall = min(given.wall_seconds, max(SHORTEST_COMPILATION, int(most)))
    # Less CPU time than wall time, so that who computes too long is told from who waits.
    hurried = replace(given, wall_seconds=wall, seconds=min(given.seconds, wall * 2 // 3))
    return Compilation(folder, isolation_of(options), hurried, further)


def _plan(solution: Solution, seed: int, selection: Selection, summary: Summary) -> Plan:
    """Make the plan of the trials, while the submission is compiled aside."""
    started = time.monotonic()
    plan = solution.plan(seed, selection.rubric.scenes)
    summary.plan_seconds = time.monotonic() - started
    return plan


def _build_cases(build: Build) -> Iterator[Case]:
    if build.library is not None:
        yield BuildCase("build", ())
        if build.calls is not None:
            yield SourceCase("source", build.calls)
        return
    errors = [message for message in build.diagnostics if message.severity == "error"]
    yield BuildCase("build", tuple(_worded(each.line, each.text) for each in errors))


def _worded(line: int, text: str) -> str:
    return f"line {line}: {text}" if line else text


def _as_read(trial: Trial, rubric: Rubric) -> Trial:
    """Tell the trials of part a which reading of the sheet the rubric takes."""
    if isinstance(trial, ConstructTrial) and rubric.leaf_rule == "full-levels":
        return replace(trial, full_levels=True)
    return trial


def _engines(build: Build, limits: Limits, isolation: Isolation, nursery: Nursery) -> Engines:
    if build.library is None:
        raise AssertionError("there is a library, or nothing is run")
    runtime = sanitizer_runtime(find_compiler())

    def sanitized(library: Path | None) -> Engine | None:
        return Engine(library, limits, isolation, runtime, nursery) if library else None

    graded = Engine(build.library, limits, isolation, nursery=nursery)
    return Engines(graded, sanitized(build.sanitized), sanitized(build.deep))
