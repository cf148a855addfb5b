"""Is a returned `t` the closest hit? The one place that applies the rule of closest hits.

Wrong "missed a closer hit": some SOLID triangle lies surely before `t`. Wrong "no surface
there": `t` is finite, but no SOLID or EDGE triangle lies within its own tolerance of it. If a
WILD triangle lies on that ray, float32 cannot decide, and the ray is not counted.
"""

from dataclasses import dataclass

import numpy as np

from grader.model.mesh import (
    SOLID,
    WILD,
    Answers,
    Doubles,
    Floats,
    FrozenArrays,
    Integers,
    Mask,
)


@dataclass(frozen=True, slots=True, eq=False)
class Judgement(FrozenArrays):
    """What the rule says of one `t` per ray."""

    missed_closer: Mask
    """(R,) bool, True where a SOLID triangle lies surely before `t`."""

    no_surface: Mask
    """(R,) bool, True where `t` is no miss and no triangle is there; always so for NaN."""

    uncounted: Mask
    """(R,) bool, True where only a WILD triangle could explain `t`: neither right nor wrong."""

    accepted: Integers
    """(R,) int64, candidate nearest to `t` among those that explain it; -1 if there is none."""

    near: Mask
    """(C,) bool, True for each SOLID or EDGE candidate that its ray's `t` may mean."""


def judge(answers: Answers, t: Floats) -> Judgement:
    """Hold one returned distance per ray against the candidates of its ray.

    Args:
        answers: The candidates of each ray.
        t: (R,) float32 as returned; positive infinity is a miss, NaN and -inf are never right.
    """
    claimed = t.astype(np.float64)
    ray = owners(answers)
    finite = np.isfinite(claimed)
    with np.errstate(invalid="ignore"):
        distance = np.abs(claimed[ray] - answers.t)
        near = (answers.kind != WILD) & (distance <= answers.tolerance) & finite[ray]
        missed_closer = claimed > answers.limit
    accepted = _nearest(ray, near, distance, t.size)
    wild = np.zeros(t.size, dtype=np.bool_)
    wild[ray[answers.kind == WILD]] = True
    unexplained = ~missed_closer & (accepted < 0) & (claimed != np.inf)
    uncounted = unexplained & wild & finite
    return Judgement(
        missed_closer=missed_closer,
        no_surface=unexplained & ~uncounted,
        uncounted=uncounted,
        accepted=accepted,
        near=near,
    )


def owners(answers: Answers) -> Integers:
    """Return (C,) int64, the ray that each candidate belongs to."""
    return np.repeat(np.arange(answers.limit.size), np.diff(answers.first))


def is_ambiguous(answers: Answers) -> Mask:
    """Return (R,) bool, True where an EDGE or WILD triangle leaves room for two answers."""
    ray = owners(answers)
    ambiguous = np.zeros(answers.limit.size, dtype=np.bool_)
    ambiguous[ray[answers.kind != SOLID]] = True
    return ambiguous


def _nearest(ray: Integers, near: Mask, distance: Doubles, rays: int) -> Integers:
    """Return (R,) int64, each ray's candidate of `near` with the smallest distance, or -1."""
    found = np.flatnonzero(near)
    descending = found[np.argsort(-distance[found], kind="stable")]
    nearest = np.full(rays, -1, dtype=np.int64)
    nearest[ray[descending]] = descending
    return nearest


def closest_sure(answers: Answers, ray: int) -> int:
    """Return the candidate that a ray surely hits first; -1 if it surely hits nothing."""
    start, stop = answers.first[ray], answers.first[ray + 1]
    solid = start + np.flatnonzero(answers.kind[start:stop] == SOLID)
    return int(solid[np.argmin(answers.t[solid])]) if solid.size else -1
