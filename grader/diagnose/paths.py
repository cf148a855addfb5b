"""In which order, and through which boxes, does a ray come to the leaves of a tree?"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.diagnose.shots import Met, Shots, limited
from grader.model.mesh import Bvh, Doubles, FrozenArrays, Integers, Mask
from grader.verify.tree import shape


@dataclass(frozen=True, slots=True, eq=False)
class Leaves(FrozenArrays):
    """Which leaf holds each face of a tree; F faces."""

    leaf: Integers
    """(F,) int64, node index of the leaf that holds a face."""

    place: Integers
    """(F,) int64, the face's place in the face indices."""

    first: Integers
    last: Integers
    """(F,) int64, first and last place of its leaf."""


@lru_cache(maxsize=64)
def leaves(bvh: Bvh) -> Leaves:
    """Find the leaf of each face of a right tree."""
    faces = len(bvh.order)
    by_place = np.zeros((faces, 3), dtype=np.int64)
    for node in shape(bvh).leaves:
        begin, end = int(bvh.begin[node]), int(bvh.end[node])
        by_place[begin:end] = node, begin, end - 1
    place = np.zeros(faces, dtype=np.int64)
    place[bvh.order] = np.arange(faces)
    leaf, first, last = by_place[place].T
    return Leaves(leaf.copy(), place, first.copy(), last.copy())


ORDERS = (
    "left first",
    "right first",
    "nearer centre first",
    "nearer box first",
    "level by level",
)


@dataclass(frozen=True, slots=True, eq=False)
class Sequence(FrozenArrays):
    """The hits of each ray in the order in which a walk comes to them; at most M a ray."""

    t: Doubles
    """(S, M) float64, infinite behind the last hit of a ray."""

    leaf: Integers
    """(S, M) int64, the leaf that holds the face; -1 behind the last hit."""


@lru_cache(maxsize=256)
def sequence(given: Shots, bvh: Bvh, order: str) -> Sequence:
    """Put the hits of each ray in the order in which a walk comes to them."""
    met, held = limited(given), leaves(bvh)
    leaf = held.leaf[met.face]
    if order == "level by level":
        rank = leaf.astype(np.float64)
    else:
        rank = _depth_first(given, bvh, order)[met.ray, leaf]
    turn = np.lexsort((held.place[met.face], rank, met.ray))
    ray = met.ray[turn]
    count = np.bincount(ray, minlength=met.shots)
    column = np.arange(ray.size) - np.repeat(np.cumsum(count) - count, count)
    t = np.full((met.shots, max(int(count.max(initial=0)), 1)), np.inf)
    leaves_met = np.full(t.shape, -1, dtype=np.int64)
    t[ray, column], leaves_met[ray, column] = met.t[turn], leaf[turn]
    return Sequence(t, leaves_met)


def _depth_first(given: Shots, bvh: Bvh, order: str) -> Doubles:
    """(S, N) float64, in [0, 1): which of two nodes a walk in depth first order meets first."""
    rank = np.zeros((len(given.ray), len(bvh.end)))
    near = _entries(given, bvh) if order == "nearer box first" else None
    for node in shape(bvh).inner:
        left, right = 2 * int(node) + 1, 2 * int(node) + 2
        if right >= len(bvh.end):
            continue
        if near is not None:
            swap = near[:, right] < near[:, left]
        elif order == "nearer centre first":
            across = _centre(bvh, right) - _centre(bvh, left)
            swap = given.direction @ across < 0
        else:
            swap = np.full(len(given.ray), order == "right first")
        step = 0.5 ** (int(node + 1).bit_length())
        rank[:, left] = rank[:, node] + swap * step
        rank[:, right] = rank[:, node] + ~swap * step
    return rank


def _centre(bvh: Bvh, node: int) -> Doubles:
    return np.asarray((bvh.low[node].astype(np.float64) + bvh.high[node]) / 2)


@lru_cache(maxsize=64)
def slabs(given: Shots, bvh: Bvh) -> tuple[Doubles, Doubles]:
    """(S, N) float64 twice: where a ray enters and leaves each box, not limited by the ray."""
    enter = np.full((len(given.ray), len(bvh.end)), -np.inf)
    leave = -enter
    with np.errstate(all="ignore"):
        for axis in range(3):
            inverse = 1 / given.direction[:, axis, None]
            one = (bvh.low[None, :, axis] - given.origin[:, axis, None]) * inverse
            two = (bvh.high[None, :, axis] - given.origin[:, axis, None]) * inverse
            # In the plane of a side 0 times infinity is not a number, and excludes nothing.
            known = ~(np.isnan(one) | np.isnan(two))
            enter = np.where(known, np.maximum(enter, np.minimum(one, two)), enter)
            leave = np.where(known, np.minimum(leave, np.maximum(one, two)), leave)
    return enter, leave


def _entries(given: Shots, bvh: Bvh) -> Doubles:
    return np.maximum(slabs(given, bvh)[0], given.t_min[:, None])


def passes(given: Shots, bvh: Bvh) -> Mask:
    """(S, N) bool, True where a ray meets a box within its limits."""
    enter, leave = slabs(given, bvh)
    near, far = np.maximum(enter, given.t_min[:, None]), np.minimum(leave, given.t_max[:, None])
    with np.errstate(invalid="ignore"):
        return np.asarray(near <= far + 1e-6 * np.abs(far))


def reached(bvh: Bvh, lets_pass: Mask) -> Mask:
    """(S, N) bool, True where a ray passes the tests of a node and of all nodes above it."""
    through = lets_pass.copy()
    for node in range(1, through.shape[1]):
        through[:, node] &= through[:, (node - 1) // 2]
    return through


def through_leaves(bvh: Bvh, through: Mask, met: Met) -> Met:
    """Leave out hits on faces whose leaf a ray does not come to.

    Args:
        bvh: A right tree.
        through: (S, N) bool, True where a ray comes to a node.
        met: The hits.
    """
    return met.only(through[met.ray, leaves(bvh).leaf[met.face]])
