"""Which nodes does a ray visit, one after the other, and where does it go wrong?"""

from dataclasses import dataclass

import numpy as np

from grader.counterexample.describe import explanation
from grader.counterexample.explain import Explanation, Setting
from grader.counterexample.shown import steps_of
from grader.language import Words
from grader.model.mesh import Answers, Bvh, Floats, FrozenArrays, Mesh
from grader.model.path import Path
from grader.model.trials import AlteredTrial, ImageTrial, RepeatTrial, TraceTrial, Trial
from grader.model.views import Step
from grader.verify.closest import closest_sure, is_ambiguous, judge
from grader.view.shades import differing

Judged = TraceTrial | AlteredTrial | ImageTrial | RepeatTrial
"""Trials that know what is right for each of their rays."""


@dataclass(frozen=True, slots=True, eq=False)
class Followed(FrozenArrays):
    """A ray whose way is asked for."""

    ray: Floats
    """(8,) float32."""

    title: str
    """Which ray it is."""

    trial: Trial | None = None
    """What is asked of it, if it is one of a counterexample."""

    index: int = -1
    """Of the ray in the trial."""

    expected: float | None = None
    """The t that is right, if no trial says it; None if that is not known."""

    note: str = ""
    """What is known to be wrong with it, if not t."""


@dataclass(frozen=True, slots=True, eq=False)
class Walk(FrozenArrays):
    """The way of one ray through a tree, as the submission's process tells it."""

    of: Followed
    """Which ray it is of."""

    steps: tuple[Step, ...]
    """The first tests, in order."""

    total: int
    """How many tests there were."""

    found: float
    """The t that was returned; infinite if nothing was hit."""

    expected: float | None
    """The t that is right; None if that is not known, or if another one is right, too."""

    wrong: bool | None
    """Whether another t is right, or no answer came; None if that is not known."""

    sentence: str
    """Why the result is wrong; empty if it is right, or if nothing is known."""

    lost: int
    """Node at which the hit was lost; -1 if there is none."""

    came_back: bool = True
    """Whether there is a result; if not, `found` and `steps` say nothing."""

    @property
    def ray(self) -> Floats:
        """(8,) float32, origin, direction, t_min, t_max."""
        return self.of.ray


def walk_of(mesh: Mesh, tree: Bvh, path: Path, of: Followed) -> Walk:
    """Describe a recorded path.

    Args:
        mesh: The mesh.
        tree: The tree that was walked.
        path: What was recorded.
        of: Which ray it is of.
    """
    setting = Setting(mesh, tree, path)
    told = Explanation("")
    if isinstance(of.trial, TraceTrial | AlteredTrial | ImageTrial):
        with np.errstate(all="ignore"):
            told = explanation(setting, of.trial, of.index)
    expected, wrong = _judged(of, path.found)
    return Walk(
        of=of,
        steps=tuple(steps_of(setting)),
        total=path.total,
        found=path.found,
        expected=expected,
        wrong=wrong,
        sentence=told.text or of.note,
        lost=told.node,
    )


def unanswered(of: Followed) -> Walk:
    """Describe a ray of which nothing is known but how it begins: its process has ended."""
    nothing = float("nan")
    return Walk(of, (), 0, nothing, _judged(of, nothing)[0], True, "", -1, came_back=False)


def _judged(of: Followed, found: float) -> tuple[float | None, bool | None]:
    """Return `expected` and `wrong` of a `Walk`, by the rule of closest hits if possible."""
    t, trial = np.array([found], np.float32), of.trial
    if not isinstance(trial, Judged):
        if of.expected is None:
            return None, None
        return of.expected, bool(differing(t, np.array([of.expected], np.float32))[0])
    answers = _of_one(trial.answers, of.index)
    said = judge(answers, t)
    missed = bool(said.missed_closer[0])
    if isinstance(trial, AlteredTrial) and trial.lost[of.index]:
        # Behind what is gone there may be another face, of which nothing is known here.
        return None, bool(said.accepted[0] >= 0) and not missed
    wrong = missed or bool(said.no_surface[0])
    if is_ambiguous(answers)[0] and not wrong:
        return None, False
    nearest = closest_sure(answers, 0)
    return (float(answers.t[nearest]) if nearest >= 0 else float("inf")), wrong


def _of_one(answers: Answers, ray: int) -> Answers:
    """Take what is known of one ray."""
    start, stop = answers.first[ray : ray + 2].tolist()
    kept = slice(start, stop)
    return Answers(
        answers.limit[ray : ray + 1],
        np.array([0, stop - start]),
        answers.face[kept],
        answers.t[kept],
        answers.tolerance[kept],
        answers.kind[kept],
    )


def outcome_of(walk: Walk, words: Words) -> str:
    """Say what came of a ray."""
    if not walk.came_back:
        return words("no answer")
    if not walk.found < np.inf:
        return words("no hit")
    return words("hit at t = {t}").format(t=f"{walk.found:.6g}")


def right_of(walk: Walk, words: Words) -> str:
    """Say what should have come of a ray; empty if that is not known."""
    if walk.expected is None:
        return ""
    right = f"{walk.expected:.6g}" if walk.expected < np.inf else words("no hit")
    return words("expected: {right}").format(right=right)


def cut_off(walk: Walk, words: Words) -> str:
    """Say that only the first tests are told; empty if all are."""
    if len(walk.steps) >= walk.total:
        return ""
    return words("Only the first {count} steps are kept.").format(count=len(walk.steps))


def deepest_known(walk: Walk) -> int:
    """Return the step at which the hit was lost; -1 if the walk never came near."""
    node = walk.lost
    while node >= 0:
        places = [place for place, one in enumerate(walk.steps) if one.node == node]
        if places:
            return places[-1]
        node = (node + 1) // 2 - 1
    return -1
