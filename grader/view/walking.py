"""Which nodes does a ray visit, one after the other, and where does it go wrong?"""

from dataclasses import dataclass

import numpy as np

from grader.counterexample.describe import explanation
from grader.counterexample.explain import Explanation, Setting
from grader.counterexample.shown import steps_of
from grader.language import Words
from grader.model.mesh import Bvh, Floats, FrozenArrays, Mesh
from grader.model.path import Path
from grader.model.trials import AlteredTrial, ImageTrial, TraceTrial, Trial
from grader.model.views import Step
from grader.verify.closest import closest_sure


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


def walk_of(mesh: Mesh, tree: Bvh, path: Path, of: Followed) -> Walk:
    """Describe a recorded path.

    Args:
        mesh: The mesh.
        tree: The tree that was walked.
        path: What was recorded.
        of: Which ray it is of.
    """
    setting = Setting(mesh, tree, path)
    told, expected = Explanation(""), None
    if isinstance(of.trial, TraceTrial | AlteredTrial | ImageTrial):
        with np.errstate(all="ignore"):
            told = explanation(setting, of.trial, of.index)
        expected = expected_of(of.trial, of.index)
    return Walk(
        ray=of.ray,
        steps=tuple(steps_of(setting)),
        total=path.total,
        found=path.found,
        expected=expected,
        sentence=told.text,
        lost=told.node,
        title=of.title,
    )


def expected_of(trial: TraceTrial | AlteredTrial | ImageTrial, index: int) -> float:
    """Return the t of the hit that a ray surely has; infinite if it has none."""
    if isinstance(trial, AlteredTrial) and trial.lost[index]:
        return float("inf")
    nearest = closest_sure(trial.answers, index)
    return float(trial.answers.t[nearest]) if nearest >= 0 else float("inf")


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
