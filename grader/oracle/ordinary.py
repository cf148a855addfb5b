"""Which rays does a picture need? The families of `hits.closest-wins`."""

import numpy as np

from grader.model.mesh import Rays
from grader.oracle.bundle import (
    Stage,
    around,
    beams,
    directions,
    drawn_faces,
    normals_of,
    on_surface,
    unit,
    within,
)


def inbound(stage: Stage, count: int) -> Rays:
    """From all around to a point in the box; directions have any length."""
    origin = around(stage, count)
    return beams(origin, within(stage, count) - origin)


def camera(stage: Stage, count: int) -> Rays:
    """From one point to the cells of a grid, as for a picture."""
    eye = around(stage, 1, 2.5)
    forward = unit(stage.middle - eye)
    right = unit(np.cross(forward, directions(stage, 1)))
    up = np.cross(forward, right)
    side = int(np.ceil(np.sqrt(count)))
    cell = (np.arange(side) + 0.5) / side - 0.5
    x, y = (grid.reshape(-1, 1)[:count] for grid in np.meshgrid(cell, cell))
    return beams(np.repeat(eye, count, axis=0), unit(forward + 0.9 * (x * right + y * up)))


def to_surface(stage: Stage, count: int) -> Rays:
    """From all around to a point on a face."""
    origin = around(stage, count)
    return beams(origin, unit(on_surface(stage, drawn_faces(stage, count)) - origin))


def parallel(stage: Stage, count: int) -> Rays:
    """All in one oblique direction, from a plane in front of the mesh."""
    forward = np.repeat(directions(stage, 1), count, axis=0)
    return beams(within(stage, count) - 2 * stage.radius * forward, forward)


def from_inside(stage: Stage, count: int) -> Rays:
    """From a point in the box in any direction."""
    return beams(within(stage, count), directions(stage, count))


def bounced(stage: Stage, count: int) -> Rays:
    """From a little above a face to anywhere on its side, as a reflection goes."""
    face = drawn_faces(stage, count)
    side = normals_of(stage, face) * stage.rng.choice([-1.0, 1.0], (count, 1))
    direction = directions(stage, count)
    below = (direction * side).sum(axis=1) < 0
    direction[below] *= -1
    return beams(on_surface(stage, face) + 1e-2 * stage.radius * side, direction)


def beside(stage: Stage, count: int) -> Rays:
    """Past the mesh, or away from it: misses all."""
    direction = directions(stage, count)
    sideways = unit(np.cross(direction, directions(stage, count)))
    origin = stage.middle + stage.radius * (1.2 * sideways - 2 * direction)
    away = stage.rng.random(count) < 0.5
    outside = around(stage, count)
    origin[away] = outside[away]
    direction[away] = unit(outside - within(stage, count))[away]
    return beams(origin, direction)


def from_far(stage: Stage, count: int) -> Rays:
    """From twenty times as far as the mesh is big."""
    origin = around(stage, count, 20.0)
    return beams(origin, unit(within(stage, count) - origin))


ORDINARY = {
    "inbound": inbound,
    "camera": camera,
    "to-surface": to_surface,
    "parallel": parallel,
    "from-inside": from_inside,
    "bounced": bounced,
    "beside": beside,
    "from-far": from_far,
}
"""Family by name. `to-surface` and `bounced` need a face."""
