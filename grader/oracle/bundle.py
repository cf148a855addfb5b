"""What all families of rays are drawn from: a mesh's size, points on it, and directions."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Doubles, Integers, Mesh, Rays
from grader.oracle.brute import Candidates
from grader.tolerances import EPSILON

Floatish = Doubles | float


@dataclass(frozen=True, slots=True, eq=False)
class Stage:
    """A mesh, how big it is, and the random numbers of one family of rays."""

    mesh: Mesh
    rng: np.random.Generator
    middle: Doubles
    """(3,) float64, middle of the mesh's box."""

    half: Doubles
    """(3,) float64, half the box's extents."""

    radius: float
    """Of the sphere around the box; 1 without faces."""

    look: Callable[[Rays], Candidates]
    """Finds everything on rays, also behind the closest hit."""


def stage_for(
    mesh: Mesh, rng: np.random.Generator, look: Callable[[Rays], Candidates]
) -> Stage:
    """Measure a mesh."""
    corners = mesh.vertices if len(mesh.vertices) else np.zeros((1, 3), np.float32)
    low, high = corners.min(axis=0).astype(np.float64), corners.max(axis=0).astype(np.float64)
    half = (high - low) / 2
    return Stage(mesh, rng, (low + high) / 2, half, float(np.linalg.norm(half)) or 1.0, look)


def beams(
    origin: Doubles,
    direction: Doubles,
    t_min: Floatish = EPSILON,
    t_max: Floatish = np.inf,
) -> Rays:
    """Make rays of float32; directions of length 0 become (1, 0, 0).

    Args:
        origin: (R, 3) float64.
        direction: (R, 3) float64; those of length 0 are overwritten.
        t_min: A number for all rays, or (R,) float64, as is `t_max`.
        t_max: Where rays end.
    """
    count = len(origin)
    still = ~direction.any(axis=1)
    direction[still] = (1.0, 0.0, 0.0)
    return Rays(
        origin=origin.astype(np.float32),
        direction=direction.astype(np.float32),
        t_min=np.broadcast_to(t_min, count).astype(np.float32),
        t_max=np.broadcast_to(t_max, count).astype(np.float32),
    )


def unit(vectors: Doubles) -> Doubles:
    """Scale (K, 3) float64 vectors to length 1; leaves zeros alone."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    scaled: Doubles = vectors / np.where(length > 0, length, 1.0)
    return scaled


def directions(stage: Stage, count: int) -> Doubles:
    """Draw unit vectors, (count, 3) float64, all directions alike."""
    return unit(stage.rng.standard_normal((count, 3)))


def around(stage: Stage, count: int, distance: float = 1.6) -> Doubles:
    """Draw points, (count, 3) float64, on a sphere `distance` radii from the mesh's middle."""
    return stage.middle + distance * stage.radius * directions(stage, count)


def within(stage: Stage, count: int) -> Doubles:
    """Draw points, (count, 3) float64, in the mesh's box."""
    return stage.middle + stage.half * stage.rng.uniform(-1, 1, (count, 3))


def drawn_faces(stage: Stage, count: int) -> Integers:
    """Draw (count,) int64 faces that have an area; of all faces if none has."""
    corners = stage.mesh.vertices[stage.mesh.faces].astype(np.float64)
    size = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sound = np.flatnonzero(size.any(axis=1))
    if sound.size == 0:
        sound = np.arange(len(stage.mesh.faces))
    return stage.rng.choice(sound, count)


def corners_at(stage: Stage, face: Integers) -> Doubles:
    """Return (K, 3, 3) float64 corners of (K,) int64 faces."""
    return stage.mesh.vertices[stage.mesh.faces[face]].astype(np.float64)


def on_surface(stage: Stage, face: Integers) -> Doubles:
    """Draw a point on each of (K,) int64 faces: (K, 3) float64."""
    weights = stage.rng.dirichlet((1.0, 1.0, 1.0), face.size)
    points: Doubles = np.einsum("kc,kcx->kx", weights, corners_at(stage, face))
    return points


def normals_of(stage: Stage, face: Integers) -> Doubles:
    """Return (K, 3) float64 unit normals of (K,) int64 faces; zeros without an area."""
    corners = corners_at(stage, face)
    return unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
