"""Every tree that the sheet leaves room for passes every check."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.model.cases import DepthCase
from grader.model.mesh import Bvh, Floats, Mesh
from grader.model.trials import ConstructTrial
from grader.model.verdict import Verdict
from tests.verify.builder import (
    CENTRES,
    Reading,
    altered,
    build,
    failed,
    findings,
    mesh_of,
    soup,
    tree_case,
)


def moved(mesh: Mesh, x: float, y: float, z: float) -> Mesh:
    """Move a mesh."""
    return Mesh(mesh.vertices + np.array([x, y, z], np.float32), mesh.faces)


def flat(axis: int) -> Mesh:
    """Press a soup onto a plane through the origin; half of the zeros are negative."""
    vertices = soup(37).vertices.copy()
    vertices[:, axis] = 0.0
    vertices[::2, axis] = -0.0
    return mesh_of(vertices)


def with_lonely_vertex() -> Mesh:
    """Make a soup with a far vertex that no face uses: only the root's box holds it."""
    mesh = soup(37)
    far = np.array([[0, 900, 0]], np.float32)
    return Mesh(np.concatenate([mesh.vertices, far]), mesh.faces)


def concentric() -> Mesh:
    """Make triangles of different sizes with the same centre up to rounding."""
    rng = np.random.default_rng(5)
    around = rng.normal(size=(64, 3, 3))
    return mesh_of(around - around.mean(axis=1, keepdims=True) + (0.1, 0.2, 0.3))


def grid() -> Mesh:
    """Make 8 x 8 equal triangles: every median has ties, and both axes are equally long."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(8.0), np.arange(8.0)))
    corner = np.stack([x, y, 0 * x], axis=1)[:, None]
    return mesh_of(corner + np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))


MESHES = {
    **{f"{faces} faces": soup(faces) for faces in (1, 4, 5, 6, 7, 8, 9, 17, 37, 64, 200)},
    "scaled by 1e4": soup(64, scale=1e4),
    "scaled by 1e-3": soup(64, scale=1e-3),
    "scaled by 1e-20": soup(64, scale=1e-20),
    "denormal": soup(64, scale=1e-43),
    "scaled by 1e18": soup(64, scale=1e18),
    "far away": moved(soup(64), 1000, -2000, 500),
    "far away and small": moved(soup(64, scale=1e-3), 1000, -2000, 500),
    "exponential": mesh_of(
        soup(40).vertices.reshape(-1, 3, 3) * 2.0 ** -np.arange(40.0)[:, None, None]
    ),
    "flat in x": flat(0),
    "flat in y": flat(1),
    "flat in z": flat(2),
    "one point": mesh_of(np.ones((20, 3, 3))),
    "identical": mesh_of(np.tile(soup(1).vertices, (64, 1, 1))),
    "concentric": concentric(),
    "grid": grid(),
    "lonely vertex": with_lonely_vertex(),
}


def last_of_the_longest(extent: Floats) -> int:
    """Take the last of the longest axes."""
    return 2 - int(np.argmax(extent[::-1]))


@pytest.mark.parametrize("mesh", MESHES.values(), ids=MESHES.keys())
@pytest.mark.parametrize("centre", CENTRES)
@pytest.mark.parametrize("other", [False, True])
def test_every_allowed_reading_passes(mesh: Mesh, centre: str, other: bool) -> None:
    """Formulas of the centre, the side of ties and odd faces, the axis of a tie are free."""
    axis = last_of_the_longest if other else Reading().axis
    reading = Reading(CENTRES[centre], axis, odd_left=other, ties_reversed=other)
    assert failed(mesh, build(mesh, reading)) == set()


def of_whole_numbers(faces: int, seed: int, reach: int) -> Mesh:
    """Scatter triangles with few different coordinates: ties of axes and centres everywhere."""
    rng = np.random.default_rng(seed)
    return mesh_of(rng.integers(-reach, reach + 1, (faces, 3, 3)))


ANY_MESH = st.one_of(
    st.builds(soup, st.integers(1, 90), st.integers(0, 99), st.sampled_from([1, 1e-3, 1e4])),
    st.builds(of_whole_numbers, st.integers(1, 90), st.integers(0, 99), st.integers(0, 3)),
    st.sampled_from(list(MESHES.values())),
)
SEEDS = st.integers(0, 2**32 - 1)


@given(ANY_MESH, SEEDS, st.sampled_from(list(CENTRES)), st.integers(0, 40))
def test_every_freedom_at_every_node_passes(
    mesh: Mesh, free: int, centre: str, slots: int
) -> None:
    """Each node decides anew about ties, odd faces and the order of its faces."""
    reading = Reading(CENTRES[centre], slots=slots, free=free)
    assert failed(mesh, build(mesh, reading)) == set()


@settings(max_examples=15)
@given(st.integers(257, 300), SEEDS, st.sampled_from([5, 6]))
def test_the_root_is_level_zero_or_one(faces: int, free: int, depth: int) -> None:
    """Both ways of counting levels end at the limit; a level more or less does not."""
    mesh = soup(faces)
    trial = ConstructTrial("deep", mesh, sanitized=True)

    def verdict(depth: int) -> Verdict:
        bvh = build(mesh, Reading(depth=depth, free=free))
        return findings(DepthCase("deep", trial, bvh, 6))["bvh.depth-is-limited"].verdict

    assert verdict(depth) is Verdict.PASS
    assert verdict(4) is Verdict.FAIL
    assert verdict(7) is Verdict.FAIL


@pytest.mark.parametrize("slots", [1, 2, 3, 50])
@pytest.mark.parametrize("faces", [1, 5, 9, 37])
def test_unused_slots_may_follow(slots: int, faces: int) -> None:
    """Slots past the last used node may be there, empty."""
    mesh = soup(faces)
    assert failed(mesh, build(mesh, Reading(slots=slots))) == set()


@pytest.mark.parametrize("begin", [0, 7, 2**32 - 1])
def test_an_unused_slot_may_hold_anything_but_an_end(begin: int) -> None:
    """What an empty slot says besides `facesEnd` 0 is never read."""
    mesh = soup(9)
    bvh = build(mesh, Reading(slots=8))
    empty = bvh.end == 0
    low = np.where(empty[:, None], np.float32(np.nan), bvh.low)
    tree = altered(bvh, low=low, begin=np.where(empty, begin, bvh.begin))
    assert failed(mesh, tree) == set()


@pytest.mark.parametrize("nodes", [0, 1, 8])
def test_an_empty_mesh_may_have_a_root_or_not(nodes: int) -> None:
    """No nodes at all, the root [0, 0), or a row of empty slots."""
    mesh = mesh_of(np.zeros((0, 3, 3)))
    bvh = build(mesh, Reading(slots=7))
    tree = altered(
        bvh, **{name: getattr(bvh, name)[:nodes] for name in ("low", "high", "begin", "end")}
    )
    assert failed(mesh, tree) == set()
    assert len(findings(tree_case(mesh, tree))) == 3


@pytest.mark.parametrize("count", [2**21, 2**22])
def test_nodes_beyond_those_that_were_read_do_not_matter(count: int) -> None:
    """A generous allocation is cut when it is read, and is still a right tree."""
    mesh = soup(37)
    assert failed(mesh, altered(build(mesh), node_count=count)) == set()


@pytest.mark.parametrize("faces", [5, 8, 9, 17, 18, 35, 37, 64])
def test_a_tree_of_full_levels_passes_where_the_rubric_accepts_it(faces: int) -> None:
    """Stopping at the last full level is a mistake by the sheet, and right by that reading."""
    mesh = soup(faces)
    levels = int(np.log2(faces / 4))
    bvh = build(mesh, Reading(leaf=max(4, -(-faces // 2**levels))))
    assert failed(mesh, bvh, full_levels=True) == set()


@pytest.mark.parametrize("faces", [9, 17, 64])
def test_full_levels_is_no_excuse_for_splitting_small_nodes(faces: int) -> None:
    """Leaves of one face on one level are too small by both readings."""
    mesh = soup(64)
    assert failed(mesh, build(mesh, Reading(leaf=1)), full_levels=True) == {
        "leaves-hold-at-most-four"
    }
    uneven: Bvh = build(soup(faces), Reading(leaf=2))
    found = findings(tree_case(soup(faces), uneven, full_levels=True))
    assert found["bvh.leaves-hold-at-most-four"].verdict is Verdict.FAIL


@pytest.mark.parametrize(("faces", "leaf"), [(33, 8), (37, 37), (10, 10), (64, 32)])
def test_full_levels_is_no_excuse_for_stopping_anywhere(faces: int, leaf: int) -> None:
    """Leaves on two levels, and leaves of more than nine faces, are wrong by both readings."""
    mesh = soup(faces)
    case = tree_case(mesh, build(mesh, Reading(leaf=leaf)), full_levels=True)
    assert findings(case)["bvh.leaves-hold-at-most-four"].verdict is Verdict.FAIL
