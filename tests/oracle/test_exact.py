"""Lattices: rays in the planes of boxes whose hits are exact in float32."""

import numpy as np
import pytest

from grader.model.cases import HitCase
from grader.model.mesh import Bvh, Floats, Hits, Integers, Mask, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import chosen
from grader.oracle.costs import given_box_test
from grader.oracle.embree import contradicted, embree_t
from grader.oracle.exact import ABOVE, CELLS, exact_trial, lattice
from grader.oracle.hierarchy import Touches, leaves_of, spread, traverse
from grader.verify.closest import judge
from grader.verify.hits import record_is_complete, special_rays
from tests.oracle.tracer import plane_test, trace
from tests.oracle.treebuilder import tree_of


def trial(up: int) -> TraceTrial:
    """Make the trial of one axis."""
    mesh = lattice(3, up)
    return exact_trial(3, up, mesh, tree_of(mesh))


def traversed(given: TraceTrial, test: Touches) -> Floats:
    """Return (R,) t of the closest hits that a traversal with a box test finds."""
    tree, rays = given.tree, given.rays
    t = np.full(len(rays.t_min), np.inf, np.float32)
    begin, end = tree.begin.astype(np.int64), tree.end.astype(np.int64)
    for block in traverse(leaves_of(tree), t.size, test):
        ray, place = spread(block.ray, begin[block.leaf], end[block.leaf])
        corners = given.mesh.vertices[given.mesh.faces[tree.order[place]]]
        np.minimum.at(t, ray, plane_test(chosen(rays, ray), corners)[1])
    return t


def nan_box_test(tree: Bvh, rays: Rays) -> Touches:
    """Return the box test as it is often written: a NaN of any side loses the box."""
    with np.errstate(divide="ignore"):
        inverse = np.float32(1) / rays.direction

    def touches(ray: Integers, node: Integers) -> Mask:
        with np.errstate(invalid="ignore"):
            one = (tree.low[node] - rays.origin[ray]) * inverse[ray]
            two = (tree.high[node] - rays.origin[ray]) * inverse[ray]
            near, far = np.minimum(one, two).max(axis=1), np.maximum(one, two).min(axis=1)
        hit: Mask = near <= far
        return hit

    return touches


@pytest.mark.parametrize("up", [0, 1, 2])
def test_every_ray_hits_two_faces_exactly(up: int) -> None:
    """Every line is hit, at a whole height, with both neighbours at the same t."""
    given = trial(up)
    assert len(given.rays.t_min) == 2 * CELLS * (CELLS - 1)
    assert (np.diff(given.answers.first) == 2).all()
    t = given.answers.t.reshape(-1, 2)
    assert (t[:, 0] == t[:, 1]).all()
    assert (t == np.rint(t)).all()
    assert (t <= ABOVE).all()
    assert len(np.unique(t)) > 1


@pytest.mark.parametrize("up", [0, 1, 2])
def test_unit_normals_are_exact_too(up: int) -> None:
    """Each face lies across one axis: dividing by the normal's length rounds nothing."""
    corners = trial(up).mesh.vertices[trial(up).mesh.faces]
    assert (np.ptp(corners[:, :, up], axis=1) == 0).all()


def test_a_triangle_test_without_borders_is_not_judged_here() -> None:
    """It hits none of the faces, and the rule of closest hits allows that on a border."""
    given = trial(2)
    count = len(given.rays.t_min)
    zero = np.zeros((count, 3), np.float32)
    missed = Hits(zero, np.full(count, np.inf, np.float32), zero)
    for each in (special_rays, record_is_complete):
        evidence = each.decide(HitCase("lattice", given, missed))
        assert (evidence.examined, evidence.wrong, evidence.too_small) == (0, 0, True)
    one = missed.t.copy()
    one[7] = given.answers.t[14]
    partly = special_rays.decide(HitCase("lattice", given, Hits(zero, one, zero)))
    assert (partly.examined, partly.wrong) == (count, count - 1)


@pytest.mark.parametrize("up", [0, 2])
def test_right_solutions_hit_every_line(up: int) -> None:
    """The given tests, with and without a tree, and Embree find every hit, to the last bit."""
    given = trial(up)
    exact = given.answers.t[::2].astype(np.float32)
    assert (trace(given.mesh, given.rays, given.tree).t == exact).all()
    assert (traversed(given, given_box_test(given.tree, given.rays)) == exact).all()
    theirs = embree_t(given.mesh, given.rays)
    assert not contradicted(given.rays, given.answers, theirs).any()


@pytest.mark.parametrize("up", [0, 2])
def test_a_box_test_that_makes_nan_loses_hits(up: int) -> None:
    """0 * infinity in the box test costs hits that the rule insists on."""
    given = trial(up)
    t = traversed(given, nan_box_test(given.tree, given.rays))
    assert judge(given.answers, t).missed_closer.mean() > 0.2
