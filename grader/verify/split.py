"""Is every node split at the median of the triangle centres, along its longest axis?"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.cases import TreeCase
from grader.model.mesh import Bvh, Doubles, Floats, FrozenArrays, Integers, Mask, Mesh
from grader.model.verdict import Evidence, Example
from grader.tolerances import SPLIT_ULPS
from grader.verify.check import check, judged
from grader.verify.structure import READABLE, needs_a_split
from grader.verify.tree import shape, spans

AXES = "xyz"


@dataclass(frozen=True, slots=True, eq=False)
class Splits(FrozenArrays):
    """What each split of a tree looks like; only nodes that their children partition."""

    node: Integers
    """(K,) int64, the nodes that are split."""

    overlap: Doubles
    """(K, 3) float64, largest centre on the left minus smallest on the right, per axis."""

    ordered: Mask
    """(K, 3) bool, True for the axes that explain the split: left centres before right ones.

    An axis on which all centres agree explains every split: whoever divides a flat mesh along
    it has the wrong axis, and not the wrong median.
    """

    longest: Mask
    """(K, 3) bool, True for the axes that may count as the longest of the node's box."""


@lru_cache(maxsize=2)
def splits(mesh: Mesh, bvh: Bvh) -> Splits:
    """Measure every split of a readable tree."""
    node = np.flatnonzero(shape(bvh).parted)
    true = spans(mesh, bvh)
    left, right = 2 * node + 1, 2 * node + 2
    overlap = true.centre_high[left].astype(np.float64) - true.centre_low[right]
    low, high = true.low[node], true.high[node]
    allowed = SPLIT_ULPS * np.spacing(np.maximum(np.abs(low), np.abs(high)))
    longest = _longest(low, high) | _longest(bvh.low[node], bvh.high[node])
    return Splits(node, overlap, overlap <= allowed, longest)


def _longest(low: Floats, high: Floats) -> Mask:
    """(K, 3) bool, True for axes whose extent is within 4 ulp of the largest.

    The submission's own box counts beside the true one: a wrong box is one mistake, and the
    axis that follows from it is not a second one.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        extent = high - low
        largest = extent.max(axis=1, keepdims=True)
        return np.asarray(extent >= largest - SPLIT_ULPS * np.spacing(np.abs(largest)))


@check(TreeCase, "bvh.splits-the-longest-axis", needs=READABLE, when=needs_a_split)
def splits_the_longest_axis(case: TreeCase) -> Evidence:
    """Every node is divided along the axis on which its box is largest.

    Only splits that some axis explains are judged here; the others have no axis at all, which
    `bvh.splits-at-the-median` says.
    """
    found = splits(case.trial.mesh, case.bvh)
    judgeable = found.ordered.any(axis=1)
    wrong = judgeable & ~(found.ordered & found.longest).any(axis=1)

    def describe(k: int) -> Example:
        got = " or ".join(AXES[axis] for axis in np.flatnonzero(found.ordered[k]))
        wanted = " or ".join(AXES[axis] for axis in np.flatnonzero(found.longest[k]))
        node = found.node[k]
        text = f"node {node} is divided along {got}, but its box is largest along {wanted}"
        return Example(text, wanted, got)

    return judged(np.asarray(wrong), describe, examined=int(judgeable.sum()))


@check(TreeCase, "bvh.splits-at-the-median", needs=READABLE, when=needs_a_split)
def splits_at_the_median(case: TreeCase) -> Evidence:
    """Both halves are equally large, and the smaller triangle centres are on the left."""
    bvh, found = case.bvh, splits(case.trial.mesh, case.bvh)
    left, right = 2 * found.node + 1, 2 * found.node + 2
    held_left = bvh.end[left].astype(np.int64) - bvh.begin[left]
    held_right = bvh.end[right].astype(np.int64) - bvh.begin[right]
    unequal = np.abs(held_left - held_right) > 1
    mixed = ~found.ordered.any(axis=1)

    def describe(k: int) -> Example:
        node = int(found.node[k])
        if unequal[k]:
            got = f"{held_left[k]:,} and {held_right[k]:,} faces"
            text = f"node {node} is divided into {got}, but the halves must be equal"
            return Example(text, "halves that differ by at most one face", got)
        axis = int(np.flatnonzero(found.longest[k])[0])
        true = spans(case.trial.mesh, bvh)
        most, least = true.centre_high[2 * node + 1, axis], true.centre_low[2 * node + 2, axis]
        text = (
            f"node {node}: the left half reaches to centre {AXES[axis]} = {most:.9g}, but the "
            f"right half begins at {least:.9g}"
        )
        return Example(text, "all left centres before all right ones", "mixed centres")

    wrong = unequal | mixed
    return judged(np.asarray(wrong), describe)
