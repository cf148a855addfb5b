"""What nodes really hold, compared with a plain loop over them."""

import numpy as np
import pytest

from grader.model.mesh import Bvh
from grader.verify import tree as module
from grader.verify.tree import centres, on_any_axis, shape, spans
from tests.verify.builder import CENTRES, Reading, altered, box, build, changed, soup

MESH = soup(37)


def tree_of(*ranges: tuple[int, int]) -> Bvh:
    """Make a tree with these ranges and boxes of zeros."""
    low = np.zeros((len(ranges), 3), np.float32)
    begin, end = np.array(ranges, np.uint32).reshape(-1, 2).T
    return Bvh(low, low, begin.copy(), end.copy(), np.arange(37, dtype=np.uint32), len(ranges))


@pytest.mark.parametrize(
    ("ends", "reached", "inner", "depth"),
    [
        ([], [], [], -1),
        ([9], [0], [], 0),
        ([0], [0], [], 0),
        ([9, 4], [0, 1], [0], 1),
        ([9, 0, 9], [0, 2], [0], 1),
        ([9, 4, 9], [0, 1, 2], [0], 1),
        ([9, 0, 0, 9, 9], [0], [], 0),
        ([9, 4, 9, 0, 0, 7, 9], [0, 1, 2, 5, 6], [0, 2], 2),
        ([9, 4, 9, 0, 2], [0, 1, 2, 4], [0, 1], 2),
    ],
)
def test_a_node_is_a_leaf_without_used_children(
    ends: list[int], reached: list[int], inner: list[int], depth: int
) -> None:
    """A child is used if its slot exists and its `facesEnd` is not 0."""
    form = shape(tree_of(*((0, end) for end in ends)))
    assert form.reached.tolist() == reached
    assert form.inner.tolist() == inner
    assert form.leaves.tolist() == sorted(set(reached) - set(inner))
    assert form.depth == depth


@pytest.mark.parametrize(
    ("left", "right", "parted"),
    [
        ((0, 4), (4, 9), True),
        ((0, 8), (8, 9), True),
        ((0, 4), (5, 9), False),
        ((0, 5), (4, 9), False),
        ((1, 4), (4, 9), False),
        ((0, 4), (4, 8), False),
        ((0, 9), (9, 9), False),
        ((4, 9), (0, 4), False),
        ((0, 4), (0, 0), False),
        ((5, 4), (4, 9), False),
        ((0, 10), (10, 9), False),
    ],
)
def test_only_touching_ranges_partition(
    left: tuple[int, int], right: tuple[int, int], parted: bool
) -> None:
    """Both halves hold something, begin and end with the parent, and meet."""
    assert shape(tree_of((0, 9), left, right)).parted.tolist() == [parted, False, False]


def test_an_empty_half_is_no_part() -> None:
    """Neither child of a partition is empty, on either side."""
    assert not shape(tree_of((4, 9), (4, 4), (4, 9))).parted.any()
    assert not shape(tree_of((4, 9), (4, 9), (9, 9))).parted.any()


@pytest.mark.parametrize("shuffled", [False, True])
@pytest.mark.parametrize("leaf", [1, 4, 37])
@pytest.mark.parametrize("block", [5, module.BLOCK])
def test_spans_are_those_of_a_loop(
    leaf: int, shuffled: bool, block: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Boxes and boxes of centres, of partitions bottom-up and of any other range directly."""
    monkeypatch.setattr(module, "BLOCK", block)
    bvh = build(MESH, Reading(leaf=leaf, slots=1))
    if shuffled:
        rng = np.random.default_rng(leaf)
        begin = rng.integers(0, 38, len(bvh.begin))
        bvh = altered(bvh, begin=begin, end=np.maximum(begin, rng.integers(1, 38, len(begin))))
    a, b, c = (MESH.vertices[MESH.faces[:, corner]] for corner in range(3))
    centre = CENTRES["double"](a, b, c).astype(np.float32)
    true = spans(MESH, bvh)
    for node in shape(bvh).reached:
        own = bvh.order[bvh.begin[node] : bvh.end[node]]
        if not own.size:
            assert np.isposinf(true.low[node]).all()
            continue
        low, high = box(MESH, own)
        assert (true.low[node] == low).all()
        assert (true.high[node] == high).all()
        assert (true.centre_low[node] == centre[own].min(axis=0)).all()
        assert (true.centre_high[node] == centre[own].max(axis=0)).all()


def test_nodes_out_of_reach_are_not_measured() -> None:
    """Garbage in slots that no traversal visits has no span."""
    bvh = build(MESH, Reading(leaf=37, slots=6))
    bvh = changed(changed(bvh, "begin", 5, 2**32 - 1), "end", 5, 7)
    true = spans(MESH, bvh)
    assert np.isposinf(true.low[1:]).all()
    assert np.isneginf(true.high[1:]).all()


def test_centres_are_in_the_order_of_the_faces() -> None:
    """A third of the sum of the corners, rounded once."""
    a, b, c = (MESH.vertices[MESH.faces[:, corner]] for corner in range(3))
    assert (centres(MESH) == CENTRES["double"](a, b, c).astype(np.float32)).all()


def test_one_axis_is_enough() -> None:
    """All eight rows of three, and no row at all."""
    mask = np.array([[k & 1, k & 2, k & 4] for k in range(8)], np.bool_)
    assert on_any_axis(mask).tolist() == [False] + 7 * [True]
    assert on_any_axis(mask[:0]).tolist() == []
