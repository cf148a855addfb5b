"""Every family of rays does what its name says."""

import numpy as np
import pytest

from grader.model.mesh import Mask, Rays
from grader.oracle.brute import answers
from grader.oracle.ordinary import ORDINARY
from grader.oracle.rays import Request, rays_on
from grader.oracle.special import SPECIAL
from grader.tolerances import EPSILON
from grader.verify.closest import is_ambiguous
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


def test_lengths_of_directions_range_over_a_million() -> None:
    """The shortest direction is 1e-3 long, the longest 1e3."""
    length = np.linalg.norm(family("any-length")[0].direction, axis=1)
    assert length.min() < 2e-3
    assert length.max() > 5e2


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


def test_another_seed_draws_other_rays() -> None:
    """The same seed draws the same rays bit by bit."""
    mesh, tree = planted("cloud-5")
    one, same, other = (
        rays_on(Request(seed, "cloud-5", True, count=20), mesh, tree).rays for seed in (1, 1, 2)
    )
    assert one.direction.tobytes() == same.direction.tobytes()
    assert one.direction.tobytes() != other.direction.tobytes()
