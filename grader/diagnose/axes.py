"""Which mistaken choice of an axis explains all splits of a tree?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, hypothesis, weighed
from grader.diagnose.readable import is_readable
from grader.model.cases import TreeCase
from grader.model.mesh import Bvh, Floats, Integers
from grader.tolerances import EPSILON
from grader.verify.halves import Splits, splits
from grader.verify.tree import spans

Choice = Callable[[TreeCase, Splits], Integers]
"""(K,) int64, the axis along which each split of a tree would be made."""


def _support(case: TreeCase, choose: Choice) -> Support:
    """Compare the axis that is foretold for each split with the one that is seen."""
    if not is_readable(case):
        return NOTHING
    found = splits(case.trial.mesh, case.bvh)
    if not found.node.size:
        return NOTHING
    row, axis = np.arange(found.node.size), choose(case, found)
    right = (found.ordered & found.longest).any(axis=1)
    return weighed(found.ordered[row, axis], right | found.longest[row, axis])


def _of(id: str, sentence: str, choose: Choice) -> Hypothesis:
    return Hypothesis(id, TreeCase, sentence, lambda case: _support(case, choose))


def _extents(case: TreeCase, found: Splits) -> Floats:
    """(K, 3) float32, of each node's own box; of the true one where it has none."""
    true = spans(case.trial.mesh, case.bvh)
    with np.errstate(invalid="ignore", over="ignore"):
        own = case.bvh.high[found.node] - case.bvh.low[found.node]
        actual = true.high[found.node] - true.low[found.node]
    return np.where(np.isfinite(own), own, actual)


def _always(axis: int) -> Choice:
    return lambda _, found: np.full(found.node.size, axis)


def _by_depth(first: int, step: int) -> Choice:
    return lambda _, found: (first + step * _levels(found)) % 3


def _levels(found: Splits) -> Integers:
    """(K,) int64, the level of each node, the root's being 0."""
    return np.asarray(np.frexp(found.node + 1.0)[1] - 1, dtype=np.int64)


def _shortest(case: TreeCase, found: Splits) -> Integers:
    return np.asarray(_extents(case, found).argmin(axis=1))


def _of_the_mesh(case: TreeCase, found: Splits) -> Integers:
    vertices = case.trial.mesh.vertices
    extent = vertices.max(axis=0) - vertices.min(axis=0)
    return np.full(found.node.size, int(extent.argmax()))


def _largest_coordinate(case: TreeCase, found: Splits) -> Integers:
    return np.asarray(_highs(case.bvh, found).argmax(axis=1))


def _largest_magnitude(case: TreeCase, found: Splits) -> Integers:
    return np.asarray(np.abs(_highs(case.bvh, found)).argmax(axis=1))


def _highs(bvh: Bvh, found: Splits) -> Floats:
    return bvh.high[found.node]


def _spread(case: TreeCase, found: Splits) -> Integers:
    true = spans(case.trial.mesh, case.bvh)
    spread = true.centre_high[found.node] - true.centre_low[found.node]
    return np.asarray(spread.argmax(axis=1))


def _whole_numbers(case: TreeCase, found: Splits) -> Integers:
    return np.asarray(np.trunc(_extents(case, found)).argmax(axis=1))


@hypothesis(TreeCase, "axis.ties")
def ties(case: TreeCase) -> Support:
    """Where the two longest sides are equally long, neither of them is chosen."""
    if not is_readable(case):
        return NOTHING
    found = splits(case.trial.mesh, case.bvh)
    if not found.node.size:
        return NOTHING
    wrong = ~(found.ordered & found.longest).any(axis=1)
    tied = found.longest.sum(axis=1) > 1
    return Support(int((wrong & tied).sum()), int((wrong & ~tied).sum()))


def _by_epsilon(case: TreeCase, found: Splits) -> Integers:
    """The first axis that none exceeds by more than epsilon."""
    extent = _extents(case, found)
    largest = extent.max(axis=1, keepdims=True)
    return np.asarray((extent + np.float32(EPSILON) >= largest).argmax(axis=1))


def _else_if(case: TreeCase, found: Splits) -> Integers:
    """Whether z is longest is asked only where y is not longer than x."""
    x, y, z = _extents(case, found).T
    return np.where(y > x, 1, np.where(z > x, 2, 0))


def _never(left_out: int) -> Choice:
    def choose(case: TreeCase, found: Splits) -> Integers:
        extent = _extents(case, found).copy()
        extent[:, left_out] = -np.inf
        return np.asarray(extent.argmax(axis=1))

    return choose


ALWAYS = "Every node is split along the same axis, whichever side of its box is the longest."
BY_DEPTH = "The axis changes with the depth, in turn, instead of following the longest side."
NEVER = "One of the three axes is never, or hardly ever, chosen: the comparison leaves it out."
COORDINATE = "The axis is that of the largest coordinate of the box, not of its longest side."

AXES = (
    *(_of("axis.always-the-same", ALWAYS, _always(axis)) for axis in range(3)),
    *(
        _of("axis.by-depth", BY_DEPTH, _by_depth(first, step))
        for first in range(3)
        for step in (1, 2)
    ),
    _of(
        "axis.shortest",
        "The axis of the shortest side of the box is chosen, not of the longest.",
        _shortest,
    ),
    _of(
        "axis.of-the-mesh",
        "The axis is always the longest one of the whole mesh, not of the node's own box.",
        _of_the_mesh,
    ),
    _of("axis.largest-coordinate", COORDINATE, _largest_coordinate),
    _of("axis.largest-coordinate", COORDINATE, _largest_magnitude),
    _of(
        "axis.spread-of-centres",
        "The axis is that on which the centres spread most, not that of the node's box.",
        _spread,
    ),
    _of(
        "axis.whole-numbers",
        "The lengths of the box's sides are compared as whole numbers.",
        _whole_numbers,
    ),
    ties,
    _of(
        "axis.with-epsilon",
        "A side counts as longer only if it is by more than epsilon: small boxes have none.",
        _by_epsilon,
    ),
    _of("axis.never-chosen", NEVER, _else_if),
    *(_of("axis.never-chosen", NEVER, _never(axis)) for axis in range(3)),
)
