"""In which rounds do the trials of a submission run, and what does one decide for the next?"""

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace

from grader.counterexample.search import Search, with_counterexamples
from grader.gallery.gallery import Gallery
from grader.model.cases import Case, DepthCase, MemoryCase, SurvivalCase, WorkCase
from grader.model.grade import Grade, Limits, Rubric
from grader.model.stages import Build, Stop, Submission
from grader.model.trials import AlteredTrial, ImageTrial, Trial, WorkTrial, part_of
from grader.options import Options
from grader.oracle.plan import deeper_trials, depth_trial
from grader.run.session import Engine
from grader.run.trials import Budget, Engines, at_once, run_trials
from grader.solution import Solution, beside
from grader.summary import Summary
from grader.tolerances import LARGE_MESH
from grader.verify.structure import deepest_level, ends_at_the_limit

_RESERVE = 0.15
"""Share of the time limit that is kept for judging what the last workers brought."""

USUAL_COMPILING = 15.0
"""Own seconds of all compilers together that are taken from nobody's time: right files take up
to 7, on a busy machine more."""

LARGE_PICTURE = 100_000
"""A mesh of more faces is not tried where `intersect` has been seen to test most of them."""


def waves(trials: Sequence[Trial]) -> tuple[list[Trial], list[Trial]]:
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


def hopeful(trial: Trial, summary: Summary) -> bool:
    """Tell whether a trial of part b can still earn something in bearable time.

    Without the tree nothing in part b counts; and where most triangles are tested for every
    ray, a large mesh takes hours.
    """
    if summary.closed("work.uses-the-tree"):
        return False
    large = isinstance(trial, ImageTrial | WorkTrial) and len(trial.mesh.faces) > LARGE_PICTURE
    return not (large and summary.failed("work.excludes-most-triangles"))


def budget_of(limits: Limits, options: Options, elapsed: float, compiling: float) -> Budget:
    """Divide what is left of the time of a grade.

    Args:
        limits: Of the rubric.
        options: May ask for less time than they give.
        elapsed: Wall seconds of the grade so far.
        compiling: Own seconds of the submission's compilers, all together. Who takes long there
            has less time to use up, and could never use up enough of the whole.
    """
    limit = options.most_seconds(limits)
    whole = limit - _RESERVE * limit
    unusual = max(0.0, compiling - USUAL_COMPILING)
    return Budget(limits, whole - elapsed, whole - unusual / at_once())


class Rounds:
    """The workers of one submission, and what only the order of trials can decide."""

    def __init__(
        self,
        engines: Engines,
        solution: Solution,
        rubric: Rubric,
        options: Options,
        budget: Budget,
    ) -> None:
        """Begin.

        Args:
            engines: The builds of the submission.
            solution: Ours.
            rubric: What is scored, within which limits.
            options: How to grade.
            budget: The time that is left.
        """
        self._engines, self._budget = engines, budget
        self._solution = solution
        self._rubric = rubric
        self._options = options
        self._gallery = Gallery(engines.graded, rubric.scenes)
        self._vouched: list[Engine] = []
        self.small_depths: list[DepthCase] = []
        """Trees of the sanitized build, which say something only if they end at its limit."""

        self._reached = False
        """Some tree of the submission has the level of the depth limit, the root being 0."""

    def cases(self, trials: Sequence[Trial]) -> Iterator[Case]:
        """Run trials and yield what checks may look at, in the order of the trials."""
        reference = self._solution.work(trials)

        def progress(done: int, total: int) -> None:
            self._options.progress("running", done, total)

        for delivered in run_trials(trials, self._engines, self._budget, progress):
            for case in delivered:
                self._vouch(case)
                if self._options.views:
                    self._gallery.note(case)
                if isinstance(case, DepthCase):
                    self._reached |= deepest_level(case) == case.max_depth
                if isinstance(case, DepthCase) and case.trial.sanitized:
                    self.small_depths.append(case)
                elif isinstance(case, WorkCase):
                    yield beside(case, reference[case.name])
                else:
                    yield case

    def _vouch(self, case: Case) -> None:
        """Blame nobody for not starting where our own solution does not start either."""
        if not isinstance(case, SurvivalCase | MemoryCase):
            return
        engine = self._engines.of(case.trial)
        if case.ending.stop is not Stop.FAILED_TO_START or engine is None:
            return
        if engine not in self._vouched:
            self._vouched.append(engine)
            self._solution.vouch(engine)

    def grade(
        self, summary: Summary, given: Submission, build: Build, trials: Sequence[Trial]
    ) -> Grade:
        """Score what was found; look for small inputs and draw in what is left of the time."""
        grade = summary.grade(given, build, trials)
        if self._options.counterexamples:
            deadline = time.monotonic() + self._left(summary)
            hidden = not self._options.for_student
            is_secret = summary.selection.is_secret
            search = Search(trials, self._engines, self._solution, deadline, hidden, is_secret)
            with summary.stage("looking for small examples"):
                grade = with_counterexamples(grade, search)
        if self._options.views:
            with summary.stage("drawing"):
                grade = self._gallery.shown(grade, trials, self._left(summary))
        return replace(grade, timing=summary.timing(build))

    def _left(self, summary: Summary) -> float:
        """Wall seconds for what decides nothing any more."""
        limit = self._options.most_seconds(self._rubric.limits)
        return limit - _RESERVE / 3 * limit - summary.elapsed()

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
        deeper = deeper_trials(self._options.seed) if self._reached else ()
        return [trial for trial in deeper if hopeful(trial, summary)]
