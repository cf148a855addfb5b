"""Which checks and trials does a run need?"""

import difflib
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from grader.errors import UsageError
from grader.model.cases import BuildCase, DepthCase, MemoryCase, SourceCase, SurvivalCase
from grader.model.grade import Rubric
from grader.model.mesh import Mesh
from grader.model.stages import Further
from grader.model.trials import ConstructTrial, ImageTrial, Trial
from grader.oracle.plan import spine_trials
from grader.quick import quick_checks
from grader.run.trials import build_of, is_sanitized
from grader.score.rubric import BOTH, load_rubric
from grader.tolerances import FACES_PER_LEAF, SMALL_MAX_DEPTH
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

    asked: frozenset[str] = frozenset()
    """Ids of those that were asked for."""

    hidden: tuple[str, ...] = ()
    """Checks of the rubric that are not run, because a student is not to see them."""

    for_student: bool = False
    """Whether trials that a student is not to see are left out, too."""

    secret: frozenset[str] = frozenset()
    """Checks that the rubric shows to nobody, or not yet, whether they are run or not."""

    def useful(self, trials: Sequence[Trial]) -> tuple[Trial, ...]:
        """Leave out the trials that no check of this run looks at, or a student is not to see.

        Those that tell how deep a submission's trees are stay, if that chooses other trials.
        """
        choosing = self._looks_at(_deep_traces())
        return tuple(
            trial
            for trial in trials
            if (self._looks_at([trial]) or (choosing and DepthCase in kinds_of(trial)))
            and not (self.for_student and self.is_secret(trial))
        )

    def is_secret(self, trial: Trial) -> bool:
        """Tell whether a student must not learn what a trial's input is.

        The scene of its picture is hidden, or all checks that look at its results are. Whoever
        only asks how a worker ended looks at every trial, and would tell of those, too.
        """
        if isinstance(trial, ImageTrial) and not trial.shown:
            return True
        if not self.secret:
            return False
        # One with sanitizers has the input of an ordinary one.
        trial = replace(trial, sanitized=False) if is_sanitized(trial) else trial  # type: ignore[arg-type]  # those have the field
        looking = [
            each.id
            for each in every_check()
            if each.kind not in (SurvivalCase, MemoryCase)
            and each.kind in kinds_of(trial)
            and each.when(trial)
        ]
        return bool(looking) and self.secret.issuperset(looking)

    @property
    def runs_nothing(self) -> bool:
        """Whether what the compiler says is enough for all checks of this run."""
        return all(each.kind in (BuildCase, SourceCase) for each in self.checks)

    @property
    def further(self) -> frozenset[Further]:
        """What has to be made of a submission beside its graded library.

        The calls for everything that runs: a report names the line of a function with them.
        """
        needed = (build_of(trial) for trial in self.useful([_small_depth(), *_deep_traces()]))
        calls = [] if all(each.kind is BuildCase for each in self.checks) else [Further.CALLS]
        return frozenset((*calls, *filter(None, needed)))

    def _looks_at(self, trials: Iterable[Trial]) -> bool:
        """What others need is decided without sanitizers, whose builds take longest to make."""
        return any(
            each.kind in kinds_of(trial) and each.when(trial)
            for trial in trials
            for each in self.checks
            if each.id in self.asked or not is_sanitized(trial)
        )


def _small_depth() -> Trial:
    """Make a trial like all those of part a with sanitizers, and as deep as any."""
    faces = np.zeros(((FACES_PER_LEAF << SMALL_MAX_DEPTH) + 1, 3), np.uint32)
    return ConstructTrial("small depth", Mesh(np.zeros((1, 3), np.float32), faces), True)


@cache
def _deep_traces() -> tuple[Trial, ...]:
    """Make trials like those on deep trees, one of each build."""
    return tuple(spine_trials(0, 2))


def select(
    rubric_path: Path | None, only: Sequence[str], for_student: bool = False
) -> Selection:
    """Read the rubric and choose the checks.

    Args:
        rubric_path: The instructor's rubric; None for the shipped one.
        only: Ids of the checks to score; all of the rubric if empty.
        for_student: Leave out what the rubric hides, so that nothing of it is run or told.

    Raises:
        UsageError: The rubric is wrong, or an id does not exist or is hidden.
    """
    rubric, checks = load_rubric(rubric_path), every_check()
    secret = frozenset(one.check for one in rubric.criteria if one.visibility != "visible")
    hidden = _hidden(secret, checks) if for_student else frozenset()
    for id in only:
        _require_shown(rubric_path, id, hidden)
    shown = [criterion for criterion in rubric.criteria if criterion.check not in hidden]
    if not shown:
        raise UsageError("the rubric hides every check, so there is nothing to run")
    # A gate closes its own part only.
    parts = {BOTH, *(criterion.part for criterion in shown if criterion.check in only)}
    gates = {one.check for one in shown if one.gate and one.part in parts}
    wanted = {*only, *gates} if only else {one.check for one in shown}
    wanted = _closure({each.id: (*each.needs, *each.blames) for each in checks}, wanted)
    criteria = tuple(
        criterion
        for criterion in shown
        if not only
        or criterion.check in only
        or (criterion.check in gates and not criterion.points)
    )
    return Selection(
        replace(rubric, criteria=criteria),
        tuple(each for each in checks if each.id in wanted),
        frozenset(only or wanted),
        tuple(one.check for one in rubric.criteria if one.check in hidden),
        for_student,
        secret,
    )


def quickest(rubric_path: Path | None, for_student: bool) -> tuple[str, ...]:
    """Return the checks of a rubric that find most mistakes in little time.

    Raises:
        UsageError: The rubric is wrong.
    """
    rubric = select(rubric_path, (), for_student).rubric
    return quick_checks([criterion.check for criterion in rubric.criteria])


def require_check(rubric_path: Path | None, id: str, option: str) -> None:
    """Accept only a check of a rubric.

    Args:
        rubric_path: The instructor's rubric; None for the shipped one.
        id: Of the check.
        option: That named it.

    Raises:
        UsageError: The rubric is wrong, or has no such check.
    """
    known = [criterion.check for criterion in load_rubric(rubric_path).criteria]
    if id not in known:
        near = ", ".join(difflib.get_close_matches(id, known, 3, 0.3)) or ", ".join(known)
        raise UsageError(f"{option} {id}: there is no such check, but perhaps {near}")


def _require_shown(rubric_path: Path | None, id: str, hidden: frozenset[str]) -> None:
    """Accept only a check that can be run."""
    require_check(rubric_path, id, "--only")
    if id in hidden:
        raise UsageError(f"--only {id}: the rubric hides this check, so it is not run here")


def _hidden(secret: Collection[str], checks: Sequence[Check]) -> frozenset[str]:
    """Name the checks that a student does not see, and those that would tell of them.

    A check that waits for a hidden one says by waiting that the hidden one fails.
    """
    waits: dict[str, list[str]] = {}
    for each in checks:
        for other in (*each.needs, *each.blames):
            waits.setdefault(other, []).append(each.id)
    return frozenset(_closure(waits, secret))


def _closure(links: Mapping[str, Iterable[str]], start: Iterable[str]) -> set[str]:
    """Return the names of `start`, those that they lead to, and those that these lead to."""
    found = set(start)
    waiting = list(found)
    while waiting:
        for name in links.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found
