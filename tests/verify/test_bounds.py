"""Boxes that are not tight, and what sanitizers found."""

import numpy as np
import pytest

from grader.model.cases import MemoryCase
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial
from grader.model.verdict import Evidence
from grader.verify.bounds import boxes_are_tight, construct_memory_is_safe
from tests.verify.builder import altered, box, build, changed, failed, soup, tree_case

MESH = soup(37)
BVH = build(MESH)
USED = np.flatnonzero(BVH.end)[1:]


@pytest.mark.parametrize("field", ["low", "high"])
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("node", [1, 2, int(USED[len(USED) // 2]), int(USED[-1])])
@pytest.mark.parametrize("x", ["wider", "narrower", "nan", "inf", "zero"])
def test_one_wrong_coordinate_is_named(field: str, axis: int, node: int, x: str) -> None:
    """A hair off, empty or NaN: the message names the node, and no other check fails."""
    old = getattr(BVH, field)[node, axis]
    values = {
        "wider": np.nextafter(old, np.float32(np.inf)),
        "narrower": np.nextafter(old, np.float32(-np.inf)),
        "nan": np.nan,
        "inf": np.inf,
        "zero": 0.0,
    }
    bvh = changed(BVH, field, (node, axis), float(values[x]))
    (example,) = boxes_are_tight.decide(tree_case(MESH, bvh)).examples
    assert example.message.startswith(f"node {node}: box is (")
    assert example.message.endswith(f"but its triangles span {example.expected}")
    assert failed(MESH, bvh) == {"boxes-are-tight"}


def test_every_used_node_but_the_root_is_examined() -> None:
    """A wrong root's box is another check's finding."""
    case = tree_case(MESH, changed(BVH, "low", (0, 0), 9.0))
    assert boxes_are_tight.decide(case) == Evidence(USED.size, 0)


def test_messages_tell_neighbours_apart() -> None:
    """Two float32 that differ in the last bit are never printed alike."""
    old = BVH.low[1, 0]
    bvh = changed(BVH, "low", (1, 0), float(np.nextafter(old, np.float32(9))))
    (example,) = boxes_are_tight.decide(tree_case(MESH, bvh)).examples
    assert example.got != example.expected


def test_the_sign_of_a_zero_is_no_difference() -> None:
    """-0.0 and 0.0 are the same coordinate."""
    mesh = soup(8)
    vertices = mesh.vertices * np.array([1, 1, 0], np.float32)
    flat = type(mesh)(np.abs(vertices), mesh.faces)
    bvh = build(flat)
    assert (
        failed(
            flat, altered(bvh, low=bvh.low * 1, high=np.where(bvh.high == 0, -0.0, bvh.high))
        )
        == set()
    )


@pytest.mark.parametrize("what", ["parent's", "swapped", "before the partition"])
def test_usual_mistakes_are_all_counted(what: str) -> None:
    """Boxes of the parent, exchanged boxes, and boxes of the faces as they were before."""
    low, high = BVH.low.copy(), BVH.high.copy()
    for node in USED:
        parent = (node - 1) // 2
        source = {"parent's": parent, "swapped": node + 1 if node % 2 else node - 1}
        if what in source:
            low[node], high[node] = BVH.low[source[what]], BVH.high[source[what]]
        else:
            low[node], high[node] = box(MESH, np.arange(BVH.begin[node], BVH.end[node]))
    bvh = altered(BVH, low=low, high=high)
    assert boxes_are_tight.decide(tree_case(MESH, bvh)).wrong >= USED.size // 2
    assert "boxes-are-tight" in failed(MESH, bvh)


@pytest.mark.parametrize("node", USED.tolist())
def test_a_face_more_or_less_changes_the_true_box(node: int) -> None:
    """What a node really spans is taken from its own range, also where nothing adds up."""
    begin = int(BVH.begin[node])
    bvh = changed(BVH, "begin", node, max(begin - 1, 0))
    own = bvh.order[bvh.begin[node] : bvh.end[node]]
    low, high = box(MESH, own)
    moved = changed(
        changed(bvh, "low", (node, 0), float(low[0])), "high", (node, 0), float(high[0])
    )
    for axis in (1, 2):
        moved = changed(moved, "low", (node, axis), float(low[axis]))
        moved = changed(moved, "high", (node, axis), float(high[axis]))
    wrong = boxes_are_tight.decide(tree_case(MESH, moved)).examples
    assert not any(example.message.startswith(f"node {node}:") for example in wrong)


def test_nodes_without_faces_have_no_box() -> None:
    """An empty half has nothing that its box could hold; the partition is what fails."""
    mesh = soup(8)
    bvh = changed(changed(build(mesh), "end", 1, 8), "begin", 2, 8)
    bvh = altered(bvh, low=bvh.low[[0, 0, 2]], high=bvh.high[[0, 0, 2]])
    assert "boxes-are-tight" not in failed(mesh, bvh)
    assert "children-partition-their-parent" in failed(mesh, bvh)


def memory_case(stop: Stop, finding: str = "", line: int = 0) -> MemoryCase:
    """Make the end of a sanitized worker."""
    ending = Ending(stop, "detail", 1.0, 1.0, "", finding, line)
    return MemoryCase("cube", ConstructTrial("cube", MESH, sanitized=True), ending)


def test_a_finding_fails_with_its_line() -> None:
    """The words and the line of the sanitizer reach the student."""
    case = memory_case(Stop.CRASHED, "heap-buffer-overflow", 12)
    evidence = construct_memory_is_safe.decide(case)
    assert (evidence.wrong, evidence.line) == (1, 12)
    assert evidence.examples[0].message == "heap-buffer-overflow in line 12"


def test_a_finding_without_a_line_says_no_line() -> None:
    """Without a stack the message ends with the finding."""
    evidence = construct_memory_is_safe.decide(memory_case(Stop.CRASHED, "SEGV"))
    assert evidence.examples[0].message == "SEGV"


@pytest.mark.parametrize("stop", [each for each in Stop if each is not Stop.FINISHED])
def test_an_early_end_without_a_finding_is_not_examined(stop: Stop) -> None:
    """A time-out proves nothing about memory, neither way."""
    evidence = construct_memory_is_safe.decide(memory_case(stop))
    assert (evidence.examined, evidence.wrong) == (0, 0)
    assert evidence.stop is stop


def test_a_finished_worker_is_clean() -> None:
    """No finding and a regular end pass."""
    assert construct_memory_is_safe.decide(memory_case(Stop.FINISHED)) == Evidence(1, 0)
