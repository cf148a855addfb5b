"""What is wrong with a node is what the checks say of it."""

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from grader.model.mesh import Bvh, Mesh
from grader.view import judging as judging_module
from grader.view.boxes import corners_of, count_of, deepest_of
from grader.view.camera import orbit_around
from grader.view.inspector import facts_of, judgement, next_of, picked
from grader.view.judging import Judging
from grader.view.stage import Stage
from tests.verify.builder import altered, build, changed, soup
from tests.view.shown import of_mesh, until

MESH = soup(40)
TREE = build(MESH)


def test_nothing_is_wrong_with_a_right_tree() -> None:
    """No node is named, and every node says so."""
    known = judgement(MESH, TREE)
    assert not known.unreadable
    assert not known.every.size
    assert facts_of(MESH, TREE, 0, known).faults == ()


def test_a_loose_box_is_named_with_the_right_one() -> None:
    """The node, its faces, its family and the box that it should have are told."""
    bad = changed(TREE, "high", (4, 0), 99.0)
    known = judgement(MESH, bad)
    assert known.every.tolist() == [4]
    facts = facts_of(MESH, bad, 4, known)
    assert facts.parent == 1
    assert facts.children == (9, 10)
    assert facts.level == 2
    assert facts.high[0] == 99.0
    assert facts.right_box == pytest.approx([*TREE.low[4], *TREE.high[4]])
    assert len(facts.faults) == 1
    assert facts.faces.size == facts.end - facts.begin


ROOT = "node 0: "
TWICE = "is in faceIndices"


@pytest.mark.parametrize(
    ("bad", "told"),
    [
        (changed(TREE, "high", (0, 0), 99.0), [ROOT + "box"]),
        (changed(TREE, "begin", 0, 1), [ROOT + "its range"]),
        (changed(TREE, "order", 1, int(TREE.order[0])), [TWICE]),
        (altered(TREE, order=[*TREE.order, 0]), ["faceIndices has more"]),
    ],
    ids=["box", "range", "twice", "more"],
)
def test_what_is_wrong_with_the_whole_is_told_of_the_root(bad: Bvh, told: list[str]) -> None:
    """The rules of the root and of the face indices, in the words of the checks."""
    known = judgement(MESH, bad)
    assert 0 in known.every
    facts = facts_of(MESH, bad, 0, known)
    for text in told:
        assert any(text in fault for fault in facts.faults), facts.faults


def test_the_box_of_the_root_is_that_of_the_mesh() -> None:
    """Also of vertices that no face uses."""
    vertices = np.concatenate([MESH.vertices, np.full((1, 3), 50.0, np.float32)])
    mesh = Mesh(vertices.astype(np.float32), MESH.faces)
    whole = altered(TREE, high=np.concatenate([[[50.0] * 3], TREE.high[1:]]).astype(np.float32))
    known = judgement(mesh, whole)
    assert not known.every.size
    assert facts_of(mesh, whole, 0, known).right_box == ()
    assert facts_of(mesh, TREE, 0, judgement(mesh, TREE)).right_box[3:] == (50.0, 50.0, 50.0)


def test_a_node_that_is_not_split_is_named() -> None:
    """A tree that is one node has too many faces in it."""
    one = altered(
        TREE,
        low=TREE.low[:1],
        high=TREE.high[:1],
        begin=TREE.begin[:1],
        end=TREE.end[:1],
    )
    known = judgement(MESH, one)
    assert known.unsplit.tolist() == [0]
    assert "40 faces" in facts_of(MESH, one, 0, known).faults[0]


def test_children_that_lose_faces_are_named() -> None:
    """The parent of a range that ends too early is wrong."""
    known = judgement(MESH, changed(TREE, "end", 2, int(TREE.end[2]) - 1))
    assert 0 in known.unparted


def test_a_judge_who_fails_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """The tree is shown all the same, and nobody says that nothing is wrong with it."""

    def fails(*_: object) -> None:
        raise MemoryError("no room")

    monkeypatch.setattr(judging_module, "judgement", fails)
    stage = cast("Stage", SimpleNamespace(subject=of_mesh(MESH), tree=TREE))
    judging = Judging()
    until(lambda: bool(judging.failed), lambda: judging.advance(stage, wanted=True))
    assert "MemoryError: no room" in judging.failed
    assert judging.known is None
    assert not judging.is_busy
    judging.forget()
    assert not judging.failed
    judging.close()


def test_a_tree_of_ours_is_not_judged() -> None:
    """It may be altered on purpose, and no fault of it is anybody's."""
    subject = replace(of_mesh(MESH), tree=changed(TREE, "high", (4, 0), 99.0))
    stage = cast("Stage", SimpleNamespace(subject=subject, tree=subject.tree))
    judging = Judging()
    judging.advance(stage, wanted=True)
    assert not judging.is_busy
    judging.close()


def test_garbage_is_described_and_not_trusted() -> None:
    """Ranges and face indices outside of the mesh are told, and never followed."""
    bad = changed(changed(TREE, "end", 3, 4_000_000_000), "order", 0, 4_000_000_000)
    known = judgement(MESH, bad)
    assert known.unreadable
    facts = facts_of(MESH, bad, 3, known)
    assert facts.end == 4_000_000_000
    assert (facts.faces < len(MESH.faces)).all()
    assert facts.faults == (known.unreadable,)


def test_a_tree_without_nodes_says_nothing() -> None:
    """An empty mesh has no node to look at."""
    empty = Mesh(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
    nothing = altered(TREE, low=TREE.low[:0], high=TREE.high[:0], begin=[], end=[], order=[])
    assert not judgement(empty, nothing).every.size
    assert deepest_of(nothing) == -1


def test_the_next_one_comes_after_the_last() -> None:
    """At the end it begins anew."""
    nodes = np.array([3, 7])
    assert [next_of(nodes, after) for after in (-1, 3, 7)] == [3, 7, 3]
    assert next_of(nodes[:0], 5) == -1


def test_the_smallest_box_under_a_pixel_is_picked() -> None:
    """In the middle of the picture lies the root, and in it smaller boxes."""
    orbit = orbit_around(TREE.low[0].astype(np.float64), TREE.high[0].astype(np.float64))
    assert picked(TREE, orbit, (64, 64), (32, 32), (0, True)) == 0
    deeper = picked(TREE, orbit, (64, 64), (32, 32), (2, False))
    assert 0 <= deeper < 7
    assert picked(TREE, orbit, (64, 64), (0, 0), (2, False)) == -1
    assert picked(TREE, orbit, (64, 64), (32, 32), (-1, False)) == -1


def test_levels_are_ranges_of_nodes() -> None:
    """Down to a level, or that level alone; never more than there are."""
    assert count_of(100, 3, only=False) == (0, 15)
    assert count_of(100, 3, only=True) == (7, 15)
    assert count_of(10, 3, only=False) == (0, 10)
    assert count_of(10, -1, only=False) == (0, 0)


def test_boxes_that_cannot_be_drawn_are_left_out() -> None:
    """Empty slots, infinite and unordered numbers become no line on the screen."""
    bad = changed(changed(TREE, "low", (1, 0), np.inf), "end", 2, 0)
    corners = corners_of(bad)
    assert np.isnan(corners[[1, 2]]).all()
    assert np.isfinite(corners[0]).all()
