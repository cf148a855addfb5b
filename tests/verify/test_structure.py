"""Wrong shapes of trees, and which check says so."""

import numpy as np
import pytest

from grader.model.cases import SurvivalCase
from grader.model.mesh import Bvh, Mesh
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial
from grader.model.verdict import Evidence, Verdict
from grader.verify.structure import (
    face_indices_are_a_permutation,
    root_holds_all_faces,
    survives_every_mesh,
    unreadable,
)
from tests.verify.builder import (
    Reading,
    altered,
    build,
    changed,
    failed,
    findings,
    mesh_of,
    soup,
    tree_case,
)

MESH = soup(37)
BVH = build(MESH)
EMPTY = mesh_of(np.zeros((0, 3, 3)))
LEAF = int(np.flatnonzero(BVH.end)[-1])
NEVER = 2**32 - 1


def message(mesh: Mesh, bvh: Bvh) -> str:
    """Word what makes a tree unreadable; empty if nothing does."""
    example = unreadable(mesh, bvh)
    return example.message if example else ""


@pytest.mark.parametrize(
    ("bvh", "text"),
    [
        (
            altered(BVH, low=np.zeros((0, 3)), high=np.zeros((0, 3)), begin=[], end=[]),
            "no nodes",
        ),
        (
            altered(BVH, node_count=2**22 + 1),
            "there are 4,194,305 nodes, but at most 4,194,304 nodes are read; depth 20 has",
        ),
        (altered(BVH, node_count=2**63), "there are 9,223,372,036,854,775,808 nodes"),
        (altered(BVH, order=BVH.order[:-1]), "faceIndices has 36 entries"),
        (altered(BVH, order=[]), "faceIndices has 0 entries"),
        (changed(BVH, "end", 0, 38), "node 0: its range is [0, 38)"),
        (changed(BVH, "end", 1, NEVER), "node 1: its range is [0, 4294967295)"),
        (changed(BVH, "begin", 1, NEVER), "node 1: its range is [4294967295, 18)"),
        (changed(BVH, "begin", LEAF, int(BVH.end[LEAF]) + 1), f"node {LEAF}: its range is"),
        (changed(BVH, "order", 0, 37), "faceIndices[0] is 37, but the last face is 36"),
        (changed(BVH, "order", 36, NEVER), "faceIndices[36] is 4294967295"),
    ],
)
def test_what_leaves_the_mesh_is_unreadable(bvh: Bvh, text: str) -> None:
    """Counts, ranges and indices that leave the mesh are named, and block the other checks."""
    assert text in message(MESH, bvh)
    found = findings(tree_case(MESH, bvh))
    assert found.pop("bvh.is-readable").verdict is Verdict.FAIL
    assert {each.verdict for each in found.values()} == {Verdict.BLOCKED}
    assert {each.reason for each in found.values()} == {"bvh.is-readable"}


def test_the_largest_allowed_values_are_readable() -> None:
    """Ranges up to the number of faces, 2^22 nodes and a spare face index can be read."""
    assert message(MESH, altered(BVH, node_count=2**22)) == ""
    assert message(MESH, altered(BVH, order=[*BVH.order, NEVER])) == ""
    assert message(EMPTY, build(EMPTY)) == ""
    assert message(EMPTY, changed(build(EMPTY), "end", 0, 1)) != ""


@pytest.mark.parametrize(
    ("field", "value"), [("begin", 1), ("end", 36), ("end", 0), ("begin", 37)]
)
def test_a_root_without_all_faces_fails(field: str, value: int) -> None:
    """The root's range is [0, faces) and nothing else."""
    evidence = root_holds_all_faces.decide(tree_case(MESH, changed(BVH, field, 0, value)))
    assert evidence.wrong == 1
    assert evidence.examples[0].expected == "[0, 37)"


@pytest.mark.parametrize("field", ["low", "high"])
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("x", [1e-45, 0.5, -1.0, np.nan, np.inf])
def test_one_wrong_coordinate_of_the_root_is_its_own_mistake(
    field: str, axis: int, x: float
) -> None:
    """A wrong corner of the root fails this check and no other."""
    assert failed(MESH, changed(BVH, field, (0, axis), x)) == {"root-holds-all-faces"}


def test_an_empty_mesh_has_no_face_to_hold() -> None:
    """The root of an empty mesh holds the range [0, 0)."""
    assert failed(EMPTY, build(EMPTY)) == set()
    root = changed(changed(build(EMPTY), "begin", 0, 0), "end", 0, 1)
    evidence = root_holds_all_faces.decide(tree_case(EMPTY, root))
    assert evidence.examples[0].message == "node 0 holds faces of an empty mesh"


@pytest.mark.parametrize("place", [0, 17, 36])
def test_a_doubled_face_is_named_with_the_lost_one(place: int) -> None:
    """One index written over another doubles one face and loses one."""
    other = int(BVH.order[place - 1])
    bvh = changed(BVH, "order", place, other)
    evidence = face_indices_are_a_permutation.decide(tree_case(MESH, bvh))
    assert evidence.wrong == 2
    assert evidence.examined == 37
    assert {example.got for example in evidence.examples} == {"0 times", "2 times"}
    assert "face-indices-are-a-permutation" in failed(MESH, bvh)


@pytest.mark.parametrize("mesh", [MESH, EMPTY])
def test_more_indices_than_faces_are_no_permutation(mesh: Mesh) -> None:
    """An index too many is what a second construct leaves that only appends."""
    bvh = build(mesh)
    assert failed(mesh, altered(bvh, order=[*bvh.order, 0])) == {
        "face-indices-are-a-permutation"
    }


@pytest.mark.parametrize("node", [1, 2, 3, 6, LEAF])
@pytest.mark.parametrize(
    ("field", "by"), [("begin", 1), ("begin", -1), ("end", 1), ("end", -1)]
)
def test_a_child_that_is_off_by_one_breaks_the_partition(
    node: int, field: str, by: int
) -> None:
    """Gaps, overlaps and faces outside the parent: each moves one end of one child."""
    value = int(getattr(BVH, field)[node]) + by
    bvh = changed(BVH, field, node, value % 2**32)
    if value < 0 or value > 37:
        assert failed(MESH, bvh) > {"is-readable"}
    else:
        assert "children-partition-their-parent" in failed(MESH, bvh)


@pytest.mark.parametrize("node", [1, 2, 5, LEAF])
def test_a_single_child_is_named(node: int) -> None:
    """A node with only one used child loses the faces of the other."""
    found = findings(tree_case(MESH, changed(BVH, "end", node, 0)))
    finding = found["bvh.children-partition-their-parent"]
    assert finding.verdict is Verdict.FAIL
    assert f"node {(node - 1) // 2} holds" in finding.evidence.examples[0].message


def test_a_child_beyond_the_last_node_is_said_to_be_missing() -> None:
    """Nodes cut off after a left child leave a node with half of its children."""
    arrays = {name: getattr(BVH, name)[:2] for name in ("low", "high", "begin", "end")}
    found = findings(tree_case(MESH, altered(BVH, **arrays)))
    text = found["bvh.children-partition-their-parent"].evidence.examples[0].message
    assert text.endswith("its children 1 and 2 hold [0, 18) and nothing (no such node)")


def test_swapped_children_do_not_partition() -> None:
    """The left child holds the first half, not the second."""
    order = [0, 2, 1]
    nodes = {
        name: getattr(build(soup(8)), name)[order] for name in ("low", "high", "begin", "end")
    }
    assert "children-partition-their-parent" in failed(
        soup(8), altered(build(soup(8)), **nodes)
    )


def test_an_empty_half_is_no_partition() -> None:
    """A child that holds all and one that holds none make no progress."""
    bvh = build(soup(8))
    bvh = changed(changed(bvh, "end", 1, 8), "begin", 2, 8)
    assert failed(soup(8), bvh) >= {"children-partition-their-parent"}


@pytest.mark.parametrize(
    ("leaf", "faces", "wrong"), [(5, 37, 5), (3, 37, 3), (1, 8, 6), (8, 8, 1), (36, 37, 2)]
)
def test_leaves_of_another_size_are_counted(leaf: int, faces: int, wrong: int) -> None:
    """Every leaf of more than four faces and every split node of four or fewer is wrong."""
    mesh = soup(faces)
    found = findings(tree_case(mesh, build(mesh, Reading(leaf=leaf))))
    evidence = found["bvh.leaves-hold-at-most-four"].evidence
    assert evidence.wrong == wrong
    assert evidence.examples[0].message.startswith("node ")


def test_an_unsplit_root_shows_nothing_of_splits() -> None:
    """The given code's tree passes what it gives and fails everything about splits."""
    bvh = build(MESH, Reading(leaf=37))
    assert failed(MESH, bvh) == {
        "children-partition-their-parent",
        "leaves-hold-at-most-four",
        "boxes-are-tight",
        "splits-the-longest-axis",
        "splits-at-the-median",
    }


@pytest.mark.parametrize("stop", [each for each in Stop if each is not Stop.FINISHED])
def test_a_worker_that_does_not_finish_does_not_survive(stop: Stop) -> None:
    """Every other end of a worker fails, with the words for the student."""
    case = SurvivalCase("cube", ConstructTrial("cube", MESH), Ending(stop, "why", 1, 1, ""))
    evidence = survives_every_mesh.decide(case)
    assert (evidence.wrong, evidence.stop) == (1, stop)
    assert evidence.examples[0].message == "why"


def test_a_worker_that_finishes_survives() -> None:
    """A worker that came back passes."""
    ending = Ending(Stop.FINISHED, "", 1, 1, "")
    case = SurvivalCase("cube", ConstructTrial("cube", MESH), ending)
    assert survives_every_mesh.decide(case) == Evidence(1, 0)
