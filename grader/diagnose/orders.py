"""Which mistaken order of faces explains how those of each node are divided?"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, hypothesis, weighed
from grader.diagnose.readable import corners, extremes, is_readable
from grader.model.cases import TreeCase
from grader.model.mesh import Doubles, FrozenArrays, Integers, Mask, Mesh
from grader.tolerances import EPSILON, SPLIT_ULPS
from grader.verify.halves import splits
from grader.verify.tree import centres

Key = Callable[[Mesh], Doubles]
"""(F, 3) float64, what the faces of a mesh are ordered by on each axis."""


@dataclass(frozen=True, slots=True, eq=False)
class Halves(FrozenArrays):
    """The splits of one tree and what a right one looks like."""

    node: Integers
    """(K,) int64, index of the node that is split."""

    axis: Integers
    """(K,) int64, the axis of the split: one that explains it, else the longest."""

    begin: Integers
    middle: Integers
    end: Integers
    """(K,) int64 each, places in the face indices."""

    mixed: Mask
    """(K,) bool, True where the centres of both halves are mixed."""

    unequal: Mask
    """(K,) bool, True where the halves differ by more than one face."""


def halves_of(case: TreeCase) -> Halves | None:
    """Look at the splits of a tree; None if there are none."""
    if not is_readable(case):
        return None
    bvh, found = case.bvh, splits(case.trial.mesh, case.bvh)
    if not found.node.size:
        return None
    explained = found.ordered & found.longest
    axis = np.where(
        explained.any(axis=1), explained.argmax(axis=1), found.longest.argmax(axis=1)
    )
    begin, middle, end = (
        each.astype(np.int64)
        for each in (bvh.begin[found.node], bvh.end[2 * found.node + 1], bvh.end[found.node])
    )
    unequal = np.abs(2 * middle - begin - end) > 1
    mixed = np.asarray(~found.ordered.any(axis=1))
    return Halves(found.node, axis, begin, middle, end, mixed, np.asarray(unequal))


def _gaps(
    case: TreeCase, given: Halves, key: Doubles, skip: tuple[int, int] = (0, 0)
) -> Doubles:
    """(K,) float64, by how much the right half begins behind the end of the left one.

    Args:
        case: The tree.
        given: Its splits.
        key: (F, 3) float64, the order of faces on each axis.
        skip: How many faces are left out at the beginning and at the end of the right half.
    """
    rows = key[case.bvh.order[: len(case.trial.mesh.faces)]]
    k = np.arange(given.node.size)
    _, left = extremes(rows, given.begin, given.middle)
    right, _ = extremes(rows, given.middle + skip[0], given.end - skip[1])
    with np.errstate(invalid="ignore"):
        return np.asarray(right[k, given.axis] - left[k, given.axis])


def room(key: Doubles) -> float:
    """How far two roundings of a key, (F, 3) float64, may differ."""
    return float(SPLIT_ULPS * np.spacing(np.float32(np.abs(key).max(initial=0))))


def _by_key(case: TreeCase, make: Key) -> Support:
    given = halves_of(case)
    if given is None:
        return NOTHING
    key = make(case.trial.mesh)
    foretold = (_gaps(case, given, key) >= -room(key)) & ~given.unequal
    return weighed(foretold, ~given.mixed)


def _corner(*which: int) -> Key:
    return lambda mesh: corners(mesh)[:, which, :].mean(axis=1)


def _box_centre(mesh: Mesh) -> Doubles:
    corner = corners(mesh)
    return np.asarray((corner.min(axis=1) + corner.max(axis=1)) / 2)


def _descending(mesh: Mesh) -> Doubles:
    return -centres(mesh).astype(np.float64)


def _index(mesh: Mesh) -> Doubles:
    return np.repeat(np.arange(len(mesh.faces), dtype=np.float64)[:, None], 3, axis=1)


def _whole(mesh: Mesh) -> Doubles:
    return np.trunc(centres(mesh).astype(np.float64))


def _bits(mesh: Mesh) -> Doubles:
    """Order of the bits of a float as a signed whole number."""
    return centres(mesh).astype(np.float32).view(np.int32).astype(np.float64)


def _unsigned_bits(mesh: Mesh) -> Doubles:
    return centres(mesh).astype(np.float32).view(np.uint32).astype(np.float64)


def _of(id: str, sentence: str, key: Key) -> Hypothesis:
    return Hypothesis(id, TreeCase, sentence, lambda case: _by_key(case, key))


SINGLE = "Faces are compared by one of their vertices instead of by the centre of all three."
TWO = "The centre of a face is computed from two of its three vertices."
BITS = "The bits of the centres are compared, which turns the order of negative numbers round."

KEYS = (
    *(_of("order.single-vertex", SINGLE, _corner(which)) for which in range(3)),
    *(_of("order.two-vertices", TWO, _corner(a, b)) for a, b in ((0, 1), (0, 2), (1, 2))),
    _of(
        "order.box-centre",
        "Faces are compared by the centres of their boxes, not by those of the triangles.",
        _box_centre,
    ),
    _of(
        "order.descending",
        "The comparison is the wrong way round, so the larger centres end up on the left.",
        _descending,
    ),
    _of(
        "order.by-index",
        "The faces are halved in the order of their indices: they are not ordered by their "
        "centres at all.",
        _index,
    ),
    _of("order.whole-numbers", "The centres are compared as whole numbers.", _whole),
    _of("order.by-bits", BITS, _bits),
    _of("order.by-bits", BITS, _unsigned_bits),
)


def _by_gap(case: TreeCase, allowed: Callable[[TreeCase, Halves], Doubles | float]) -> Support:
    """Halves overlap, but by less than what is allowed."""
    given = halves_of(case)
    if given is None:
        return NOTHING
    gap = _gaps(case, given, centres(case.trial.mesh).astype(np.float64))
    return weighed((gap >= -np.asarray(allowed(case, given))) & ~given.unequal, ~given.mixed)


@hypothesis(TreeCase, "order.with-epsilon")
def with_epsilon(case: TreeCase) -> Support:
    """A centre counts as smaller only if it is by more than epsilon, so close ones mix."""
    return _by_gap(case, lambda *_: 4 * EPSILON)


@hypothesis(TreeCase, "order.loses-digits")
def loses_digits(case: TreeCase) -> Support:
    """The centres lose digits before they are compared, so close ones mix."""

    def allowed(case: TreeCase, given: Halves) -> Doubles:
        size = np.abs(centres(case.trial.mesh).astype(np.float64)).max(axis=0, initial=0)
        return np.asarray(size[given.axis] * 2.0**-15)

    return _by_gap(case, allowed)


def _but_for(case: TreeCase, skip: tuple[int, int]) -> Support:
    given = halves_of(case)
    if given is None:
        return NOTHING
    key = centres(case.trial.mesh).astype(np.float64)
    gap = _gaps(case, given, key, skip)
    return weighed((gap >= -room(key)) & ~given.unequal, ~given.mixed)


@hypothesis(TreeCase, "order.place-after-the-middle")
def place_after_the_middle(case: TreeCase) -> Support:
    """The faces are divided at the place after the middle, so one may be on the wrong side."""
    return _but_for(case, (1, 0))


@hypothesis(TreeCase, "order.last-face-left-out")
def last_face_left_out(case: TreeCase) -> Support:
    """The last face of a node is left out of the ordering: the end of a range is exclusive."""
    return _but_for(case, (0, 1))


@hypothesis(TreeCase, "order.over-everything")
def over_everything(case: TreeCase) -> Support:
    """All faces are ordered at each split, not only those of the node, which undoes others."""
    given = halves_of(case)
    if given is None or given.node.size < 2 or not given.mixed.any():
        return NOTHING
    key = centres(case.trial.mesh).astype(np.float64)[case.bvh.order]
    # Whichever split came last has divided everything.
    foretold = any(
        key[:middle, axis].max() <= key[middle:, axis].min() + room(key)
        for middle, axis in zip(given.middle[1:], given.axis[1:], strict=True)
    )
    return Support(int(foretold), int(not foretold))


@hypothesis(TreeCase, "order.mixes-equal-centres")
def mixes_equal_centres(case: TreeCase) -> Support:
    """Centres equal to the median are mixed with larger ones: only smaller ones are apart."""
    given = halves_of(case)
    if given is None:
        return NOTHING
    key = centres(case.trial.mesh).astype(np.float64)[case.bvh.order]
    foretold = np.ones(given.node.size, dtype=np.bool_)
    for k in np.flatnonzero(given.mixed):
        begin, middle, end = (int(each[k]) for each in (given.begin, given.middle, given.end))
        held = key[begin:end, given.axis[k]]
        median = np.sort(held)[middle - begin]
        smaller = held[middle - begin :] < median - room(key)
        equal = np.abs(held - median) <= room(key)
        foretold[k] = not smaller.any() and equal.sum() > 1
    return weighed(foretold & ~given.unequal, ~given.mixed)


ORDERS = (
    *KEYS,
    mixes_equal_centres,
    with_epsilon,
    loses_digits,
    place_after_the_middle,
    last_face_left_out,
    over_everything,
)
