"""Embree as the second witness: it agrees with the rule, and notices where that is wrong."""

from dataclasses import replace

import numpy as np
import pytest

from grader.model.mesh import Answers, Mesh, Rays
from grader.oracle.brute import answers
from grader.oracle.embree import contradicted, embree_t, witnessed
from grader.oracle.meshes import TRACED
from grader.oracle.rays import Request, rays_on
from tests.oracle.treebuilder import planted, tree_of


def given(name: str, special: bool, seed: int = 1) -> tuple[Mesh, Rays, Answers]:
    """Return a mesh, rays on it and what the rule says of them."""
    mesh, tree = planted(name, seed)
    rays = rays_on(Request(seed, name, special, count=60), mesh, tree).rays
    return mesh, rays, answers(mesh, rays, tree)


@pytest.mark.parametrize("special", [False, True])
@pytest.mark.parametrize("name", TRACED)
def test_embree_agrees_with_the_rule(name: str, special: bool) -> None:
    """Where the rule leaves no choice, Embree says the same."""
    mesh, rays, found = given(name, special)
    t = embree_t(mesh, rays)
    assert np.flatnonzero(contradicted(rays, found, t)).tolist() == []
    assert witnessed(rays, found, t).mean() > 0.2


def test_a_rule_that_forgets_a_face_is_contradicted() -> None:
    """Answers of a mesh that lacks every second face do not stand before Embree."""
    mesh, rays, _ = given("terrain-600", False)
    half = Mesh(mesh.vertices, mesh.faces[::2].copy())
    forgetful = answers(half, rays, tree_of(half))
    wrong = contradicted(rays, forgetful, embree_t(mesh, rays))
    assert 0.1 < wrong.mean() < 0.9


def test_embree_is_no_witness_where_t_min_matters() -> None:
    """It starts at t = 0, so rays with another t_min are none of its business."""
    mesh, rays, found = given("terrain-600", False)
    late = replace(rays, t_min=np.full_like(rays.t_min, 0.5))
    t = embree_t(mesh, late)
    assert not witnessed(late, found, t).any()
    assert not contradicted(late, found, t).any()


def test_embree_ends_a_ray_at_its_t_max() -> None:
    """A hit behind t_max is no hit."""
    mesh, rays, _ = given("ball-1280", False)
    t = embree_t(mesh, rays)
    short = replace(rays, t_max=np.where(np.isfinite(t), t * np.float32(0.99), t))
    hit_before = np.isfinite(t) & (embree_t(mesh, short) >= t)
    assert not (hit_before & np.isfinite(embree_t(mesh, short))).any()


def test_no_faces_are_never_hit() -> None:
    """Embree is not asked about an empty mesh."""
    mesh, rays, found = given("cloud-0", False)
    t = embree_t(mesh, rays)
    assert (t == np.inf).all()
    assert not contradicted(rays, found, t).any()
