"""How many cases does a right submission give each check to examine, and what do they weigh?"""

from collections.abc import Sequence
from fractions import Fraction

from grader.model.cases import (
    AlteredCase,
    BuildCase,
    DepthCase,
    HitCase,
    ImageCase,
    MemoryCase,
    RebuildCase,
    RepeatCase,
    SourceCase,
    SurvivalCase,
    TreeCase,
    WorkCase,
)
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.tolerances import reaches_the_limit
from grader.verify.check import Check

DELIVERED: dict[type, type] = {
    RebuildTrial: RebuildCase,
    TraceTrial: HitCase,
    AlteredTrial: AlteredCase,
    WorkTrial: WorkCase,
    RepeatTrial: RepeatCase,
    ImageTrial: ImageCase,
}


def planned_cases(checks: Sequence[Check], trials: Sequence[Trial]) -> dict[str, Fraction]:
    """Add up, per check, what the cases weigh that the reference would give it."""
    deep = {trial.name for trial in trials if DepthCase in kinds_of(trial)}
    full = {trial.name for trial in trials if not _is_small(trial)} & deep

    def counts(each: Check, trial: Trial) -> bool:
        # Once the large mesh is needed, the small ones say nothing about the depth limit.
        if each.kind is DepthCase and full and trial.name not in full:
            return False
        return each.kind in kinds_of(trial) and each.when(trial)

    return {
        each.id: _once(each, trials)
        + sum((weight_of(trial) for trial in trials if counts(each, trial)), Fraction(0))
        for each in checks
    }


def weight_of(trial: Trial) -> Fraction:
    """Return how many ordinary cases a trial counts for: 1, if no scene says otherwise.

    Exact, and 0.1 is a tenth: three of them and half of six are the same.
    """
    return Fraction(str(trial.weight)) if isinstance(trial, ImageTrial) else Fraction(1)


def _once(each: Check, trials: Sequence[Trial]) -> int:
    """Count the cases that come from no trial; a file that does not compile has no calls."""
    return int(each.kind is BuildCase or (each.kind is SourceCase and bool(trials)))


def _is_small(trial: Trial) -> bool:
    return isinstance(trial, ConstructTrial) and trial.sanitized


def kinds_of(trial: Trial) -> tuple[type, ...]:
    """The kinds of cases that a trial delivers if its worker finishes."""
    if isinstance(trial, ConstructTrial):
        return _construct_kinds(trial)
    if isinstance(trial, RebuildTrial | TraceTrial | RepeatTrial) and trial.sanitized:
        return (MemoryCase,)
    return (SurvivalCase, DELIVERED[type(trial)])


def _construct_kinds(trial: ConstructTrial) -> tuple[type, ...]:
    ended = MemoryCase if trial.sanitized else SurvivalCase
    limited = reaches_the_limit(len(trial.mesh.faces), trial.sanitized)
    depth = (DepthCase,) if limited else ()
    return (ended, *depth, TreeCase) if limited == trial.sanitized else (ended, *depth)
