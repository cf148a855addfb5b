"""What a second call of `construct` may not leave behind."""

import numpy as np
import pytest

from grader.model.cases import RebuildCase
from grader.model.mesh import Bvh, Mesh
from grader.model.trials import RebuildTrial
from grader.model.verdict import Evidence
from grader.verify.rebuild import rebuild_starts_afresh
from tests.verify.builder import Reading, altered, build, changed, soup

MESH = soup(37)
OTHER = soup(12, seed=8)
LABELS = ("first", "other tree", "second", "third", "other tree, later")


def rebuilt(alone: Bvh | None = None, **replaced: Bvh) -> Evidence:
    """Judge five trees of A, B, B, A, B, some of them replaced; names use underscores."""
    meshes = (MESH, OTHER, OTHER, MESH, OTHER)
    trees = tuple(
        (label, mesh, replaced.get(label.split(",")[0].replace(" ", "_"), build(mesh)))
        for label, mesh in zip(LABELS, meshes, strict=True)
    )
    trial = RebuildTrial("rebuild", MESH, OTHER)
    after = (("A", MESH, MESH), ("B", OTHER, OTHER))
    case = RebuildCase("rebuild", trial, trees, alone or build(OTHER), after)
    return rebuild_starts_afresh.decide(case)


def test_the_same_trees_again_are_fresh() -> None:
    """Trees that differ at most in the order of ties are the same."""
    assert rebuilt().wrong == 0
    tied = build(OTHER, Reading(ties_reversed=True))
    assert rebuilt(second=tied).wrong == 0
    assert rebuilt(third=build(MESH, Reading(slots=9))).wrong == 0


@pytest.mark.parametrize("seed", range(3))
def test_an_odd_face_may_be_elsewhere(seed: int) -> None:
    """Both sides are right, for every node and every call."""
    assert rebuilt(third=build(MESH, Reading(free=seed))).wrong == 0


@pytest.mark.parametrize(
    ("known", "later", "text"),
    [
        (Reading(leaf=12), Reading(shift=1), "second: 7 nodes are in use, but 1 in a new tree"),
        (Reading(shift=1), Reading(), "second: the nodes' ranges are not those of a new tree"),
    ],
)
def test_a_tree_that_is_always_wrong_is_the_same_again(
    known: Reading, later: Reading, text: str
) -> None:
    """Where the fresh tree is no right one, every difference counts."""
    wrong = build(OTHER, known)
    evidence = rebuilt(alone=wrong, other_tree=wrong, second=build(OTHER, later))
    assert evidence.examples[0].message.startswith(text)


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        (altered(build(OTHER), order=[*build(OTHER).order, 0]), "second: faceIndices does not"),
        (altered(build(OTHER), order=[]), "second: faceIndices has 0 entries"),
        (build(OTHER, Reading(leaf=12)), "second: node 0 holds 12 faces and is a leaf"),
        (build(OTHER, Reading(shift=1)), "second: node 0 is divided into 7 and 5 faces"),
        (changed(build(OTHER), "end", 6, 11), "second: node 2 holds [6, 12), but its children"),
        (changed(build(OTHER), "begin", 6, 10), "second: node 2 holds [6, 12), but its"),
    ],
)
def test_what_is_left_of_the_first_call_is_named(tree: Bvh, text: str) -> None:
    """Appended indices, kept nodes and old ranges are the usual traces."""
    evidence = rebuilt(second=tree)
    assert evidence.wrong == 1
    assert evidence.examples[0].message.startswith(text)


@pytest.mark.parametrize("name", ["second", "third"])
def test_each_later_call_is_looked_at(name: str) -> None:
    """The second and the third call are compared with the first for their mesh."""
    wrong = build(MESH if name == "third" else OTHER, Reading(leaf=2))
    assert rebuilt(**{name: wrong}).wrong == 1


def test_a_mistake_that_a_fresh_tree_has_too_is_not_left_over() -> None:
    """What the second mesh always shows is the business of other checks."""
    wrong = build(OTHER, Reading(shift=1))
    same = {"other_tree": wrong, "second": wrong}
    assert rebuilt(alone=wrong, **same).wrong == 0
    assert rebuilt(**same).examples[0].message.startswith("other tree: ")


def test_unreadable_trees_are_compared_all_the_same() -> None:
    """A tree that is always unreadable in the same way starts afresh."""
    broken = altered(build(MESH), order=[])
    assert rebuilt(first=broken, third=broken).wrong == 0
    assert rebuilt(first=broken).wrong == 1


@pytest.mark.parametrize("field", ["vertices", "faces"])
def test_a_touched_mesh_is_named(field: str) -> None:
    """A single changed bit of the mesh is a mistake, also the sign of a zero."""
    flat = Mesh(MESH.vertices * np.array([1, 1, 0], np.float32), MESH.faces)
    touched = Mesh(flat.vertices.copy(), flat.faces.copy())
    array = getattr(touched, field)
    array.setflags(write=True)
    array.view(np.uint32)[3, 2] ^= 1 << 31
    after = (("A", flat, flat), ("B", flat, touched))
    case = RebuildCase("rebuild", RebuildTrial("rebuild", flat, flat), (), build(flat), after)
    evidence = rebuild_starts_afresh.decide(case)
    assert evidence.examples[0].message == "mesh B has changed, but construct may only read it"


def test_a_mesh_of_another_size_has_changed() -> None:
    """A vertex too many is a change."""
    grown = Mesh(np.concatenate([MESH.vertices, MESH.vertices[:1]]), MESH.faces)
    case = RebuildCase(
        "rebuild", RebuildTrial("r", MESH, MESH), (), build(MESH), (("A", MESH, grown),)
    )
    assert rebuild_starts_afresh.decide(case).wrong == 1
