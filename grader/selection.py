"""Which checks and trials does a run need?"""

import difflib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from grader.errors import UsageError
from grader.model.grade import Rubric
from grader.model.trials import Trial
from grader.score.rubric import load_rubric
from grader.verify import every_check
from grader.verify.check import Check
from grader.verify.planned import kinds_of


@dataclass(frozen=True, slots=True)
class Selection:
    """A rubric, and the checks that it or the caller asks for."""

    rubric: Rubric
    """Only the criteria that are scored in this run."""

    checks: tuple[Check, ...]
    """All checks to decide, those included that others need."""

    def useful(self, trials: Sequence[Trial]) -> tuple[Trial, ...]:
        """Leave out the trials that no check of this run looks at."""
        return tuple(
            trial
            for trial in trials
            if any(each.kind in kinds_of(trial) and each.when(trial) for each in self.checks)
        )


def select(rubric_path: Path | None, only: Sequence[str]) -> Selection:
    """Read the rubric and choose the checks.

    Args:
        rubric_path: The instructor's rubric; None for the shipped one.
        only: Ids of the checks to score; all of the rubric if empty.

    Raises:
        UsageError: The rubric is wrong, or an id does not exist.
    """
    rubric = load_rubric(rubric_path)
    checks = every_check()
    known = [criterion.check for criterion in rubric.criteria]
    for id in only:
        if id not in known:
            near = ", ".join(difflib.get_close_matches(id, known, 3, 0.3)) or ", ".join(known)
            raise UsageError(f"--only {id}: there is no such check, but perhaps {near}")
    gates = [criterion.check for criterion in rubric.criteria if criterion.gate]
    wanted = _with_needs(checks, {*only, *gates} if only else set(known))
    criteria = tuple(
        criterion
        for criterion in rubric.criteria
        if not only or criterion.check in only or (criterion.gate and not criterion.points)
    )
    return Selection(
        Rubric(criteria, rubric.titles, rubric.limits, rubric.leaf_rule, rubric.sha256),
        tuple(each for each in checks if each.id in wanted),
    )


def _with_needs(checks: Sequence[Check], wanted: set[str]) -> set[str]:
    """Add what the wanted checks need, and what those need."""
    needs = {each.id: each.needs for each in checks}
    waiting = list(wanted)
    while waiting:
        for need in needs.get(waiting.pop(), ()):
            if need not in wanted:
                wanted.add(need)
                waiting.append(need)
    return wanted
