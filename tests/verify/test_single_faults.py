"""One wrong number in a right tree fails its owner, and else only checks that hang on it."""

from functools import cache

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from grader.model.mesh import Bvh, Mesh
from grader.tolerances import NODE_CAPACITY
from grader.verify.tree import shape
from tests.verify.builder import Reading, altered, build, changed, failed, soup

ROOT, READABLE = "root-holds-all-faces", "is-readable"
PERMUTATION, PARTITION = "face-indices-are-a-permutation", "children-partition-their-parent"
LEAVES, BOXES = "leaves-hold-at-most-four", "boxes-are-tight"
AXIS, MEDIAN = "splits-the-longest-axis", "splits-at-the-median"
SPLITS = {AXIS, MEDIAN}
EVERY = {ROOT, READABLE, PERMUTATION, PARTITION, LEAVES, BOXES, AXIS, MEDIAN}

MESHES = {faces: soup(faces) for faces in (5, 6, 9, 17, 37, 64)}
FACES = st.sampled_from(list(MESHES))
FREE = st.integers(0, 3)
PICK = st.integers(0, 10**6)


@cache
def right_tree(faces: int, free: int) -> tuple[Mesh, Bvh]:
    """Build one of the right trees of a mesh, with unused slots at its end."""
    mesh = MESHES[faces]
    return mesh, build(mesh, Reading(free=free, slots=3))


def used_below_root(bvh: Bvh) -> list[int]:
    """Nodes in use but for the root."""
    return [int(node) for node in shape(bvh).reached[1:]]


def wrong_coordinate(right: np.float32, kind: int) -> np.float32:
    """Make a coordinate that is not the right one: a hair off, far off, or no number."""
    kinds = (
        np.nextafter(right, np.float32(np.inf)),
        np.nextafter(right, np.float32(-np.inf)),
        np.float32(np.nan),
        np.float32(np.inf),
        np.float32(-np.inf),
        -right,
        np.float32(0),
    )
    return kinds[kind]


@settings(max_examples=100)
@given(FACES, PICK, st.integers(0, 2), st.sampled_from(["low", "high"]), st.integers(0, 6))
def test_a_coordinate_of_a_box_is_owned_by_one_check(
    faces: int, pick: int, axis: int, corner: str, kind: int
) -> None:
    """The root's box belongs to the root, every other one to its own triangles."""
    mesh, right = right_tree(faces, pick % 4)
    nodes = [0, *used_below_root(right)]
    node = nodes[pick % len(nodes)]
    value = wrong_coordinate(getattr(right, corner)[node, axis], kind)
    assume(value != getattr(right, corner)[node, axis])
    tree = changed(right, corner, (node, axis), float(value))
    assert failed(mesh, tree) == {BOXES if node else ROOT}


@settings(max_examples=100)
@given(FACES, FREE, PICK, st.sampled_from(["begin", "end"]), st.integers(0, 70))
def test_a_bound_of_a_range_is_owned_by_the_root_or_the_partition(
    faces: int, free: int, pick: int, bound: str, value: int
) -> None:
    """Or by readability, if no such range of faces exists; then nothing else is looked at."""
    mesh, right = right_tree(faces, free)
    nodes = [0, *used_below_root(right)]
    node = nodes[pick % len(nodes)]
    assume(value != getattr(right, bound)[node])
    tree = changed(right, bound, node, value)
    wrong = failed(mesh, tree)
    in_use = node == 0 or tree.end[node] > 0
    if in_use and not tree.begin[node] <= tree.end[node] <= faces:
        assert wrong == EVERY
        return
    owner = PARTITION if node else ROOT
    assert owner in wrong
    # The node holds other faces than its box and its children say.
    assert wrong <= {owner, PARTITION, LEAVES, BOXES, *SPLITS}


@settings(max_examples=50)
@given(FACES, FREE, PICK, st.integers(0, 2**32 - 1))
def test_an_entry_of_the_face_indices_is_owned_by_the_permutation(
    faces: int, free: int, pick: int, value: int
) -> None:
    """Or by readability, if there is no such face."""
    mesh, right = right_tree(faces, free)
    value = value if value % 2 else value % faces
    place = pick % faces
    assume(value != right.order[place])
    wrong = failed(mesh, changed(right, "order", place, value))
    if value >= faces:
        assert wrong == EVERY
    else:
        assert PERMUTATION in wrong
        # Another face lies in a leaf: its box and the splits above may not fit it.
        assert wrong <= {PERMUTATION, BOXES, *SPLITS}


@settings(max_examples=50)
@given(FACES, FREE, PICK, PICK)
def test_faces_exchanged_between_leaves_are_seen_by_boxes_or_splits(
    faces: int, free: int, one: int, other: int
) -> None:
    """It is still a permutation, and all ranges are right."""
    mesh, right = right_tree(faces, free)
    one, other = one % faces, other % faces
    leaves = shape(right).leaves
    holds = [
        np.flatnonzero((right.begin[leaves] <= k) & (k < right.end[leaves]))
        for k in (one, other)
    ]
    assume((holds[0] != holds[1]).all())
    order = right.order.copy()
    order[[one, other]] = order[[other, one]]
    wrong = failed(mesh, altered(right, order=order))
    assert BOXES in wrong
    assert wrong <= {BOXES, *SPLITS}


@settings(max_examples=20)
@given(FACES, FREE, st.integers(NODE_CAPACITY + 1, 2**64 - 1))
def test_a_number_of_nodes_beyond_all_trees_is_unreadable(
    faces: int, free: int, count: int
) -> None:
    """Nothing else is looked at then."""
    mesh, right = right_tree(faces, free)
    assert failed(mesh, altered(right, node_count=count)) == EVERY


@settings(max_examples=50)
@given(FACES, FREE, PICK, st.integers(1, 2**32 - 1))
def test_an_unused_slot_that_claims_to_be_used_is_seen(
    faces: int, free: int, pick: int, end: int
) -> None:
    """A child of a leaf, or of nothing: the latter is out of reach and may hold anything."""
    mesh, right = right_tree(faces, free)
    unused = np.flatnonzero(right.end == 0)
    node = int(unused[pick % unused.size])
    wrong = failed(mesh, changed(right, "end", node, end))
    parent = (node - 1) // 2
    if parent not in shape(right).leaves:
        assert wrong == set()
    elif end > faces:
        assert wrong == EVERY
    else:
        assert PARTITION in wrong
        assert wrong <= {PARTITION, LEAVES, BOXES, *SPLITS}
