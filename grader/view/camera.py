"""From where is a scene seen? One camera for both panes: it turns around a point."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from grader.model.mesh import Doubles, Floats, Integers
from grader.model.scene import Camera as SceneCamera

STEEPEST = 1.55
"""Radians; straight from above there is no right and left."""

NEAREST, FARTHEST = 1e-3, 1e3
"""Distances from the point that is looked at, in sizes of the scene."""

T_MIN = 1e-5
"""Where rays begin, as the exercise's `epsilon`; of a model that is closer than that,"""

LEAST_T_MIN = 1e-4
"""at this part of the distance."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Place and axes of a camera, (3,) float64 in world space; axes are unit vectors."""

    eye: Doubles
    right: Doubles
    up: Doubles
    back: Doubles
    """Away from what is seen."""


@dataclass(frozen=True, slots=True)
class Orbit:
    """A pinhole camera on a sphere around a point."""

    target: tuple[float, float, float]
    up: tuple[float, float, float]
    """Where the scene's own up is, a unit vector."""

    yaw: float
    """Radians around `up`."""

    pitch: float
    """Radians above the plane across `up`."""

    distance: float
    fov: float
    """Vertical angle of view in degrees, of a pane that is wider than high."""

    size: float
    """Of the scene, for how far one may go."""

    def turned(self, right: float, above: float) -> "Orbit":
        """Turn by angles in radians."""
        pitch = min(STEEPEST, max(-STEEPEST, self.pitch + above))
        return replace(self, yaw=self.yaw + right, pitch=pitch)

    def zoomed(self, factor: float) -> "Orbit":
        """Go nearer or away."""
        distance = min(FARTHEST * self.size, max(NEAREST * self.size, self.distance * factor))
        return replace(self, distance=distance)

    def panned(self, right: float, up: float) -> "Orbit":
        """Move what is seen, in heights of the pane."""
        frame = frame_of(self)
        height = 2 * self.distance * float(np.tan(np.radians(self.fov) / 2))
        moved = np.array(self.target) - height * (right * frame.right + up * frame.up)
        if not np.abs(moved).max() < FARTHEST * max(self.size, 1.0) * 1e3:
            return self
        return replace(self, target=_triple(moved))


def orbit_of(camera: SceneCamera, size: float) -> Orbit:
    """Begin where a scene's picture is taken from."""
    up = _unit(np.array(camera.up, np.float64))
    away = np.array(camera.origin, np.float64) - np.array(camera.target, np.float64)
    distance = float(np.linalg.norm(away))
    east, north = across(up)
    return Orbit(
        target=camera.target,
        up=_triple(up),
        yaw=float(np.arctan2(away @ east, away @ north)),
        pitch=float(np.arcsin(np.clip(away @ up / distance, -1, 1))),
        distance=distance,
        fov=camera.fov,
        size=max(size, distance * NEAREST, 1e-30),
    )


def orbit_around(low: Doubles, high: Doubles) -> Orbit:
    """Look at a box from the front, a little from above and from the side.

    Args:
        low: (3,) float64, its smallest corner in world space.
        high: (3,) float64, its largest one.
    """
    middle = (low + high) / 2
    size = float(np.linalg.norm(high - low))
    size = size if np.isfinite(size) and size > 0 else 1.0
    fov = 40.0
    distance = 0.55 * size / float(np.sin(np.radians(fov) / 2))
    return Orbit(_triple(middle), (0.0, 1.0, 0.0), 0.5, 0.35, distance, fov, size)


@lru_cache(maxsize=8)
def frame_of(orbit: Orbit) -> Frame:
    """Return the camera's axes; the last ones are kept, because they are asked for again."""
    up = np.array(orbit.up)
    east, north = across(up)
    level = np.sin(orbit.yaw) * east + np.cos(orbit.yaw) * north
    back = np.cos(orbit.pitch) * level + np.sin(orbit.pitch) * up
    right = _unit(np.cross(up, back))
    eye = np.array(orbit.target) + orbit.distance * back
    return Frame(eye, right, np.cross(back, right), back)


def spread(orbit: Orbit, width: int, height: int) -> tuple[float, float]:
    """Return half of the picture's width and height at distance 1."""
    aspect = width / max(height, 1)
    half = float(np.tan(np.radians(orbit.fov) / 2)) / min(1.0, aspect)
    return half * aspect, half


def rays_of(orbit: Orbit, width: int, height: int, pixels: Integers) -> Floats:
    """Return the rays through the middles of pixels.

    Args:
        orbit: The camera.
        width: Of the picture in pixels.
        height: Of the picture in pixels.
        pixels: (K,) int64, row by row from the top left one.

    Returns:
        (K, 8) float32: origin, unit direction, t_min, t_max.
    """
    frame, (wide, high) = frame_of(orbit), spread(orbit, width, height)
    row, column = np.divmod(pixels, width)
    x = ((column + 0.5) * (2 * wide / width) - wide)[:, None]
    y = (high - (row + 0.5) * (2 * high / height))[:, None]
    direction = x * frame.right + y * frame.up - frame.back
    direction /= np.sqrt((direction * direction).sum(axis=1))[:, None]
    table = np.empty((len(pixels), 8), np.float32)
    table[:, 0:3], table[:, 3:6] = frame.eye, direction
    table[:, 6], table[:, 7] = min(T_MIN, LEAST_T_MIN * orbit.distance), np.inf
    return table


def within(pixel: tuple[int, int], size: tuple[int, int]) -> tuple[int, int]:
    """Return the nearest pixel of a picture; columns and rows, widths and heights."""
    column, row = (min(max(at, 0), most - 1) for at, most in zip(pixel, size, strict=True))
    return column, row


def projection(orbit: Orbit, width: int, height: int) -> Floats:
    """Return the (4, 4) float32 matrix from world space to a screen's clip space.

    The last rows map distances so that the whole scene is between near and far. What comes out
    is about 1, however small or large the scene is: a graphics card has 32 bits.
    """
    frame, (wide, high) = frame_of(orbit), spread(orbit, width, height)
    near = max(orbit.distance * 1e-2, orbit.size * 1e-6)
    far = orbit.distance + 20 * orbit.size
    view = np.eye(4)
    view[0, :3], view[1, :3], view[2, :3] = frame.right, frame.up, frame.back
    view[:3, 3] = -view[:3, :3] @ frame.eye
    lens = np.zeros((4, 4))
    lens[0, 0], lens[1, 1] = 1 / wide, 1 / high
    lens[2, 2], lens[2, 3] = (far + near) / (near - far), 2 * far * near / (near - far)
    lens[3, 2] = -1
    return (lens @ view / orbit.distance).astype(np.float32)


def across(up: Doubles) -> tuple[Doubles, Doubles]:
    """Return two unit vectors that span the plane across a unit vector, `east x north = up`.

    All are (3,) float64.
    """
    # With y up, north is z and east is x, as in the report.
    seed = np.array([0.0, 0.0, 1.0]) if abs(up[2]) < 0.9 else np.array([0.0, -1.0, 0.0])
    north = _unit(seed - (seed @ up) * up)
    return np.cross(up, north), north


def _unit(vector: Doubles) -> Doubles:
    return np.asarray(vector / np.linalg.norm(vector))


def _triple(values: Doubles) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
