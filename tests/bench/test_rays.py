"""The rays that are timed go where they are said to go."""

import numpy as np

from grader.bench.rays import camera_rays, scattered_rays
from grader.oracle.generated import landscape

MESH = landscape(200, 1)


def test_the_camera_sees_the_mesh() -> None:
    """All rays leave one point, and the middle one goes through the middle of the box."""
    rays = camera_rays(MESH, 5)
    assert len(rays.t_min) == 25
    assert (rays.origin == rays.origin[0]).all()
    low, high = MESH.vertices.min(axis=0), MESH.vertices.max(axis=0)
    towards = (low + high) / 2 - rays.origin[12]
    across = np.cross(towards, rays.direction[12])
    assert np.linalg.norm(across) < 1e-5 * np.linalg.norm(towards)


def test_scattered_rays_end_in_the_box() -> None:
    """They start around it, and the same ones come back for the same seed."""
    rays = scattered_rays(MESH, 100, seed=3)
    target = rays.origin + rays.direction
    low, high = MESH.vertices.min(axis=0), MESH.vertices.max(axis=0)
    assert ((low - 1e-5 <= target) & (target <= high + 1e-5)).all()
    assert (scattered_rays(MESH, 100, seed=3).direction == rays.direction).all()
    assert not (scattered_rays(MESH, 100, seed=4).direction == rays.direction).all()
