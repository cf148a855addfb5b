"""What would rays of a case meet if `intersect` did something else? All faces at once.

Of a case only some rays are looked at, and every face is tested for each of them, so that any
mistaken way through the tree can be foretold from one table of distances.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.cases import HitCase
from grader.model.mesh import Doubles, FrozenArrays, Integers, Mask
from grader.verify.closest import is_ambiguous, judge

MOST_RAYS = 96
MOST_WRONG = 48
"""So many rays are looked at, from all over a case, and so many more that are wrong."""

MOST_FACES = 1_500

SAME = 1e-4
"""Relative difference up to which two distances are taken for the same hit."""


@dataclass(frozen=True, slots=True, eq=False)
class Shots(FrozenArrays):
    """Some rays of a case against all faces; S shots, F faces."""

    ray: Integers
    """(S,) int64, which rays of the case."""

    origin: Doubles
    direction: Doubles
    """(S, 3) float64 each, world space."""

    t_min: Doubles
    t_max: Doubles
    """(S,) float64 each, in multiples of the direction's length."""

    t: Doubles
    """(S, F) float64, where a ray meets the plane of a face; infinite where it is parallel."""

    u: Doubles
    v: Doubles
    """(S, F) float64, barycentric coordinates there."""

    side: Doubles
    """(S, F) float64, the determinant: its sign tells from which side the face is seen."""

    got: Doubles
    """(S,) float64, what the submission returned."""

    right: Mask
    """(S,) bool, True where that is right."""

    limit: Doubles
    """(S,) float64, where the closest sure hit is, but for a tolerance; infinite if none is."""

    unambiguous: Mask
    """(S,) bool, True where no doubtful face is on the ray."""


@dataclass(frozen=True, slots=True, eq=False)
class Met(FrozenArrays):
    """The hits of some rays, one after the other: a sparse table; H hits."""

    shots: int
    ray: Integers
    """(H,) int64, which shot."""

    face: Integers
    """(H,) int64, which face."""

    t: Doubles
    """(H,) float64, where on the ray."""

    def only(self, kept: Mask) -> "Met":
        """Leave out hits where `kept`, (H,) bool, is False."""
        return Met(self.shots, self.ray[kept], self.face[kept], self.t[kept])

    def closest(self) -> Doubles:
        """(S,) float64, the smallest t of each ray; infinite without a hit."""
        least = np.full(self.shots, np.inf)
        np.minimum.at(least, self.ray, self.t)
        return least


@lru_cache(maxsize=64)
def all_met(given: Shots) -> Met:
    """Every triangle that a ray meets, whatever its limits say."""
    return met_where(given, (given.u >= 0) & (given.v >= 0) & (given.u + given.v <= 1))


def met_where(given: Shots, meets: Mask) -> Met:
    """Every triangle that a ray meets by another test than ours.

    Args:
        given: The rays.
        meets: (S, F) bool, what that test says of the point in the plane.
    """
    ray, face = np.nonzero(meets & np.isfinite(given.t))
    return Met(len(given.ray), ray, face, given.t[ray, face])


def within(given: Shots, met: Met, t_min: Doubles | float, t_max: Doubles | float) -> Met:
    """Leave out hits beyond some limits, each a number or (S,) float64."""
    low = np.broadcast_to(np.asarray(t_min, dtype=np.float64), (met.shots,))
    high = np.broadcast_to(np.asarray(t_max, dtype=np.float64), (met.shots,))
    return met.only((met.t > low[met.ray]) & (met.t < high[met.ray]))


@lru_cache(maxsize=64)
def limited(given: Shots) -> Met:
    """Every triangle that a ray meets within its limits."""
    return within(given, all_met(given), given.t_min, given.t_max)


@lru_cache(maxsize=64)
def shots(case: HitCase) -> Shots | None:
    """Test every face for some rays of a case; None if there are too many faces, or none."""
    mesh, rays, answers = case.trial.mesh, case.trial.rays, case.trial.answers
    count = len(rays.t_min)
    if not 0 < len(mesh.faces) <= MOST_FACES or not count:
        return None
    with np.errstate(all="ignore"):
        judgement = judge(answers, case.hits.t)
    wrong = judgement.missed_closer | judgement.no_surface
    ray = np.union1d(
        np.linspace(0, count - 1, MOST_RAYS).astype(np.int64),
        np.flatnonzero(wrong)[:MOST_WRONG],
    )
    origin, direction = (each[ray].astype(np.float64) for each in (rays.origin, rays.direction))
    a, b, c = mesh.vertices[mesh.faces].astype(np.float64).transpose(1, 0, 2)
    with np.errstate(all="ignore"):
        t, u, v, side = _met(origin, direction, (a, b - a, c - a))
    return Shots(
        ray=ray,
        origin=origin,
        direction=direction,
        t_min=rays.t_min[ray].astype(np.float64),
        t_max=rays.t_max[ray].astype(np.float64),
        t=t,
        u=u,
        v=v,
        side=side,
        got=case.hits.t[ray].astype(np.float64),
        right=~wrong[ray],
        limit=answers.limit[ray],
        unambiguous=~(is_ambiguous(answers) | judgement.uncounted)[ray],
    )


def _met(
    origin: Doubles, direction: Doubles, triangle: tuple[Doubles, Doubles, Doubles]
) -> tuple[Doubles, Doubles, Doubles, Doubles]:
    """Return t, u, v and determinant of rays and triangles, each (S, F).

    Source: T. Moeller and B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997,
    with products of two vectors taken out, so that whole tables are products of matrices.
    """
    corner, first, second = triangle
    normal = np.cross(first, second)
    side = -direction @ normal.T
    height = origin @ normal.T - (corner * normal).sum(axis=1)
    t = height / side
    # Of point = corner + u first + v second: products with vectors across the other edge.
    across_u, across_v = np.cross(second, normal), np.cross(normal, first)
    area = (normal * normal).sum(axis=1)

    def along(across: Doubles) -> Doubles:
        start = origin @ across.T - (corner * across).sum(axis=1)
        return np.asarray((start + t * (direction @ across.T)) / area)

    t = np.where(np.isfinite(t), t, np.inf)
    return t, along(across_u), along(across_v), np.asarray(side)


@lru_cache(maxsize=64)
def clear(given: Shots) -> Mask:
    """(S,) bool, True where the table of all faces says what is right, as it should."""
    closest = limited(given).closest()
    with np.errstate(invalid="ignore"):
        agrees = np.abs(closest - given.limit) <= 10 * SAME * np.abs(given.limit)
    return np.asarray(given.unambiguous & (agrees | (closest == given.limit)))


def same(got: Doubles, foretold: Doubles) -> Mask:
    """(S,) bool, True where two distances mean the same hit, or both a miss."""
    with np.errstate(invalid="ignore"):
        close = np.isfinite(foretold) & (np.abs(got - foretold) <= SAME * np.abs(foretold))
    return np.asarray(close | (got == foretold))
