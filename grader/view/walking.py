"""Which nodes does a ray visit, one after the other, and where does it go wrong?"""

from dataclasses import dataclass

import numpy as np

from grader.counterexample.describe import explanation
from grader.counterexample.explain import Explanation, Setting
from grader.counterexample.shown import steps_of
from grader.language import Words
from grader.model.mesh import Bvh, Floats, FrozenArrays, Mesh
from grader.model.path import Path
from grader.model.trials import AlteredTrial, ImageTrial, RepeatTrial, TraceTrial, Trial
from grader.model.views import Step
from grader.verify.closest import closest_sure
from grader.view.shades import differing


@dataclass(frozen=True, slots=True, eq=False)
class Walk(FrozenArrays):
    """The way of one ray through a tree, as the submission's process tells it."""

    ray: Floats
    """(8,) float32, origin, direction, t_min, t_max."""

    steps: tuple[Step, ...]
    """The first tests, in order."""

    total: int
    """How many tests there were."""

    found: float
    """The t that was returned; infinite if nothing was hit."""

    expected: float | None
    """The t that is right; None if that is not known."""

    sentence: str
    """Why the result is wrong; empty if it is right, or if nothing is known."""

    lost: int
    """Node at which the hit was lost; -1 if there is none."""

    title: str
    """Which ray it is."""

    came_back: bool = True
    """Whether there is a result; if not, `found` and `steps` say nothing."""


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
    return Walk(
        ray=of.ray,
        steps=tuple(steps_of(setting)),
        total=path.total,
        found=path.found,
        expected=expected_of(of),
        sentence=told.text or of.note,
        lost=told.node,
        title=of.title,
    )


def unanswered(of: Followed) -> Walk:
    """Describe a ray of which nothing is known but how it begins: its process has ended."""
    return Walk(of.ray, (), 0, float("nan"), expected_of(of), "", -1, of.title, False)


def expected_of(of: Followed) -> float | None:
    """Return the t of the hit that a ray surely has; infinite if none, None if not known."""
    trial, index = of.trial, of.index
    if not isinstance(trial, TraceTrial | AlteredTrial | ImageTrial | RepeatTrial):
        return of.expected
    if isinstance(trial, AlteredTrial) and trial.lost[index]:
        return float("inf")
    nearest = closest_sure(trial.answers, index)
    return float(trial.answers.t[nearest]) if nearest >= 0 else float("inf")


def is_wrong(walk: Walk) -> bool:
    """Tell whether a ray got no answer, or another t than the right one, if that is known."""
    if walk.expected is None or not walk.came_back:
        return not walk.came_back
    pair = np.array([[walk.found], [walk.expected]], np.float32)
    return bool(differing(pair[0], pair[1])[0])


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
