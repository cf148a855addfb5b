"""A hit is lost at the node where it was lost, whatever the submission's process tells."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from grader.counterexample.explain import Setting, false_hit, lost_hit, way_to
from grader.counterexample.shown import steps_of
from grader.counterexample.table import path_table, tree_table
from grader.model.mesh import Bvh, Rays
from grader.model.path import NO_NODE, Path
from tests.counterexample.paths import PILE, TREE, Walk
from tests.verify.builder import build, changed, soup

LEFT = TREE.order[TREE.begin[1] : TREE.end[1]].tolist()
RIGHT = TREE.order[TREE.begin[2] : TREE.end[2]].tolist()
FACE = LEFT[0]


@pytest.mark.parametrize(
    ("walk", "found", "node", "words"),
    [
        (Walk().box(0).box(2).face(RIGHT[0], 5.0), 5.0, 1, "was never visited after node 0"),
        (Walk().box(0).box(1, hit=False).box(2), np.inf, 1, "its box was not hit"),
        (Walk().box(0).box(1, hit=False, t_max=0.5), np.inf, 1, "tested with t_max = 0.5"),
        (Walk().box(0, hit=False), np.inf, 0, "node 0, on the way to face"),
        (Walk().box(0).box(1).face(LEFT[1], None), np.inf, 1, "which is in it, was not tested"),
        (
            Walk().box(0, known=False).box(1, known=False),
            np.inf,
            1,
            "which is in it, was not tested",
        ),
        (Walk().face(LEFT[1], None), np.inf, 1, "which is in it, was not tested"),
        (Walk().face(FACE, 1.0).face(RIGHT[0], 5.0), 5.0, 1, "overwritten by a hit at t = 5"),
        (Walk().face(RIGHT[0], 5.0).face(FACE, 1.0), 5.0, 1, "from before was kept"),
        (Walk().face(FACE, 1.0, turn=1), np.inf, 1, "that hit was not returned"),
        (Walk().face(FACE, None, t_max=0.5), np.inf, 1, "t in (0, 0.5), and was not hit"),
        (
            Walk().face(FACE, 1.0).face(RIGHT[0], 5.0).face(FACE, None, t_max=1.0),
            5.0,
            1,
            "overwritten by a hit at t = 5",
        ),
        (Walk(), np.inf, 1, "neither of the given tests was called"),
    ],
)
def test_the_node_that_lost_a_hit_is_named(
    walk: Walk, found: float, node: int, words: str
) -> None:
    """Box not hit, never visited, overwritten, absent from the leaf, or not seen at all."""
    told = lost_hit(walk.setting(found), FACE, 1.0)
    assert words in told.text
    assert told.node == node
    assert f"face {FACE}" in told.text


def test_a_path_that_was_cut_is_not_taken_for_the_whole() -> None:
    """What was not recorded may have been tested; what was recorded was."""
    walk = Walk().box(0).box(2).face(RIGHT[0], 5.0)
    missed = lost_hit(shortened(walk.setting(5.0)), FACE, 1.0)
    assert missed.text.startswith(
        f"only the first 3 of 5000 tests were recorded, and none of them is of face {FACE}"
    )
    assert missed.node == -1
    tested = lost_hit(shortened(walk.face(FACE, None, t_max=0.5).setting(5.0)), FACE, 1.0)
    assert "t in (0, 0.5), and was not hit" in tested.text
    alien = false_hit(shortened(walk.setting(3.0)))
    assert alien.text.startswith("none of the first 4 of 5000 tests gave t = 3")


def shortened(setting: Setting) -> Setting:
    """Say that there were more tests than the path holds."""
    return replace(setting, path=replace(setting.path, total=5000))


def test_a_face_in_no_leaf_is_said_to_be_in_none() -> None:
    """Of an altered tree a face may be gone."""
    bare = changed(TREE, "begin", 1, TREE.end[1])
    assert way_to(bare, FACE) == []
    setting = Setting(PILE, bare, Walk().box(0).setting().path)
    assert lost_hit(setting, FACE, 1.0).text == f"face {FACE} is in no leaf of this tree"


@pytest.mark.parametrize(
    ("walk", "words"),
    [
        (Walk().face(0, 3.0), "from a face that was tested with t in (0, inf)"),
        (Walk().face(0, 9.0), "no test of a face gave t = 3"),
        (Walk(), "neither of the given tests was called"),
    ],
)
def test_a_hit_that_is_not_there_comes_from_somewhere(walk: Walk, words: str) -> None:
    """The test that gave it, or none."""
    assert words in false_hit(walk.setting(3.0)).text


@settings(max_examples=40)
@given(st.data())
def test_whatever_a_path_says_it_is_explained(data: st.DataObject) -> None:
    """Any bits as a path: a sentence and a node of the tree, never an exception."""
    count = data.draw(st.integers(0, 6))
    words = data.draw(hnp.arrays(np.uint32, (count, 15)))
    floats = words[:, 3:].view(np.float32)
    path = Path(
        is_box=words[:, 0] % 2 == 0,
        hit=words[:, 1] % 2 == 0,
        node=words[:, 2],
        t=floats[:, 0].copy(),
        t_min=floats[:, 1].copy(),
        t_max=floats[:, 2].copy(),
        corners=floats[:, 3:].copy(),
        found=float(data.draw(st.floats(width=32))),
        total=data.draw(st.integers(count, 2**64 - 1)),
    )
    setting = Setting(PILE, TREE, path)
    for told in (lost_hit(setting, FACE, 1.0), false_hit(setting)):
        assert told.text
        assert -1 <= told.node < len(TREE.end)


def test_a_table_of_the_same_tree_has_no_difference() -> None:
    """A column a node, and the leaves' faces with a stroke between them."""
    table = tree_table(TREE, TREE)
    assert [(one.node, one.expected, one.got) for one in table.columns] == [
        (0, "[0,5)", "[0,5)"),
        (1, "[0,2)", "[0,2)"),
        (2, "[2,5)", "[2,5)"),
    ]
    assert table.first_difference == -1
    assert table.expected_faces == table.got_faces
    assert table.got_faces.count("|") == 1


@pytest.mark.parametrize(
    ("tree", "place"),
    [
        (changed(TREE, "end", 1, 3), 1),
        (changed(TREE, "end", 2, 0), 2),
        (changed(TREE, "low", (1, 0), -99.0), 1),
        (changed(TREE, "order", 0, RIGHT[0]), 0),
    ],
)
def test_the_first_difference_is_marked(tree: Bvh, place: int) -> None:
    """Ranges, empty slots, boxes and the faces of a node all count."""
    assert tree_table(TREE, tree).first_difference == place


def test_a_path_stands_against_what_a_plain_traversal_sees() -> None:
    """Expected is what the given box test says; `-` was not tested."""
    down = Rays(
        np.array([[0, 0, -5]], np.float32),
        np.array([[0, 0, 1]], np.float32),
        np.zeros(1, np.float32),
        np.full(1, np.inf, np.float32),
    )
    setting = Walk().box(0).box(2, hit=False).setting()
    table = path_table(setting, down, 1)
    assert [(one.expected, one.got) for one in table.columns] == [
        ("hit", "hit"),
        ("hit", "-"),
        ("hit", "miss"),
    ]
    assert (table.first_difference, table.got_faces) == (1, "")


def test_a_copied_box_is_known_by_its_corners() -> None:
    """Bit by bit, and of several equal boxes it is the first; other boxes are no node's."""
    walk = Walk().box(2, known=False).box(0).box(1, known=False).face(0, None)
    setting = walk.setting()
    assert setting.nodes().tolist() == [2, 0, 1, -1]
    low, high = (np.repeat(each[:1], len(each), axis=0) for each in (TREE.low, TREE.high))
    alike = replace(TREE, low=low, high=high)
    assert Setting(PILE, alike, Walk().box(0, known=False).setting().path).nodes()[0] == 0
    corners = setting.path.corners.copy()
    corners[0, 0] = np.nextafter(corners[0, 0], np.float32(np.inf))
    other = replace(setting.path, corners=corners)
    assert Setting(PILE, TREE, other).nodes().tolist() == [-1, 0, 1, -1]


@pytest.mark.parametrize("alike", [False, True], ids=["right", "alike"])
def test_copied_boxes_of_a_large_tree_are_known_too(alike: bool) -> None:
    """Also where every box is the same: then it is the root's."""
    mesh = soup(9_000)
    tree = build(mesh)
    if alike:
        low, high = (np.full_like(each, np.nan) for each in (tree.low, tree.high))
        tree = replace(tree, low=low, high=high)
    nodes = np.flatnonzero(tree.end)[:: len(tree.end) // 20]
    count, sides = len(nodes), [tree.low[nodes], tree.high[nodes]]
    corners = np.concatenate([*sides, np.zeros((count, 3), np.float32)], axis=1)
    none, all_of_them = np.zeros(count, np.float32), np.ones(count, np.bool_)
    unknown = np.full(count, NO_NODE, np.uint32)
    path = Path(all_of_them, all_of_them, unknown, none, none, none, corners, 1.0, count)
    told = [step.node for step in steps_of(Setting(mesh, tree, path))]
    assert told == ([0] * count if alike else nodes.tolist())
