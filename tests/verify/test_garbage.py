"""Whatever a submission leaves in memory as its tree, no check is BROKEN by it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.model.cases import DepthCase, RebuildCase
from grader.model.mesh import Bvh, Mesh
from grader.model.trials import ConstructTrial, RebuildTrial
from grader.model.verdict import Verdict
from tests.verify.builder import (
    Reading,
    altered,
    build,
    failed,
    findings,
    mesh_of,
    soup,
    tree_case,
)

MESHES = [mesh_of(np.zeros((0, 3, 3))), soup(1), soup(5), soup(37)]
WORDS = st.one_of(
    st.sampled_from([0, 1, 2, 5, 37, 38, 2**31 - 1, 2**31, 2**32 - 2, 2**32 - 1]),
    st.sampled_from([0x7F800000, 0xFF800000, 0x7FC00000, 0x7F800001, 0x7F7FFFFF, 0xFF7FFFFF]),
)
"""Counts near the mesh's, infinities, quiet and signalling NaN, denormals, largest numbers."""

COUNTS = st.sampled_from([None, 2**22, 2**22 + 1, 2**32, 2**63, 2**64 - 1])


def from_words(nodes: list[int], order: list[int], node_count: int | None) -> Bvh:
    """Make a tree of whatever words were in memory, eight for each node."""
    table = np.array(nodes[: len(nodes) // 8 * 8], np.uint32).reshape(-1, 8)
    corners = np.ascontiguousarray(table[:, :6]).view(np.float32)
    return Bvh(
        low=corners[:, :3],
        high=corners[:, 3:],
        begin=np.ascontiguousarray(table[:, 6]),
        end=np.ascontiguousarray(table[:, 7]),
        order=np.array(order, np.uint32),
        node_count=len(table) if node_count is None else node_count,
    )


def random_words(seed: int, count: int, most: int) -> list[int]:
    """Make random words below a bound."""
    return [int(word) for word in np.random.default_rng(seed).integers(0, most, count)]


@given(
    st.sampled_from(MESHES),
    st.lists(WORDS, max_size=8 * 20),
    st.lists(st.integers(0, 40), max_size=40),
    COUNTS,
)
def test_words_of_all_kinds_break_nothing(
    mesh: Mesh, nodes: list[int], order: list[int], node_count: int | None
) -> None:
    """Every check comes to PASS, FAIL or BLOCKED, and garbage does not pass them all."""
    wrong = failed(mesh, from_words(nodes, order, node_count))
    assert wrong or len(mesh.faces) <= 4


@given(st.sampled_from(MESHES), st.binary(max_size=2000), st.binary(max_size=200), COUNTS)
def test_bytes_of_all_kinds_break_nothing(
    mesh: Mesh, nodes: bytes, order: bytes, node_count: int | None
) -> None:
    """Nobody's memory is a right tree by chance, unless there is nothing to put into one."""
    table, entries = (
        np.frombuffer(part, "<u4", len(part) // 4).tolist() for part in (nodes, order)
    )
    bvh = from_words(table, entries, node_count)
    assert failed(mesh, bvh) or len(mesh.faces) == 0


@given(
    st.integers(0, 2**32),
    st.integers(0, 60),
    st.sampled_from([3, 6, 37, 38, 39, 2**32]),
)
def test_random_ranges_over_a_permutation_break_nothing(
    seed: int, count: int, most: int
) -> None:
    """Readable indices let the garbage in the nodes get past the first check."""
    mesh = MESHES[-1]
    words = random_words(seed, 8 * count, most)
    assert failed(mesh, from_words(words, list(range(37)), None))


@settings(max_examples=300)
@given(
    st.sampled_from(["low", "high", "begin", "end", "order"]),
    st.lists(st.tuples(st.integers(0, 36), st.integers(0, 2), WORDS), min_size=1, max_size=4),
)
def test_a_right_tree_with_some_wrong_words_breaks_nothing(
    field: str, changes: list[tuple[int, int, int]]
) -> None:
    """A few changed words are the likeliest garbage; only unused slots may change and pass."""
    mesh = MESHES[-1]
    right = build(mesh, Reading(slots=2))
    array = getattr(right, field).copy()
    words = array.view(np.uint32).reshape(len(array), -1)
    for row, column, word in changes:
        words[row % len(words), column % words.shape[1]] = word
    bvh = altered(right, **{field: array})
    if not failed(mesh, bvh) and field != "order":
        used = right.end > 0
        assert (getattr(bvh, field)[used] == getattr(right, field)[used]).all()


@given(st.lists(WORDS, max_size=80), st.lists(WORDS, max_size=40), COUNTS)
def test_garbage_of_a_second_construct_breaks_nothing(
    nodes: list[int], order: list[int], node_count: int | None
) -> None:
    """The comparison of trees copes with garbage on both sides, and so does the depth."""
    mesh, garbage = MESHES[2], from_words(nodes, order, node_count)
    labels = ("first", "other", "second", "third", "later")
    for trees in ((build(mesh), garbage), (garbage, build(mesh)), (garbage, garbage)):
        case = RebuildCase(
            "rebuild",
            RebuildTrial("rebuild", mesh, mesh),
            tuple((label, mesh, trees[k % 2]) for k, label in enumerate(labels)),
            garbage,
            (),
        )
        found = findings(case)["bvh.rebuild-starts-afresh"]
        assert found.verdict in (Verdict.PASS, Verdict.FAIL)
    deep = DepthCase("deep", ConstructTrial("deep", soup(300), sanitized=True), garbage, 6)
    assert findings(deep)["bvh.depth-is-limited"].verdict in (Verdict.PASS, Verdict.FAIL)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 3.4e38, 1e-45])
def test_boxes_that_are_no_boxes_break_nothing(value: float) -> None:
    """Extents that overflow or are not a number are wrong, and no warning comes out."""
    mesh = MESHES[-1]
    right = build(mesh)
    for sign in (1, -1):
        bvh = altered(
            right,
            low=np.full_like(right.low, -value * sign),
            high=np.full_like(right.high, value),
        )
        assert failed(mesh, bvh) >= {"root-holds-all-faces", "boxes-are-tight"}


def test_a_tree_whose_nodes_all_claim_everything_is_judged() -> None:
    """A vector filled with copies of the root: half a million nodes of 70,000 faces each.

    Taking minima node by node would look at 37 thousand million faces.
    """
    mesh = soup(70_000)
    count = 2**19 - 1
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    bvh = Bvh(
        low=np.tile(low, (count, 1)),
        high=np.tile(high, (count, 1)),
        begin=np.zeros(count, np.uint32),
        end=np.full(count, 70_000, np.uint32),
        order=np.arange(70_000, dtype=np.uint32),
        node_count=count,
    )
    found = findings(tree_case(mesh, bvh))
    partition = found["bvh.children-partition-their-parent"]
    assert partition.evidence.wrong == 2**18 - 1
    # All boxes are those of all faces, which each node claims to hold: that part is right.
    assert found["bvh.boxes-are-tight"].verdict is Verdict.PASS
