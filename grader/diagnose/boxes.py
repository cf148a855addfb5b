"""Which mistake explains the boxes of a tree?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, weighed
from grader.diagnose.readable import corners, extremes, is_readable
from grader.model.cases import TreeCase
from grader.model.mesh import Doubles, Integers, Mask
from grader.tolerances import SPLIT_ULPS
from grader.verify.tree import shape, spans

Boxes = tuple[Doubles, Doubles]
"""(K, 3) float64 twice: low and high corners."""

Guess = Callable[[TreeCase, Integers], Boxes]
"""The boxes that a mistake gives to some nodes."""

SMALLEST = float(np.finfo(np.float32).tiny)


def _support(case: TreeCase, guess: Guess, ulps: int = 0) -> Support:
    if not is_readable(case):
        return NOTHING
    used = shape(case.bvh).reached[1:]
    used = used[case.bvh.begin[used] < case.bvh.end[used]]
    if not used.size:
        return NOTHING
    return weighed(
        _equal(case, used, guess(case, used), ulps), _equal(case, used, _true(case, used))
    )


def _equal(case: TreeCase, used: Integers, boxes: Boxes, ulps: int = 0) -> Mask:
    """(K,) bool, True where nodes have these boxes, but for some units in the last place."""
    same = np.ones(used.size, dtype=np.bool_)
    for own, box in zip((case.bvh.low[used], case.bvh.high[used]), boxes, strict=True):
        wanted = box.astype(np.float32)
        with np.errstate(invalid="ignore"):
            close = np.abs(own - wanted) <= ulps * np.spacing(np.abs(wanted))
        same &= ((own == wanted) | close).all(axis=1)
    return same


def _wide(low: np.ndarray, high: np.ndarray, used: Integers) -> Boxes:
    return low[used].astype(np.float64), high[used].astype(np.float64)


def _true(case: TreeCase, used: Integers) -> Boxes:
    true = spans(case.trial.mesh, case.bvh)
    return _wide(true.low, true.high, used)


def _ranges(case: TreeCase, used: Integers) -> tuple[Integers, Integers]:
    return case.bvh.begin[used].astype(np.int64), case.bvh.end[used].astype(np.int64)


def _of_vertices(*which: int) -> Guess:
    def guess(case: TreeCase, used: Integers) -> Boxes:
        rows = corners(case.trial.mesh)[case.bvh.order][:, which, :]
        begin, end = _ranges(case, used)
        low, _ = extremes(rows.min(axis=1), begin, end)
        _, high = extremes(rows.max(axis=1), begin, end)
        return low, high

    return guess


def _of_centres(case: TreeCase, used: Integers) -> Boxes:
    true = spans(case.trial.mesh, case.bvh)
    return _wide(true.centre_low, true.centre_high, used)


def _without_the_last(case: TreeCase, used: Integers) -> Boxes:
    rows = corners(case.trial.mesh)[case.bvh.order]
    begin, end = _ranges(case, used)
    low, _ = extremes(rows.min(axis=1), begin, end - 1)
    _, high = extremes(rows.max(axis=1), begin, end - 1)
    return low, high


def _from_zero(case: TreeCase, used: Integers) -> Boxes:
    low, high = _true(case, used)
    return np.minimum(low, 0.0), np.maximum(high, 0.0)


def _from_the_smallest(case: TreeCase, used: Integers) -> Boxes:
    low, high = _true(case, used)
    return low, np.maximum(high, SMALLEST)


def _of_the_parent(case: TreeCase, used: Integers) -> Boxes:
    """Return the box that the parent has, right or wrong."""
    return _wide(case.bvh.low, case.bvh.high, (used - 1) // 2)


def _swapped(case: TreeCase, used: Integers) -> Boxes:
    sibling = used + np.where(used % 2 == 1, 1, -1)
    return _true(case, np.where(sibling < len(case.bvh.end), sibling, used))


def _right_holds_both(case: TreeCase, used: Integers) -> Boxes:
    return _true(case, np.where(used % 2 == 0, (used - 1) // 2, used))


def _only_inner(case: TreeCase, used: Integers) -> Boxes:
    low, high = _true(case, used)
    leaf = np.isin(used, shape(case.bvh).leaves)[:, None]
    return np.where(leaf, np.inf, low), np.where(leaf, -np.inf, high)


def _cut(case: TreeCase, used: Integers) -> Boxes:
    """Cut along the parent's longest side where the right sibling's centres begin."""
    low, high = _true(case, used)
    true, parent = spans(case.trial.mesh, case.bvh), (used - 1) // 2
    own = case.bvh.high[parent] - case.bvh.low[parent]
    k, axis = np.arange(used.size), own.argmax(axis=1)
    right = 2 * parent + 2
    right = np.where(right < len(case.bvh.end), right, used)
    plane = true.centre_low[right, axis].astype(np.float64)
    is_left = used % 2 == 1
    high[k, axis] = np.where(is_left, np.minimum(high[k, axis], plane), high[k, axis])
    low[k, axis] = np.where(is_left, low[k, axis], np.maximum(low[k, axis], plane))
    return low, high


def _of(id: str, sentence: str, guess: Guess, ulps: int = 0) -> Hypothesis:
    return Hypothesis(id, TreeCase, sentence, lambda case: _support(case, guess, ulps))


def _padded(case: TreeCase) -> Support:
    """Count boxes that are larger than the true ones by little, on sides that touch nothing."""
    if not is_readable(case):
        return NOTHING
    used = shape(case.bvh).reached[1:]
    used = used[case.bvh.begin[used] < case.bvh.end[used]]
    low, high = _true(case, used)
    below, above = low - case.bvh.low[used], case.bvh.high[used] - high
    size = np.maximum(np.abs(low), np.abs(high)).max(axis=1, initial=0)
    most = (0.01 + 1e-3 * size)[:, None]
    grown = (below >= 0) & (above >= 0) & (below <= most) & (above <= most)
    return weighed(grown.all(axis=1), ((below == 0) & (above == 0)).all(axis=1))


def _before_the_split(case: TreeCase) -> Support:
    """Look at the children of the root: their boxes are those of the faces in given order."""
    if not is_readable(case) or len(case.bvh.end) < 3 or not shape(case.bvh).parted[0]:
        return NOTHING
    faces = corners(case.trial.mesh)
    used = np.array([1, 2])
    begin, end = _ranges(case, used)
    low, _ = extremes(faces.min(axis=1), begin, end)
    _, high = extremes(faces.max(axis=1), begin, end)
    right = _equal(case, used, _true(case, used))
    return weighed(_equal(case, used, (low, high)), right)


CORNERS = "Not all three vertices of a face go into the box of its node."

BOXES = (
    *(
        _of("box.not-all-vertices", CORNERS, _of_vertices(*which))
        for which in ((0,), (1,), (2,), (0, 1), (0, 2), (1, 2))
    ),
    _of(
        "box.of-centres",
        "The boxes hold the centres of the triangles, not their vertices.",
        _of_centres,
        SPLIT_ULPS,
    ),
    _of(
        "box.last-face-forgotten",
        "The box of a node leaves out the last face of its range.",
        _without_the_last,
    ),
    _of(
        "box.from-zero",
        "The boxes begin as the point (0, 0, 0) instead of empty, so each holds the origin.",
        _from_zero,
    ),
    _of(
        "box.from-smallest-float",
        "The upper corner begins at the smallest positive float "
        "instead of at the lowest number, so it is never negative.",
        _from_the_smallest,
    ),
    _of(
        "box.of-the-parent",
        "A child gets the box of its parent instead of that of its own faces.",
        _of_the_parent,
    ),
    _of(
        "box.swapped",
        "The left child gets the box of the right one, and the other way round.",
        _swapped,
    ),
    _of(
        "box.not-reset",
        "The box of the right child also holds the faces of the left one: it "
        "is not emptied in between.",
        _right_holds_both,
    ),
    _of(
        "box.only-of-inner-nodes",
        "Only nodes that are split get a box; those of the leaves stay empty.",
        _only_inner,
    ),
    _of(
        "box.cut-at-the-plane",
        "The boxes of the children are cut at the split plane, though "
        "triangles reach beyond it.",
        _cut,
        SPLIT_ULPS,
    ),
    Hypothesis(
        "box.padded",
        TreeCase,
        "The boxes are made a little larger than their triangles.",
        _padded,
    ),
    Hypothesis(
        "box.before-the-split",
        TreeCase,
        "The boxes of the children are computed before the faces are moved to their halves.",
        _before_the_split,
    ),
)
