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
    own, left, right = _rows(node)
    overlap = true.centre_high[left].astype(np.float64) - true.centre_low[right]
    low, high = true.low[own], true.high[own]
    allowed = SPLIT_ULPS * np.spacing(np.maximum(np.abs(low), np.abs(high)))
    longest = _longest(low, high) | _longest(bvh.low[own], bvh.high[own])
    flat = true.centre_high[own].astype(np.float64) - true.centre_low[own] <= allowed
    return Splits(node, overlap <= allowed, flat, longest)


def _rows(node: Integers) -> tuple[Integers | slice, Integers | slice, Integers | slice]:
    """Return the places of nodes and of their left and right children.

    As slices where no node is left out: most levels of a right tree are full, and what lies in
    order need not be copied.
    """
    count = len(node)
    if count and node[-1] == count - 1:
        return slice(count), slice(1, 2 * count, 2), slice(2, 2 * count + 1, 2)
    return node, 2 * node + 1, 2 * node + 2


def _longest(low: Floats, high: Floats) -> Mask:
    """(K, 3) bool, True for axes whose extent is within 4 ulp of the largest.

    The submission's own box counts beside the true one: a wrong box is one mistake, and the
    axis that follows from it is not a second one.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        extent = high - low
        largest = np.maximum(np.maximum(extent[:, 0], extent[:, 1]), extent[:, 2])
        least = largest - SPLIT_ULPS * np.spacing(np.abs(largest))
        return np.asarray(extent >= least[:, None])
