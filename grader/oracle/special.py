"""Which rays find mistakes that no picture shows? The families of `hits.special-rays`."""

import numpy as np

from grader.model.mesh import SOLID, Doubles, Integers, Rays
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


def between_points(stage: Stage, count: int) -> Rays:
    """From a point around the mesh to one in its box, where t is 1: as a shadow ray goes."""
    start = around(stage, count)
    return beams(start, within(stage, count) - start, t_max=1.0)


def t_interval(stage: Stage, count: int) -> Rays:
    """With t_min and t_max before, between and behind the hits of the ray.

    A ray comes several times in a row, each time with another interval. Directions have
    any length, and what comes first begins at 0 as often as a little later.
    """
    rays, scale = _scaled(stage, count)
    first, second, last = _hit_distances(stage.look(rays), count)
    between = (first + second) / 2
    everything = np.full(count, np.inf)
    nothing = stage.rng.choice([0.0, EPSILON], count) / scale
    choices = (
        (nothing, first / 2),
        (nothing, between),
        (between, everything),
        (2 * last, everything),
        (between, 2 * last),
        (first / 2, between),
        (between, between),
    )
    which = _in_turn(stage, count, len(choices))
    t_min, t_max = (np.choose(which, [choice[end] for choice in choices]) for end in range(2))
    return Rays(rays.origin, rays.direction, t_min.astype(np.float32), t_max.astype(np.float32))


def any_length(stage: Stage, count: int) -> Rays:
    """With directions a thousand times too short or too long, or anything between.

    Some are so short or long that neither 1e9 is infinite nor 1e-5 close to zero.
    """
    rays = inbound(stage, count)
    length = 10.0 ** stage.rng.uniform(-3, 3, (count, 1))
    length[::3], length[1::3] = 1e-3, 1e3
    length[::5], length[1::5] = SHORTEST, LONGEST
    extreme = (length == SHORTEST) | (length == LONGEST)
    t_min = np.where(extreme, EPSILON / length, EPSILON)[:, 0]
    direction = unit(rays.direction.astype(np.float64)) * length
    return beams(rays.origin.astype(np.float64), direction, t_min)


def along_axes(stage: Stage, count: int) -> Rays:
    """Parallel to one or two axes, with zeros of both signs, often in a box's plane.

    Some start so far away, and some are so short, that a zero must not be replaced by something
    small.
    """
    direction = directions(stage, count)
    axis = stage.rng.integers(3, size=count)
    single = stage.rng.random(count) < 0.7
    kept = np.eye(3, dtype=np.bool_)[axis]
    kept[~single] ^= True
    direction[~kept] = 0.0
    direction = unit(direction)
    direction[~kept] *= stage.rng.choice([-1.0, 1.0], np.count_nonzero(~kept))
    through = _mixed(stage, within(stage, count))
    distance = np.full((count, 1), 2.0)
    distance[::3] = 10.0 ** stage.rng.uniform(*FAR, distance[::3].shape)
    length = np.ones((count, 1))
    length[1::3] = SHORT
    origin = through - distance * stage.radius * direction
    return beams(origin, direction * length, (EPSILON / length)[:, 0])


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


def just_inside(stage: Stage, count: int) -> Rays:
    """Straight down to a point as close to an edge as a sure hit can be.

    Who demands that all weights of a hit exceed 1e-5 leaves cracks of that width.
    """
    face = drawn_faces(stage, count)
    corners = corners_at(stage, face)
    away = stage.rng.uniform(*CLOSE, count)
    along = stage.rng.uniform(0.3, 0.7, count)
    weights = np.stack([away, (1 - away) * along, (1 - away) * (1 - along)], axis=1)
    turned = (np.arange(3) + stage.rng.integers(3, size=(count, 1))) % 3
    weights = np.take_along_axis(weights, turned, axis=1)
    target = np.einsum("kc,kcx->kx", weights, corners)
    length = np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1, keepdims=True)
    down = -normals_of(stage, face)
    return beams(target - HEIGHT * length * down, down)


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


SHORTEST, LONGEST = 1e-10, 1e8
"""Lengths of directions. Times the squares of edges, 1e-8 to 1e8, they are floats still."""

SCALES = (-6.0, 6.0)
"""Powers of ten between which the lengths of directions of limited rays are drawn."""

IN_A_ROW = 3
"""So often the same ray comes with different limits."""

CLOSE = (0.8e-5, 0.95e-5)
"""Weights of the corner across an edge: less than 1e-5, and more than the rule of closest hits
leaves open on faces that are not small against their distance from the world's origin."""

HEIGHT = 0.3
"""Lengths of an edge from which a face is looked at, so that t is short and well known."""

SHORT = 1e-7
"""Length of some directions that have zeros: 1e-8 beside it is no zero."""

FAR = (2.5, 3.0)
"""Powers of ten between which distances are drawn, in radii, from which axes are followed.

At 1000 radii 1e-5 instead of 0 leads a hundredth of the radius astray, fifteen times what the
rule of closest hits allows.
"""

SOME = 4_000
"""Vertices among which the outermost is looked for."""


SPECIAL = {
    "on-surface": on_face,
    "between-points": between_points,
    "t-interval": t_interval,
    "any-length": any_length,
    "along-axes": along_axes,
    "in-slab-planes": in_slab_planes,
    "through-vertex": through_vertices,
    "through-edge": through_edges,
    "just-inside": just_inside,
    "grazing": grazing,
    "silhouette": silhouette,
}
"""Family by name. All but `any-length` need a face."""


def _scaled(stage: Stage, count: int) -> tuple[Rays, Doubles]:
    """Return rays to the surface, the same ones in a row, and the lengths of directions."""
    different = -(-count // IN_A_ROW)
    rays = to_surface(stage, different)
    scale = 10.0 ** stage.rng.uniform(*SCALES, different)
    direction = rays.direction.astype(np.float64) * scale[:, None]
    row = np.repeat(np.arange(different), IN_A_ROW)[:count]
    return beams(rays.origin[row].astype(np.float64), direction[row], 0.0), scale[row]


def _in_turn(stage: Stage, count: int, choices: int) -> Integers:
    """Draw numbers below a prime number of choices, different ones for rays in a row."""
    different = -(-count // IN_A_ROW)
    first = stage.rng.integers(choices, size=(different, 1))
    step = stage.rng.integers(1, choices, size=(different, 1))
    turns: Integers = (first + step * np.arange(IN_A_ROW)) % choices
    return turns.ravel()[:count]


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
