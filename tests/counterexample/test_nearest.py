"""The nearest right tree is right, and where a submission's is, it is the very same."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from grader.counterexample.nearest import nearest_tree
from grader.counterexample.table import tree_table
from grader.model.mesh import Bvh
from tests.verify.builder import Reading, build, changed, failed, soup

FREE = (
    Reading(odd_left=True),
    Reading(ties_reversed=True),
    *(Reading(free=seed) for seed in range(20)),
)


@pytest.mark.parametrize("reading", FREE)
@pytest.mark.parametrize("faces", [1, 4, 5, 9, 37])
def test_a_legal_tree_is_its_own_nearest(reading: Reading, faces: int) -> None:
    """The odd face may be on either side, and equal centres in any order."""
    mesh = soup(faces)
    tree = build(mesh, reading)
    assert not failed(mesh, tree)
    table = tree_table(nearest_tree(mesh, tree), tree)
    assert table.first_difference == -1
    assert table.expected_faces == table.got_faces


def test_only_the_wrong_node_is_marked() -> None:
    """The odd face is on the left, which is legal; one box is not."""
    mesh = soup(5)
    tree = changed(build(mesh, Reading(odd_left=True)), "low", (2, 0), -99.0)
    table = tree_table(nearest_tree(mesh, tree), tree)
    assert table.columns[table.first_difference].node == 2
    assert all(one.expected == one.got for one in table.columns)


def test_a_wrong_split_is_expected_anew_and_nothing_above_it() -> None:
    """The root is divided rightly with the odd face on the left, its left child is not."""
    mesh = soup(19)
    tree = build(mesh, Reading(odd_left=True))
    moved = changed(
        changed(tree, "end", 3, int(tree.end[3]) - 2), "begin", 4, int(tree.end[3]) - 2
    )
    expected = nearest_tree(mesh, moved)
    assert (expected.begin[1], expected.end[1]) == (tree.begin[1], tree.end[1])
    assert tree_table(expected, moved).first_difference == 3
    assert not failed(mesh, expected)


@settings(max_examples=60)
@given(st.integers(0, 40), st.data())
def test_of_anything_it_is_right(faces: int, data: st.DataObject) -> None:
    """Random bytes as a tree."""
    mesh = soup(faces)
    count = data.draw(st.integers(0, 20))
    words = data.draw(hnp.arrays(np.uint32, (count, 8)))
    order = data.draw(hnp.arrays(np.uint32, faces))
    box = words[:, :6].copy().view(np.float32)
    tree = Bvh(box[:, :3], box[:, 3:], words[:, 6], words[:, 7], order, count)
    assert not failed(mesh, nearest_tree(mesh, tree))
