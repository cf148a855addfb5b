"""Which nodes does a ray visit, one after the other, and where does it go wrong?"""

from dataclasses import dataclass

import numpy as np

from grader.counterexample.explain import Explanation, Setting
from grader.counterexample.describe import explanation
from grader.counterexample.shown import steps_of
from grader.model.mesh import Bvh, Floats, FrozenArrays, Mesh
from grader.model.path import Path
from grader.model.trials import AlteredTrial, ImageTrial, TraceTrial, Trial
from grader.model.views import Step
from grader.verify.closest import closest_sure

NEAR = 1e-3
"""Two hits are told apart from here on, relative to the larger one."""


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

    title: str = ""
    """Which ray it is."""


def walk_of(
    mesh: Mesh, tree: Bvh, path: Path, ray: Floats, title: str, trial: Trial | None, index: int
) -> Walk:
    """Describe a recorded path.

    Args:
        mesh: The mesh.
        tree: The tree that was walked.
        path: What was recorded.
        ray: (8,) float32.
        title: Which ray it is.
        trial: What is asked of the ray, if it is one of a counterexample.
        index: Of the ray in the trial.
    """
    setting = Setting(mesh, tree, path)
    told, expected = Explanation(""), None
    if isinstance(trial, TraceTrial | AlteredTrial | ImageTrial):
        with np.errstate(all="ignore"):
            told = explanation(setting, trial, index)
        expected = expected_of(trial, index)
    return Walk(
        ray, tuple(steps_of(setting)), path.total, path.found, expected, told.text, told.node, title
    )


def expected_of(trial: TraceTrial | AlteredTrial | ImageTrial, index: int) -> float:
    """Return the t of the hit that a ray surely has; infinite if it has none."""
    if isinstance(trial, AlteredTrial) and trial.lost[index]:
        return float("inf")
    nearest = closest_sure(trial.answers, index)
    return float(trial.answers.t[nearest]) if nearest >= 0 else float("inf")


def deepest_known(walk: Walk) -> int:
    """Return the step at which the hit was lost; -1 if the walk never came near."""
    node = walk.lost
    while node >= 0:
        places = [place for place, one in enumerate(walk.steps) if one.node == node]
        if places:
            return places[-1]
        node = (node + 1) // 2 - 1
    return -1
