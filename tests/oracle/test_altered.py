"""Altered trees: what is lost is lost to every right traversal, and nothing else is."""

from collections.abc import Iterator

import numpy as np
import pytest

from grader.model.mesh import Bvh, Hits, Mask, Rays
from grader.model.trials import AlteredTrial
from grader.oracle.altered import SHRUNK, altered_trials
from grader.oracle.brute import chosen
from grader.oracle.costs import given_box_test, plain_costs
from grader.oracle.hierarchy import leaves_of, spread, traverse
from grader.verify.closest import judge
from tests.oracle.tracer import plane_test
from tests.oracle.treebuilder import planted


def trials(seed: int = 3) -> Iterator[AlteredTrial]:
    """Spoil two trees in both ways, and a small one in one."""
    for name in ("terrain-1200", "dragon-res4", "cloud-37"):
        mesh, tree = planted(name)
        yield from altered_trials(seed, name, mesh, tree)


def levels(count: int) -> np.ndarray:
    """Return the level of each of `count` nodes."""
    return np.array([(node + 1).bit_length() - 1 for node in range(count)])


def traversed(trial: AlteredTrial, tested: Mask) -> Hits:
    """Trace through the altered tree, testing only the boxes of some nodes."""
    tree, rays = trial.tree, trial.rays
    test = given_box_test(tree, rays)
    t = np.full(len(rays.t_min), np.inf, np.float32)
    visits = traverse(
        leaves_of(tree), t.size, lambda ray, node: ~tested[node] | test(ray, node)
    )
    begin, end = tree.begin.astype(np.int64), tree.end.astype(np.int64)
    for block in visits:
        ray, place = spread(block.ray, begin[block.leaf], end[block.leaf])
        corners = trial.mesh.vertices[trial.mesh.faces[tree.order[place]]]
        np.minimum.at(t, ray, plane_test(chosen(rays, ray), corners)[1])
    nothing = np.zeros((t.size, 3), np.float32)
    return Hits(nothing, t, nothing)


@pytest.mark.parametrize("skipped", ["none", "root", "leaves", "even", "odd"])
def test_every_right_traversal_loses_what_is_lost_and_no_more(skipped: str) -> None:
    """A traversal may leave out the root's box, the leaves' or those of every other level."""
    mesh, tree = planted("terrain-1200")
    for trial in altered_trials(4, "terrain-1200", mesh, tree):
        level = levels(tree.end.size)
        tested = {
            "none": level >= 0,
            "root": level > 0,
            "leaves": ~leaves_of(tree),
            "even": level % 2 == 1,
            "odd": level % 2 == 0,
        }[skipped]
        judgement = judge(trial.answers, traversed(trial, tested).t)
        found = (judgement.accepted >= 0) & ~judgement.missed_closer
        assert (found == ~trial.lost).all()


def test_special_rays_are_of_three_kinds() -> None:
    """From within the box, along an axis, and with limits around what they aim at."""
    mesh, tree = planted("terrain-1200")
    *_, trial = altered_trials(4, "terrain-1200", mesh, tree)
    rays = trial.rays
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    within = ((rays.origin >= low) & (rays.origin <= high)).all(axis=1)
    along = np.count_nonzero(rays.direction, axis=1) == 1
    limited = rays.t_max == 1
    assert (within.astype(int) + along + limited == 1).all()
    for kind in (within, along, limited):
        assert np.count_nonzero(kind & trial.lost) > 20
        assert np.count_nonzero(kind & ~trial.lost) > 20


def test_there_is_enough_to_lose_and_to_keep() -> None:
    """Some ten rays and more on either side, on every altered tree."""
    for trial in trials():
        assert np.count_nonzero(trial.lost) > 50
        assert np.count_nonzero(~trial.lost) > 50


def test_the_altered_tree_keeps_its_shape() -> None:
    """No end becomes 0, no leaf empty, no box is turned inside out, and leaves stay leaves."""
    for trial in trials():
        name = trial.name.partition(" ")[0]
        tree, original = trial.tree, planted(name)[1]
        used = original.end > 0
        assert ((tree.end > 0) == used).all()
        assert (tree.begin[used] < tree.end[used]).all()
        assert (tree.low[used] <= tree.high[used]).all()
        assert (leaves_of(tree) == leaves_of(original)).all()
        assert (tree.low[0] == original.low[0]).all()
        assert (tree.high[0] == original.high[0]).all()


def test_replaced_leaves_hold_the_faces_of_leaves_that_are_left() -> None:
    """Some faces are in no leaf, and of the others none is in a wrong box only."""
    mesh, tree = planted("terrain-1200")
    spoiled, *_ = altered_trials(4, "terrain-1200", mesh, tree)
    leaves = np.flatnonzero(leaves_of(tree) & (tree.end > 0))
    own = spoiled.tree.begin[leaves] == tree.begin[leaves]
    assert 0.2 < np.mean(~own) < 0.3
    assert (spoiled.tree.end[leaves[own]] == tree.end[leaves[own]]).all()
    assert set(spoiled.tree.begin[leaves]) == set(tree.begin[leaves[own]])
    inner = np.flatnonzero(~leaves_of(tree))
    assert (spoiled.tree.begin[inner] == tree.begin[inner]).all()
    assert (spoiled.tree.end[inner] == tree.end[inner]).all()


@pytest.mark.parametrize("name", ["terrain-1200", "dragon-res4"])
def test_half_of_the_shrunk_boxes_hold_all_below(name: str) -> None:
    """Nothing sticks out of them by which somebody could tell that a tree was altered."""
    mesh, tree = planted(name)
    _, trial, _ = altered_trials(4, name, mesh, tree)
    low, high, used = trial.tree.low, trial.tree.high, tree.end > tree.begin
    changed = np.flatnonzero((high != tree.high).any(axis=1))
    tops = [int(node) for node in changed if (node - 1) // 2 not in changed]
    assert len(tops) == SHRUNK

    def holds_all(node: int) -> bool:
        rows = below(node, used)
        inside = (low[rows] >= low[node]).all() and (high[rows] <= high[node]).all()
        return bool(inside)

    assert sorted(map(holds_all, tops)) == [False] * (SHRUNK // 2) + [True] * (SHRUNK // 2)


def below(node: int, used: Mask) -> list[int]:
    """List the used nodes below one."""
    rows = [node]
    for one in rows:
        rows += [k for k in (2 * one + 1, 2 * one + 2) if k < used.size and used[k]]
    return rows[1:]


def test_a_plain_traversal_is_counted_by_hand() -> None:
    """A root with two leaves of two faces: three box tests, and two or four triangle tests."""
    low = np.array([[0, 0, 0], [0, 0, 0], [2, 0, 0]], np.float32)
    high = np.array([[3, 1, 1], [1, 1, 1], [3, 1, 1]], np.float32)
    tree = Bvh(
        low,
        high,
        np.array([0, 0, 2], np.uint32),
        np.array([4, 2, 4], np.uint32),
        np.arange(4, dtype=np.uint32),
        3,
    )

    def costs(origin: tuple[float, ...], direction: tuple[float, ...]) -> tuple[float, float]:
        return plain_costs(
            tree,
            Rays(
                np.array([origin], np.float32),
                np.array([direction], np.float32),
                np.array([1e-5], np.float32),
                np.array([np.inf], np.float32),
            ),
        )

    assert costs((-1, 0.5, 0.5), (1, 0, 0)) == (3, 4)
    assert costs((0.5, 0.5, 5), (0, 0, -1)) == (3, 2)
    assert costs((1.5, 0.5, 5), (0, 0, -1)) == (3, 0)
    assert costs((0.5, 5, 5), (0, 0, -1)) == (1, 0)
    # In the plane of a slab: 0 * infinity excludes nothing.
    assert costs((0.0, 0.5, 5), (0.0, 0, -1)) == (3, 2)
    assert costs((0.0, 0.5, 5), (-0.0, 0, -1)) == (3, 2)
