"""How does one path become one grade? The stages of the grader, in order."""

import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from grader.build.compile import Compilation, compile_submission
from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.counterexample.search import Search, with_counterexamples
from grader.intake.locate import locate
from grader.model.cases import BuildCase, Case, DepthCase, SourceCase, WorkCase
from grader.model.grade import Grade, Limits, Rubric
from grader.model.stages import Build, Further, Rejected, Submission
from grader.model.trials import AlteredTrial, ConstructTrial, ImageTrial, Trial, WorkTrial
from grader.oracle.plan import Plan, deeper_trials, depth_trial
from grader.run.session import Engine
from grader.run.trials import LARGE_MESH, Budget, Engines, build_of, part_of, run_trials
from grader.sandbox.box import Isolation
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.selftest import proved_isolation, unconfined
from grader.selection import select
from grader.solution import Solution
from grader.summary import Progress, Summary
from grader.verify.structure import deepest_level, ends_at_the_limit

SHORTEST_COMPILATION = 10
"""Wall seconds that compiling may always take; ordinary files take 3."""

_RESERVE = 0.15
"""Share of the time limit that is kept for judging what the last workers brought."""

LARGE_PICTURE = 100_000
"""A mesh of more faces is not tried where `intersect` has been seen to test most of them."""


@dataclass(frozen=True, slots=True)
class Options:
    """How to grade."""

    seed: int
    rubric: Path | None
    only: tuple[str, ...]
    """Ids of the checks to run; empty for all."""

    progress: Progress
    time_limit: float | None = None
    """Wall seconds after which the grade is there, whatever the submission does; None takes
    the rubric's."""

    counterexamples: bool = False
    """Whether to look for the smallest input that fails each check that failed."""

    isolated: bool = True
    """False only if the caller insists on running code without isolation."""

    for_student: bool = False
    """Leave out whatever the rubric hides from students."""


def grade_one(path: Path, options: Options) -> Grade:
    """Grade one submission.

    Raises:
        UsageError: The path, the rubric or the name of a check is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    selection = select(options.rubric, options.only, options.for_student)
    limits = selection.rubric.limits
    level = _isolation(options).level
    summary = Summary(selection, options.seed, options.progress, level.value)
    submission = locate(path, limits.source_kib << 10)
    if isinstance(submission, Rejected):
        summary.examine([BuildCase("build", (submission.reason,))])
        return summary.grade(submission, None, ())
    with scratch_folder() as folder, Nursery() as nursery:
        with summary.stage("build and plan"):
            order = _compilation(folder, limits, options, selection.further)
            build, plan, solution = _prepare(submission, order, options.seed, summary)
        summary.examine(_build_cases(build))
        if build.library is None:
            return summary.grade(submission, build, ())
        trials = selection.useful([_as_read(trial, selection.rubric) for trial in plan.trials])
        summary.broken(plan.faults)
        with summary.stage("run and verify"):
            engines = _engines(build, limits, _isolation(options), nursery)
            run = _Run(engines, solution, selection.rubric, options, summary.elapsed())
            first, then = _waves(trials)
            summary.examine(run.cases(first))
            summary.examine(run.cases([trial for trial in then if _hopeful(trial, summary)]))
            further = run.further_trials()
            summary.examine(run.cases(further) if further else run.small_depths)
            summary.examine(run.cases(deeper := selection.useful(run.deeper_trials(summary))))
        return run.grade(summary, submission, build, (*trials, *further, *deeper))


def engines_for(
    path: Path, folder: Path, nursery: Nursery, options: Options, trial: Trial
) -> Engines | str:
    """Compile a submission for one trial; why it could not be, if so.

    Raises:
        UsageError: The path or the rubric is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    limits = select(options.rubric, ()).rubric.limits
    submission = locate(path, limits.source_kib << 10)
    if isinstance(submission, Rejected):
        return submission.reason
    further = frozenset(filter(None, [build_of(trial)]))
    build = compile_submission(submission, _compilation(folder, limits, options, further))
    if build.library is None:
        return "it does not compile; bvhgrade check says why"
    return _engines(build, limits, _isolation(options), nursery)


def _isolation(options: Options) -> Isolation:
    return proved_isolation() if options.isolated else unconfined()


def _time_limit(limits: Limits, options: Options) -> float:
    return options.time_limit or limits.total_seconds


def _compilation(
    folder: Path, limits: Limits, options: Options, further: frozenset[Further]
) -> Compilation:
    """Leave half of the time to the runs: what is compiled twice in a row has to fit."""
    given, most = limits.compiler, _time_limit(limits, options) / 4
    wall = min(given.wall_seconds, max(SHORTEST_COMPILATION, int(most)))
    # Less CPU time than wall time, so that who computes too long is told from who waits.
    hurried = replace(given, wall_seconds=wall, seconds=min(given.seconds, wall * 2 // 3))
    return Compilation(folder, _isolation(options), hurried, further)


def _prepare(
    submission: Submission, order: Compilation, seed: int, summary: Summary
) -> tuple[Build, Plan, Solution]:
    """Compile the submission while the plan of its trials is made."""
    with ThreadPoolExecutor(1) as aside:
        building = aside.submit(compile_submission, submission, order)
        started = time.monotonic()
        solution = Solution()
        plan = solution.plan(seed)
        summary.plan_seconds = time.monotonic() - started
        return building.result(), plan, solution


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


def _waves(trials: Sequence[Trial]) -> tuple[list[Trial], list[Trial]]:
    """Part a and what shows quickly whether `intersect` uses the tree, then all the rest."""
    first = [
        trial
        for trial in trials
        if part_of(trial) == "a"
        or isinstance(trial, AlteredTrial)
        or (isinstance(trial, WorkTrial) and len(trial.mesh.faces) <= LARGE_MESH)
    ]
    chosen = {trial.name for trial in first}
    return first, [trial for trial in trials if trial.name not in chosen]


def _as_read(trial: Trial, rubric: Rubric) -> Trial:
    """Tell the trials of part a which reading of the sheet the rubric takes."""
    if isinstance(trial, ConstructTrial) and rubric.leaf_rule == "full-levels":
        return replace(trial, full_levels=True)
    return trial


def _hopeful(trial: Trial, summary: Summary) -> bool:
    """Tell whether a trial of part b can still earn something in bearable time.

    Without the tree nothing in part b counts; and where most triangles are tested for every
    ray, a large mesh takes hours.
    """
    if summary.closed("work.uses-the-tree"):
        return False
    large = isinstance(trial, ImageTrial | WorkTrial) and len(trial.mesh.faces) > LARGE_PICTURE
    return not (large and summary.failed("work.excludes-most-triangles"))


class _Run:
    """The workers of one submission, and what only the order of trials can decide."""

    def __init__(
        self,
        engines: Engines,
        solution: Solution,
        rubric: Rubric,
        options: Options,
        elapsed: float,
    ) -> None:
        limit = _time_limit(rubric.limits, options)
        self._engines = engines
        self._budget = Budget(rubric.limits, limit - _RESERVE * limit - elapsed)
        self._solution = solution
        self._rubric = rubric
        self._options = options
        self.small_depths: list[DepthCase] = []
        """Trees of the sanitized build, which say something only if they end at its limit."""

    def cases(self, trials: Sequence[Trial]) -> Iterator[Case]:
        """Run trials and yield what checks may look at, in the order of the trials."""
        reference = self._solution.cpu_seconds(trials)

        def progress(done: int, total: int) -> None:
            self._options.progress("running", done, total)

        for delivered in run_trials(trials, self._engines, self._budget, progress):
            for case in delivered:
                if isinstance(case, DepthCase) and case.trial.sanitized:
                    self.small_depths.append(case)
                elif isinstance(case, WorkCase):
                    yield replace(case, reference_cpu_seconds=reference[case.name])
                else:
                    yield case

    def grade(
        self, summary: Summary, given: Submission, build: Build, trials: Sequence[Trial]
    ) -> Grade:
        """Score what was found, and look for small inputs in what is left of the time."""
        grade = summary.grade(given, build, trials)
        if not self._options.counterexamples:
            return grade
        limit = _time_limit(self._rubric.limits, self._options)
        left = limit - _RESERVE / 3 * limit - summary.elapsed()
        deadline, hidden = time.monotonic() + left, not self._options.for_student
        search = Search(trials, self._engines, self._solution, deadline, hidden)
        with summary.stage("looking for small examples"):
            grade = with_counterexamples(grade, search)
        return replace(grade, timing=summary.timing(build))

    def further_trials(self) -> Sequence[Trial]:
        """Ask for the mesh of four million faces if small ones could not show the depth limit.

        A submission that says 20 instead of `maxDepth` is right, but does not see the smaller
        limit of the sanitized build.
        """
        wanted = any(one.check == "bvh.depth-is-limited" for one in self._rubric.criteria)
        small = self.small_depths
        if not wanted or (small and all(ends_at_the_limit(case) for case in small)):
            return ()
        return (depth_trial(self._options.seed),)

    def deeper_trials(self, summary: Summary) -> Sequence[Trial]:
        """Ask for a tree of level 20 where the submission's own trees have that level.

        Those of a submission that counts the root as level 1 end before, and it may rely on it.
        """
        reached = any(deepest_level(case) == case.max_depth for case in self.small_depths)
        deeper = deeper_trials(self._options.seed) if reached else ()
        return [trial for trial in deeper if _hopeful(trial, summary)]


def _engines(build: Build, limits: Limits, isolation: Isolation, nursery: Nursery) -> Engines:
    if build.library is None:
        raise AssertionError("there is a library, or nothing is run")
    runtime = sanitizer_runtime(find_compiler())

    def sanitized(library: Path | None) -> Engine | None:
        return Engine(library, limits, isolation, runtime, nursery) if library else None

    graded = Engine(build.library, limits, isolation, nursery=nursery)
    return Engines(graded, sanitized(build.sanitized), sanitized(build.deep))
