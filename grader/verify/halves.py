"""What does each split of a tree look like?"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.mesh import Bvh, Floats, FrozenArrays, Integers, Mask, Mesh
from grader.tolerances import SPLIT_ULPS
from grader.verify.tree import shape, spans


@dataclass(frozen=True, slots=True, eq=False)
class Splits(FrozenArrays):
    """What each split of a tree looks like; only nodes that their children partition."""

    node: Integers
    """(K,) int64, the nodes that are split."""

    ordered: Mask
    """(K, 3) bool, True for the axes that explain the split: left centres before right ones.

    An axis on which all centres agree explains every split: whoever divides a flat mesh along
    it has the wrong axis, and not the wrong median.
    """

    flat: Mask
    """(K, 3) bool, True for the axes on which all centres of the node agree."""

    longest: Mask
    """(K, 3) bool, True for the axes that may count as the longest of the node's box."""


@lru_cache(maxsize=2)
def splits(mesh: Mesh, bvh: Bvh) -> Splits:
    """Measure every split of a readable tree."""
    node = np.flatnonzero(shape(bvh).parted)
    true = spans(mesh, bvh)
    left, right = 2 * node + 1, 2 * node + 2
    most, least = true.centre_high.take(left, axis=0), true.centre_low.take(right, axis=0)
    overlap = most.astype(np.float64) - least
    low, high = true.low.take(node, axis=0), true.high.take(node, axis=0)
    allowed = SPLIT_ULPS * np.spacing(np.maximum(np.abs(low), np.abs(high)))
    own = bvh.low.take(node, axis=0), bvh.high.take(node, axis=0)
    longest = _longest(low, high) | _longest(*own)
    most, least = true.centre_high.take(node, axis=0), true.centre_low.take(node, axis=0)
    flat = most.astype(np.float64) - least <= allowed
    return Splits(node, overlap <= allowed, flat, longest)


def _longest(low: Floats, high: Floats) -> Mask:
    """(K, 3) bool, True for axes whose extent is within 4 ulp of the largest.

    The submission's own box counts beside the true one: a wrong box is one mistake, and the
    axis that follows from it is not a second one.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        extent = high - low
        largest = np.maximum(np.maximum(extent[:, :1], extent[:, 1:2]), extent[:, 2:])
        return np.asarray(extent >= largest - SPLIT_ULPS * np.spacing(np.abs(largest)))
