"""Which rays find mistakes that no picture shows? The families of `hits.special-rays`."""

import numpy as np

from grader.model.mesh import SOLID, Doubles, Rays
from grader.oracle.brute import Candidates
from grader.oracle.bundle import (
    Stage,
    around,
    beams,
    corners_at,
    directions,
    drawn_faces,
    normals_of,
    on_surface,
    unit,
    within,
)
from grader.oracle.ordinary import inbound, to_surface
from grader.tolerances import EPSILON


def on_face(stage: Stage, count: int) -> Rays:
    """From a point on a face, as float32 has it, in any direction."""
    return beams(on_surface(stage, drawn_faces(stage, count)), directions(stage, count))


def t_interval(stage: Stage, count: int) -> Rays:
    """With t_min and t_max before, between and behind the hits of the ray."""
    rays = to_surface(stage, count)
    first, second, last = _hit_distances(stage.look(rays), count)
    between = (first + second) / 2
    everything = np.full(count, np.inf)
    nothing = np.full(count, EPSILON)
    choices = (
        (nothing, first / 2),
        (nothing, between),
        (between, everything),
        (2 * last, everything),
        (between, 2 * last),
        (first / 2, between),
        (between, between),
    )
    which = stage.rng.integers(len(choices), size=count)
    t_min, t_max = (np.choose(which, [choice[end] for choice in choices]) for end in range(2))
    return Rays(rays.origin, rays.direction, t_min.astype(np.float32), t_max.astype(np.float32))


def any_length(stage: Stage, count: int) -> Rays:
    """With directions a thousand times too short or too long, or anything between."""
    rays = inbound(stage, count)
    length = 10.0 ** stage.rng.uniform(-3, 3, (count, 1))
    length[::3], length[1::3] = 1e-3, 1e3
    direction = unit(rays.direction.astype(np.float64)) * length
    return beams(rays.origin.astype(np.float64), direction)


def along_axes(stage: Stage, count: int) -> Rays:
    """Parallel to one or two axes, with zeros of both signs, often in a box's plane."""
    direction = directions(stage, count)
    axis = stage.rng.integers(3, size=count)
    single = stage.rng.random(count) < 0.7
    kept = np.eye(3, dtype=np.bool_)[axis]
    kept[~single] ^= True
    direction[~kept] = 0.0
    direction = unit(direction)
    direction[~kept] *= stage.rng.choice([-1.0, 1.0], np.count_nonzero(~kept))
    through = _mixed(stage, within(stage, count))
    return beams(through - 2 * stage.radius * direction, direction)


def in_slab_planes(stage: Stage, count: int) -> Rays:
    """In a plane of a box and parallel to it, from inside, from the border and from outside."""
    axis = stage.rng.integers(3, size=count)
    row = np.arange(count)
    origin = within(stage, count)
    direction = directions(stage, count)
    direction[row, axis] = stage.rng.choice([-0.0, 0.0], count)
    origin[::2] = _mixed(stage, origin[::2])
    outside = stage.rng.random(count) < 0.5
    origin[outside] -= 2 * stage.radius * direction[outside]
    # The coordinate comes last, so that it is a box's own float32.
    vertex = stage.mesh.vertices[stage.mesh.faces[drawn_faces(stage, count), 0]]
    origin[row, axis] = vertex[row, axis]
    outermost = np.stack([stage.middle - stage.half, stage.middle + stage.half])
    border = stage.rng.random(count) < 0.3
    side = stage.rng.integers(2, size=count)
    origin[border, axis[border]] = outermost[side[border], axis[border]]
    return beams(origin, direction)


def through_vertices(stage: Stage, count: int) -> Rays:
    """From all around to a corner of a face."""
    origin = around(stage, count)
    corners = corners_at(stage, drawn_faces(stage, count))
    return beams(origin, unit(corners[:, 0] - origin))


def through_edges(stage: Stage, count: int) -> Rays:
    """From all around to the middle of an edge."""
    origin = around(stage, count)
    corners = corners_at(stage, drawn_faces(stage, count))
    return beams(origin, unit((corners[:, 1] + corners[:, 2]) / 2 - origin))


def grazing(stage: Stage, count: int) -> Rays:
    """To a point on a face, within 1e-4 to 1e-1 of its plane."""
    face = drawn_faces(stage, count)
    normal = normals_of(stage, face)
    along = unit(np.cross(normal, directions(stage, count)))
    tilt = 10.0 ** stage.rng.uniform(-4, -1, (count, 1))
    direction = unit(along + tilt * normal)
    return beams(on_surface(stage, face) - stage.radius * direction, direction)


def silhouette(stage: Stage, count: int) -> Rays:
    """Past the outermost vertex of a direction, at a right angle to it."""
    outwards = directions(stage, count)
    vertices = stage.mesh.vertices.astype(np.float64)
    if len(vertices) > SOME:
        vertices = stage.rng.choice(vertices, SOME)
    target = vertices[np.argmax(outwards @ vertices.T, axis=1)]
    direction = unit(np.cross(outwards, directions(stage, count)))
    nudge = stage.rng.choice([0.0, 1e-3, -1e-3], (count, 1)) * stage.radius
    return beams(target + nudge * outwards - 2 * stage.radius * direction, direction)


SOME = 4_000
"""Vertices among which the outermost is looked for."""

SPECIAL = {
    "on-surface": on_face,
    "t-interval": t_interval,
    "any-length": any_length,
    "along-axes": along_axes,
    "in-slab-planes": in_slab_planes,
    "through-vertex": through_vertices,
    "through-edge": through_edges,
    "grazing": grazing,
    "silhouette": silhouette,
}
"""Family by name. All but `any-length` need a face."""


def _hit_distances(found: Candidates, rays: int) -> tuple[Doubles, Doubles, Doubles]:
    """Return each ray's first, second and last sure hit; 2 x first for want of a second.

    A ray that meets nothing for sure gets 1, 2 and 1.
    """
    solid = np.flatnonzero(found.kind == SOLID)
    ray, t = found.ray[solid], found.t[solid]
    order = np.lexsort((t, ray))
    ray, t = ray[order], t[order]
    count = np.bincount(ray, minlength=rays)
    start = np.cumsum(count) - count
    padded = np.append(t, (1.0, 1.0))
    first = np.where(count > 0, padded[np.minimum(start, t.size)], 1.0)
    second = np.where(count > 1, padded[np.minimum(start + 1, t.size)], 2 * first)
    second = np.where(second < 1.01 * first, 2 * first, second)
    last = np.where(count > 0, padded[np.maximum(start + count - 1, 0)], 1.0)
    return first, second, last


def _mixed(stage: Stage, points: Doubles) -> Doubles:
    """Replace about half of the coordinates by those of vertices, which boxes share."""
    if len(stage.mesh.faces) == 0:
        return points
    vertex = stage.mesh.vertices[stage.mesh.faces[drawn_faces(stage, len(points)), 0]]
    taken = stage.rng.random(points.shape) < 0.5
    return np.where(taken, vertex.astype(np.float64), points)
