"""From where is a model seen well? A camera and a light that fit it."""

import numpy as np

from grader.model.mesh import Doubles, Mesh
from grader.model.scene import Camera

FOV = 30.0
"""Degrees: close enough for depth, far enough for little distortion."""

FILLED = 0.92
"""Of the picture's height and width, at most."""

ASIDE, ABOVE = 0.6, 0.45
"""Where the camera stands: to the right of the front and above, in multiples of ahead."""

ROUNDS = 8
"""Each halves how far the model is off the middle, or better."""

Three = tuple[float, float, float]

AXES = {"y": ((1, 0, 0), (0, 1, 0), (0, 0, 1)), "z": ((1, 0, 0), (0, 0, 1), (0, -1, 0))}
"""Right, up and towards the one who looks, by the axis that points up."""


def fitted_camera(mesh: Mesh, up: str) -> Camera:
    """Place a camera so that the whole mesh is in a square picture, and in its middle.

    Args:
        mesh: At least one face.
        up: The axis that points up, `y` or `z`.
    """
    right, above, ahead = _view(up)
    points = mesh.vertices.astype(np.float64)
    target = (points.min(axis=0) + points.max(axis=0)) / 2
    reach = FILLED * np.tan(np.radians(FOV) / 2)
    distance = 0.0
    for _ in range(ROUNDS):
        x, y, near = ((points - target) @ axis for axis in (right, above, ahead))
        far = np.maximum(np.abs(x), np.abs(y)) / reach + near
        distance = float(far.max())
        seen = [side / (distance - near) for side in (x, y)]
        for side, axis in zip(seen, (right, above), strict=True):
            target = target + axis * distance * (side.min() + side.max()) / 2
    x, y, near = ((points - target) @ axis for axis in (right, above, ahead))
    distance = float((np.maximum(np.abs(x), np.abs(y)) / reach + near).max())
    return Camera(
        origin=_three(target + distance * ahead),
        target=_three(target),
        up=_three(np.array(AXES[up][1], dtype=np.float64)),
        fov=FOV,
    )


def fitted_light(up: str) -> Three:
    """Return where a light shines to that stands left of the camera and higher."""
    right, above, ahead = _view(up)
    return _three(0.75 * right - 0.7 * above - ahead)


def _view(up: str) -> tuple[Doubles, Doubles, Doubles]:
    """Return the picture's right and up, and the direction to the camera; unit vectors."""
    side, top, front = (np.array(axis, dtype=np.float64) for axis in AXES[up])
    ahead = front + ASIDE * side + ABOVE * top
    ahead /= np.linalg.norm(ahead)
    right = np.cross(top, ahead)
    right /= np.linalg.norm(right)
    return right, np.cross(ahead, right), ahead


def _three(vector: Doubles) -> Three:
    """Round so that people can read it."""
    x, y, z = (round(float(one), 5) + 0.0 for one in vector)
    return x, y, z
