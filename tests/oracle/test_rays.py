"""Every family of rays does what its name says."""

import numpy as np
import pytest

from grader.model.mesh import Mask, Rays
from grader.oracle.brute import answers, classified, nearest
from grader.oracle.culling import all_pairs
from grader.oracle.ordinary import ORDINARY
from grader.oracle.rays import Request, rays_on
from grader.oracle.special import SPECIAL
from grader.tolerances import EPSILON
from grader.verify.closest import is_ambiguous, judge
from tests.oracle.tracer import trace
from tests.oracle.treebuilder import planted


def family(name: str, mesh_name: str = "terrain-600") -> tuple[Rays, Mask, Mask]:
    """Return the rays of one family, which of them surely hit, and which are ambiguous."""
    mesh, tree = planted(mesh_name)
    special = name in SPECIAL
    drawn = rays_on(Request(9, mesh_name, special, count=200), mesh, tree)
    picked = drawn.index == drawn.names.index(name)
    found = answers(mesh, drawn.rays, tree)
    rays = Rays(
        drawn.rays.origin[picked],
        drawn.rays.direction[picked],
        drawn.rays.t_min[picked],
        drawn.rays.t_max[picked],
    )
    return rays, np.isfinite(found.limit)[picked], is_ambiguous(found)[picked]


@pytest.mark.parametrize("name", [*ORDINARY, *SPECIAL])
def test_rays_are_sound(name: str) -> None:
    """Finite float32 origins and directions of some length, intervals that are numbers."""
    rays, _, _ = family(name)
    assert rays.origin.dtype == rays.direction.dtype == rays.t_min.dtype == np.float32
    assert np.isfinite(rays.origin).all()
    assert np.isfinite(rays.direction).all()
    assert rays.direction.any(axis=1).all()
    assert np.isfinite(rays.t_min).all()
    assert not np.isnan(rays.t_max).any()


@pytest.mark.parametrize("name", ORDINARY)
def test_ordinary_rays_are_clear_and_unlimited(name: str) -> None:
    """Hardly any has two answers; all start at epsilon and never end."""
    rays, _, ambiguous = family(name)
    assert ambiguous.mean() < 0.05
    assert (rays.t_min == np.float32(EPSILON)).all()
    assert (rays.t_max == np.inf).all()


def test_hits_and_misses_both_occur() -> None:
    """Rays to a surface hit it, rays beside the mesh hit nothing, cameras see both."""
    assert family("to-surface")[1].mean() > 0.95
    assert not family("beside")[1].any()
    assert 0.1 < family("camera")[1].mean() < 0.9


def test_intervals_cut_hits_off() -> None:
    """Some rays end before their first hit, some start between two, some behind all."""
    rays, hit, ambiguous = family("t-interval", "nested-spheres")
    assert ambiguous.mean() < 0.1
    assert 0.3 < hit.mean() < 0.8
    assert np.isfinite(rays.t_max).any()
    assert (rays.t_max == np.inf).any()
    assert (rays.t_min > 10 * EPSILON).any()


def test_rays_between_points_end_at_one() -> None:
    """As shadow rays do; many have something in their way."""
    rays, hit, _ = family("between-points", "nested-spheres")
    assert (rays.t_max == 1).all()
    assert hit.mean() > 0.3


def test_limited_rays_come_in_a_row_with_different_limits() -> None:
    """Three times the same ray, never with the same interval, of lengths of twelve orders."""
    rays, _, _ = family("t-interval", "nested-spheres")
    same = (rays.origin[1:] == rays.origin[:-1]).all(axis=1)
    same &= (rays.direction[1:] == rays.direction[:-1]).all(axis=1)
    assert 0.6 < same.mean() < 0.7
    other = (rays.t_min[1:] != rays.t_min[:-1]) | (rays.t_max[1:] != rays.t_max[:-1])
    assert other[same].all()
    length = np.linalg.norm(rays.direction.astype(np.float64), axis=1)
    assert length.min() < 1e-4
    assert length.max() > 1e4
    assert (rays.t_min == 0).any()


def test_lengths_of_directions_are_as_different_as_float32_bears() -> None:
    """Many are 1e-3 or 1e3 long, some 1e-10 or 1e8, where limits of t are as different."""
    rays, hit, ambiguous = family("any-length")
    length = np.linalg.norm(rays.direction.astype(np.float64), axis=1)
    for expected in (1e-10, 1e-3, 1e3, 1e8):
        assert np.isclose(length, expected, rtol=1e-5).mean() > 0.15
    assert hit[length > 1e7].any()
    assert hit[length < 1e-9].any()
    assert ambiguous.mean() < 0.05


@pytest.mark.parametrize("name", ["any-length", "t-interval"])
@pytest.mark.parametrize("mesh", ["scaled-small", "scaled-large", "terrain-600"])
def test_no_float32_test_is_wrong_because_of_a_length(mesh: str, name: str) -> None:
    """Neither underflow nor overflow leads the given test astray, nor the search for pairs."""
    planted_mesh, tree = planted(mesh)
    rays, _, _ = family(name, mesh)
    found = answers(planted_mesh, rays, tree)
    judgement = judge(found, trace(planted_mesh, rays, tree).t)
    assert not (judgement.missed_closer | judgement.no_surface).any()
    pairs = all_pairs(len(planted_mesh.faces), len(rays.t_min))
    everything = nearest(classified(planted_mesh, rays, pairs), len(rays.t_min))
    assert (everything.limit == found.limit).all()
    assert everything.face.tolist() == found.face.tolist()


def test_some_axes_are_followed_from_far_away() -> None:
    """From a thousand radii an epsilon in place of a zero leads astray."""
    mesh, _ = planted("terrain-600")
    rays, hit, _ = family("along-axes")
    middle = mesh.vertices.mean(axis=0)
    far = np.linalg.norm(rays.origin - middle, axis=1) > 100 * np.abs(mesh.vertices).max()
    assert far.mean() > 0.1
    assert hit[far].any()


@pytest.mark.parametrize("name", ["along-axes", "in-slab-planes"])
def test_zeros_of_both_signs_occur(name: str) -> None:
    """0.0 and -0.0 both occur in directions, and 0 * infinity does in slab tests."""
    direction = family(name)[0].direction
    zero = direction == 0
    assert zero.any(axis=1).all()
    assert (zero & np.signbit(direction)).any()
    assert (zero & ~np.signbit(direction)).any()


def test_slab_planes_are_met_exactly() -> None:
    """Many rays start on a coordinate of a vertex and have no motion along that axis."""
    mesh, _ = planted("terrain-600")
    rays, _, _ = family("in-slab-planes")
    on_plane = [
        np.isin(rays.origin[:, axis], mesh.vertices[:, axis]) & (rays.direction[:, axis] == 0)
        for axis in range(3)
    ]
    assert np.any(on_plane, axis=0).mean() > 0.9


@pytest.mark.parametrize("name", ["through-vertex", "through-edge"])
def test_borders_are_met_within_rounding(name: str) -> None:
    """Without a surface in front, the rule leaves both answers open."""
    assert family(name, "cloud-1")[2].mean() > 0.95


def test_close_to_an_edge_a_hit_is_still_sure() -> None:
    """No right test misses these on a large face; one that wants weights of 1e-5 does."""
    mesh, _ = planted("cloud-1")
    rays, hits, _ = family("just-inside", "cloud-1")
    corners = mesh.vertices[mesh.faces[0]].astype(np.float64)
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    t = (corners[0] - rays.origin) @ normal / (rays.direction @ normal)
    points = rays.origin + t[:, None] * rays.direction
    least = np.linalg.solve(corners.T, points.T).min(axis=0)
    assert (hits & (least > 0) & (least < 1e-5)).mean() > 0.5


def test_another_seed_draws_other_rays() -> None:
    """The same seed draws the same rays bit by bit."""
    mesh, tree = planted("cloud-5")
    one, same, other = (
        rays_on(Request(seed, "cloud-5", True, count=20), mesh, tree).rays for seed in (1, 1, 2)
    )
    assert one.direction.tobytes() == same.direction.tobytes()
    assert one.direction.tobytes() != other.direction.tobytes()
