"""Which rays are timed? A camera's, and rays from all around to anywhere in the box."""

import numpy as np

from grader.model.mesh import Doubles, Mesh, Rays
from grader.tolerances import EPSILON

FIELD = 0.45
"""Half of the picture's side at distance 1."""

TOWARDS = (0.3, 0.4, 1.0)
"""From the middle of the mesh to the camera."""


def camera_rays(mesh: Mesh, side: int) -> Rays:
    """Return side x side rays of a pinhole camera: neighbours take nearly the same way."""
    middle, radius = _ball(mesh)
    origin = middle + np.array(TOWARDS) * 1.8 * radius
    ahead = (middle - origin) / np.linalg.norm(middle - origin)
    across = np.cross(ahead, (0.0, 1.0, 0.0))
    across /= np.linalg.norm(across)
    up = np.cross(across, ahead)
    x, y = np.meshgrid(np.linspace(-FIELD, FIELD, side), np.linspace(FIELD, -FIELD, side))
    direction = ahead + x.reshape(-1, 1) * across + y.reshape(-1, 1) * up
    return _rays(np.broadcast_to(origin, direction.shape), direction)


def scattered_rays(mesh: Mesh, count: int, seed: int = 41) -> Rays:
    """Return rays from a sphere around the mesh to random points of its box."""
    middle, radius = _ball(mesh)
    random = np.random.default_rng(seed)
    away = random.normal(size=(count, 3))
    origin = middle + radius * away / np.linalg.norm(away, axis=1, keepdims=True)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    return _rays(origin, low + random.random((count, 3)) * (high - low) - origin)


def _ball(mesh: Mesh) -> tuple[Doubles, float]:
    """Return the middle of the mesh's box, and half of its diagonal."""
    low, high = (
        mesh.vertices.min(axis=0).astype(np.float64),
        mesh.vertices.max(axis=0).astype(np.float64),
    )
    return (low + high) / 2, float(np.linalg.norm(high - low)) / 2


def _rays(origin: Doubles, direction: Doubles) -> Rays:
    count = len(direction)
    return Rays(
        origin.astype(np.float32),
        direction.astype(np.float32),
        np.full(count, EPSILON, np.float32),
        np.full(count, np.inf, np.float32),
    )
