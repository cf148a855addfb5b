"""Which small input shows each failing check? Looked for after everything else is decided.

A reduction is bounded by processes and candidates, never by the clock, so that two grades of
one submission with one seed show the same. The clock is a fence behind that: a reduction that
runs into it, which takes a machine many times too busy, is dropped as a whole, and the check
has no counterexample then. Neither changes a verdict or a point.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from grader.counterexample.describe import described
from grader.counterexample.narrow import Narrowing
from grader.counterexample.probe import Effort, Probe, TooLate, decided, sizes, steady
from grader.errors import let_go
from grader.model.counterexample import Counterexample
from grader.model.grade import CheckScore, Grade
from grader.model.trials import ImageTrial, Trial
from grader.model.verdict import Verdict
from grader.run.trials import Engines, is_sanitized
from grader.solution import Solution
from grader.verify import every_check
from grader.verify.check import Check

CHECK_SECONDS = 2.0
"""CPU seconds after which one check's reduction is dropped; most take less than half of it."""

CROWDED = 10
"""The clock may show so many times that: others may be using the processors."""

STARTS = 2
"""The smallest of the failing cases that are tried; the second if the first fails no more."""

LARGEST_START = 25_000
"""Faces of a case that is tried: sending a larger one to a process takes all of the time."""

MOST_FACES, MOST_RAYS = 1_000, 1_500
"""What is larger teaches nobody anything, and fills files."""


@dataclass(frozen=True, slots=True)
class Search:
    """What is needed to look for counterexamples of one submission."""

    trials: Sequence[Trial]
    engines: Engines
    solution: Solution
    deadline: float
    """Of `time.monotonic`, for all checks together."""

    hidden: bool
    """Whether checks that the rubric hides from students get one, too."""

    is_secret: Callable[[Trial], bool]
    """Tells of which trials no visible check may show anything."""


def with_counterexamples(grade: Grade, search: Search) -> Grade:
    """Give each failed check of a grade the smallest input that was found."""
    return replace(
        grade,
        checks=tuple(
            replace(score, counterexample=_found(score, search))
            if score.verdict is Verdict.FAIL and (search.hidden or _is_open(score))
            else score
            for score in grade.checks
        ),
    )


def _is_open(score: CheckScore) -> bool:
    return score.visibility == "visible"


def _is_told(trial: Trial, score: CheckScore, search: Search) -> bool:
    """A counterexample tells where it comes from, so none comes from a hidden scene."""
    if isinstance(trial, ImageTrial) and not trial.shown:
        return False
    return not (_is_open(score) and search.is_secret(trial))


def _found(score: CheckScore, search: Search) -> Counterexample | None:
    try:
        return counterexample(score, search)
    except TooLate:
        return None
    except Exception as fault:  # noqa: BLE001 - nothing is decided here: it costs an example
        let_go(fault)
        return None


def counterexample(score: CheckScore, search: Search) -> Counterexample | None:
    """Look for the smallest input that fails one check; None if nothing steady was found.

    Raises:
        TooLate: It took too long.
        GraderError: A process could not be started or fed.
    """
    check = next(each for each in every_check() if each.id == score.check)
    failed = {name for name, verdict in score.cases if verdict is Verdict.FAIL}
    known = [trial for trial in search.trials if trial.name in failed]
    known = [trial for trial in known if _is_told(trial, score, search)]
    known = [trial for trial in known if sizes(trial)[0] <= LARGEST_START]
    fence = min(time.monotonic() + CROWDED * CHECK_SECONDS, search.deadline)
    effort = Effort(fence, CHECK_SECONDS)
    for trial in sorted(known, key=sizes)[:STARTS]:
        probe = Probe(check, search.engines, effort, score.stop)
        if found := _reduced(probe, check, trial, search.solution):
            return found
    return None


def _reduced(
    probe: Probe, check: Check, start: Trial, solution: Solution
) -> Counterexample | None:
    """Make a trial smaller, and prove that it fails here and not with the model solution."""
    trial = Narrowing(probe, solution.fresh_trees).smaller(start)
    faces, rays = sizes(trial)
    if faces > MOST_FACES or rays > MOST_RAYS:
        return None
    evidence = probe.proof(trial)
    if evidence is None or not model_passes(check, solution, trial):
        return None
    return described(probe, trial, start.name, evidence)


def model_passes(check: Check, solution: Solution, trial: Trial) -> bool:
    """Tell whether the model solution passes; it has no build with sanitizers.

    Raises:
        WorkerFault: It did not come back.
    """
    if is_sanitized(trial):
        return True
    findings = [decided(check, steady(case)) for case in solution.cases(trial)]
    return any(one is not None and one.verdict is Verdict.PASS for one in findings)
