"""Nodes that are divided at the wrong place or along the wrong axis."""

import numpy as np
import pytest

from grader.model.mesh import Bvh, Floats, Integers, Mesh
from grader.model.verdict import Evidence, Verdict
from grader.verify import axis as module
from grader.verify.split import splits_at_the_median, splits_the_longest_axis
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


def always(axis: int) -> Reading:
    """Split along one axis only."""
    return Reading(axis=lambda _: axis)


def stretched(axis: int, faces: int = 32) -> Mesh:
    """Make a soup whose box is by far the longest along one axis."""
    factors = np.ones(3)
    factors[axis] = 50
    return mesh_of(soup(faces).vertices.reshape(-1, 3, 3) * factors)


@pytest.mark.parametrize("longest", [0, 1, 2])
@pytest.mark.parametrize("chosen", [0, 1, 2])
def test_another_axis_is_named_with_the_longest(longest: int, chosen: int) -> None:
    """Only the longest axis passes; the message names the chosen and the right one."""
    mesh = stretched(longest)
    bvh = build(mesh, always(chosen))
    evidence = splits_the_longest_axis.decide(tree_case(mesh, bvh))
    if longest == chosen:
        assert (evidence.wrong, evidence.examined) == (0, 7)
        return
    example = evidence.examples[0]
    names = "xyz"[chosen], "xyz"[longest]
    assert (example.got, example.expected) == names
    assert example.message.startswith("node 0 is divided along ")
    assert failed(mesh, bvh) == {"splits-the-longest-axis"}


def shortest(extent: Floats) -> int:
    """Take the shortest axis."""
    return int(np.argmin(extent))


def test_every_wrong_axis_is_counted() -> None:
    """With the shortest axis everywhere all splits of long nodes are wrong, not just one."""
    evidence = splits_the_longest_axis.decide(
        tree_case(MESH, build(MESH, Reading(axis=shortest)))
    )
    assert evidence.examined == 8
    assert evidence.wrong >= 6
    assert len(evidence.examples) == 3


@pytest.mark.parametrize("corner", ["low", "high"])
def test_a_split_that_follows_from_a_wrong_box_is_no_second_mistake(corner: str) -> None:
    """The axis may be the longest of the true box or of the one that the submission made."""
    mesh = stretched(0, faces=20)
    by_y = build(mesh, always(1))
    assert "splits-the-longest-axis" in failed(mesh, by_y)
    box = getattr(by_y, corner).copy()
    box[:, 1] = -1e9 if corner == "low" else 1e9
    tall = by_y
    for node in np.flatnonzero(by_y.end):
        tall = changed(tall, corner, (int(node), 1), float(box[node, 1]))
    assert failed(mesh, tall) == {"root-holds-all-faces", "boxes-are-tight"}


@pytest.mark.parametrize("ulps", [0, 1, 2, 3, 4])
def test_axes_within_four_ulp_count_as_equal(ulps: int) -> None:
    """A box computed by another order of operations may have another longest axis."""
    assert evidence_of_near_tie(ulps).wrong == 0


@pytest.mark.parametrize("ulps", [6, 100])
def test_axes_beyond_four_ulp_differ(ulps: int) -> None:
    """The tolerance is no wider than rounding needs."""
    assert evidence_of_near_tie(ulps).wrong >= 1


def evidence_of_near_tie(ulps: int) -> Evidence:
    """Divide along y where x is longer by some units in the last place."""
    y = np.linspace(1, 2, 17, dtype=np.float32)
    x = y[np.arange(17) * 7 % 17]
    x[x == 2] += np.float32(ulps * 2.0**-23)
    corners = np.stack([x, y, 0 * y], axis=1)[:, None] * np.ones((1, 3, 1))
    mesh = mesh_of(corners)
    return splits_the_longest_axis.decide(tree_case(mesh, build(mesh, always(1))))


def by_slips(faces: int, slips: int, axis: int = 0) -> Evidence:
    """Exchange faces of the root's halves in the tree of a mesh that is longest along x."""
    mesh = stretched(0, faces)
    right = build(mesh, always(axis))
    order = right.order.copy()
    middle = int(right.end[1])
    one, two = np.arange(slips), middle + np.arange(slips)
    order[one], order[two] = right.order[two], right.order[one]
    return splits_the_longest_axis.decide(tree_case(mesh, altered(right, order=order)))


@pytest.mark.parametrize("slips", [1, 2, 4])
def test_a_slip_in_the_order_is_not_the_axis(slips: int) -> None:
    """The halves of a large node show the axis even if a few faces are on the wrong side."""
    evidence = by_slips(64, slips)
    assert (evidence.wrong, evidence.too_small, evidence.hidden_by) == (0, False, "")
    assert evidence.examined >= 1


@pytest.mark.parametrize("slips", [1, 2, 4])
def test_a_wrong_axis_shows_through_slips(slips: int) -> None:
    """Whoever divides along y and loses a few faces there has both mistakes."""
    evidence = by_slips(64, slips, axis=1)
    assert evidence.wrong >= 1
    assert evidence.examples[0].got == "another axis"


def test_a_reversed_order_shows_the_axis() -> None:
    """The larger centres on the left: the median is wrong, and the axis is not."""
    mesh = stretched(0, 64)
    backwards = Reading(centre=lambda a, b, c: -(a + b + c))
    case = tree_case(mesh, build(mesh, backwards))
    assert splits_at_the_median.decide(case).wrong >= 1
    assert splits_the_longest_axis.decide(case).wrong == 0
    assert splits_the_longest_axis.decide(case).examined >= 1


@pytest.mark.parametrize("seed", range(6))
def test_without_any_order_the_median_hides_the_axis(seed: int) -> None:
    """Faces as the mesh has them show no axis, and earn nothing for one."""
    mesh = soup(64, seed)
    unsorted = Reading(centre=lambda a, *_: np.zeros_like(a))
    found = findings(tree_case(mesh, build(mesh, unsorted)))
    assert found["bvh.splits-at-the-median"].verdict is Verdict.FAIL
    axis = found["bvh.splits-the-longest-axis"]
    assert (axis.verdict, axis.reason) == (Verdict.BLOCKED, "bvh.splits-at-the-median")


@pytest.mark.parametrize("chosen", [1, 2])
def test_few_faces_are_no_proof_of_a_wrong_axis(chosen: int) -> None:
    """Five faces are ordered along some axis by chance: nothing is said of them."""
    mesh = stretched(0, 5)
    case = tree_case(mesh, build(mesh, always(chosen)))
    assert splits_the_longest_axis.decide(case) == Evidence(0, 0, too_small=True)
    assert "bvh.splits-the-longest-axis" not in findings(case)


def test_a_flat_axis_is_a_wrong_one() -> None:
    """Where all centres agree on an axis, it explains every order, and is not the longest."""
    vertices = stretched(0, 64).vertices.copy()
    vertices[:, 2] = 0
    mesh = mesh_of(vertices)
    assert failed(mesh, build(mesh, always(2))) == {"splits-the-longest-axis"}


@pytest.mark.parametrize("shift", [-1, 1])
def test_halves_of_another_size_are_wrong(shift: int) -> None:
    """A middle that is one face beside the median leaves halves that differ by two."""
    mesh = soup(12)
    evidence = splits_at_the_median.decide(tree_case(mesh, build(mesh, Reading(shift=shift))))
    assert evidence.wrong >= 1
    assert evidence.examples[0].got in ("5 and 7 faces", "7 and 5 faces")
    assert "splits-at-the-median" in failed(mesh, build(mesh, Reading(shift=shift)))


@pytest.mark.parametrize(("odd_left", "shift"), [(False, 1), (True, 0)])
def test_an_odd_face_may_be_on_either_side(odd_left: bool, shift: int) -> None:
    """Of nine faces the left half gets four or five."""
    mesh = soup(5)
    assert failed(mesh, build(mesh, Reading(odd_left=odd_left, shift=shift))) == set()


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_face_on_the_wrong_side_is_seen_on_every_axis(axis: int) -> None:
    """Exchanging the first face with the last mixes the halves of the root."""
    mesh = stretched(axis, faces=37)
    right = build(mesh)
    order = right.order.copy()
    order[[0, -1]] = order[[-1, 0]]
    bvh = changed(changed(right, "order", 0, order[0]), "order", 36, order[36])
    evidence = splits_at_the_median.decide(tree_case(mesh, bvh))
    assert evidence.wrong >= 1
    (first, *_) = evidence.examples
    assert first.message.startswith(f"node 0: the left half reaches to centre {'xyz'[axis]} = ")


@pytest.mark.parametrize("seed", range(8))
def test_unsorted_halves_are_wrong(seed: int) -> None:
    """Without `nth_element` the faces stay as the mesh has them."""
    mesh = soup(64, seed)
    unsorted = Reading(centre=lambda a, *_: np.zeros_like(a))
    evidence = splits_at_the_median.decide(tree_case(mesh, build(mesh, unsorted)))
    assert evidence.wrong >= 8


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", ["first vertex", "box", "two vertices"])
def test_other_centres_are_wrong(seed: int, name: str) -> None:
    """The first vertex, the middle of the box and two thirds of the vertices are no centre."""
    centres = {
        "first vertex": lambda a, _b, _c: a,
        "box": lambda a, b, c: (
            np.minimum(np.minimum(a, b), c) + np.maximum(np.maximum(a, b), c)
        ),
        "two vertices": lambda a, b, _: a + b,
    }
    mesh = soup(200, seed)
    bvh = build(mesh, Reading(centre=centres[name]))
    assert "splits-at-the-median" in failed(mesh, bvh)


@pytest.mark.parametrize(("gap", "wrong"), [(1, 0), (3, 0), (4, 0), (8, 1), (50, 1)])
def test_centres_may_be_mixed_by_four_ulp_of_the_coordinates(gap: int, wrong: int) -> None:
    """Eight points a few units in the last place apart, with the two middle ones exchanged."""
    x = 1024 + np.array([-900, -800, -700, 0, 0, 700, 800, 900], np.float32)
    x[4] += gap * np.float32(2.0**-13)
    # Neither y nor z explains a split between the middle points.
    y = np.tile(np.array([0, 1], np.float32), 4)
    mesh = mesh_of(np.stack([x, y, y], axis=1)[:, None] * np.ones((1, 3, 1)))
    right = build(mesh)
    order = right.order.copy()
    order[[3, 4]] = order[[4, 3]]
    bvh = changed(changed(right, "order", 3, order[3]), "order", 4, order[4])
    evidence = splits_at_the_median.decide(tree_case(mesh, bvh))
    assert evidence.wrong == wrong


def test_only_nodes_that_their_children_partition_are_judged() -> None:
    """A lost face is the partition's mistake, not the split's."""
    bvh = changed(BVH, "end", 2, 36)
    assert splits_at_the_median.decide(tree_case(MESH, bvh)).examined == 10


@pytest.mark.parametrize("shared", [True, False])
def test_nodes_that_share_faces_are_judged_for_so_long_only(
    shared: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """85 nodes of all faces take no longer than a right tree's levels, which are all seen."""
    mesh = soup(256)
    # Along no axis are its halves in order.
    wrong = build(mesh, Reading(centre=lambda a, *_: np.zeros_like(a)))
    bvh = each_second_level_whole(mesh, wrong) if shared else wrong
    seen: list[int] = []

    def counted(mesh: Mesh, bvh: Bvh, node: Integers) -> Integers:
        seen.extend(int(bvh.end[one] - bvh.begin[one]) for one in node)
        return judged(mesh, bvh, node)

    judged = module._off
    monkeypatch.setattr(module, "_off", counted)
    splits_the_longest_axis.decide(tree_case(mesh, bvh))
    levels = [256, *2 * [128], *4 * [64], *8 * [32]]
    assert seen == ([256] * module.MOST_SHARE if shared else levels)


def each_second_level_whole(mesh: Mesh, bvh: Bvh) -> Bvh:
    """Give the nodes of each second level all faces, and their children one half each."""
    count, half = len(mesh.faces), len(mesh.faces) // 2
    begin, end = np.zeros((2, 255), np.uint32)
    for node in range(255):
        whole = (node + 1).bit_length() % 2
        begin[node] = 0 if whole or node % 2 else half
        end[node] = half if not whole and node % 2 else count
    low, high = (np.resize(one[0], (255, 3)) for one in (bvh.low, bvh.high))
    return altered(bvh, low=low, high=high, begin=begin, end=end, node_count=255)
