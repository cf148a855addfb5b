"""The camera of a page, which moves a mesh into a cube of side 2 and looks at that.

Its axes are those of the desk's camera: a scene whose up is z stands upright in both.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from grader.model.mesh import Mesh
from grader.view.asked import FARTHEST, number, numbers
from grader.view.camera import Orbit, across
from grader.view.subject import cube

FOV = float(2 * np.degrees(np.arctan(1 / 2.2)))
"""Of the page's camera, whose lens has a focal length of 2.2."""


def home_of(orbit: Orbit, mesh: Mesh) -> dict[str, Any]:
    """Say where a page's camera begins: where the scene's own does.

    Args:
        orbit: The scene's own.
        mesh: As it is sent.
    """
    middle, scale = cube(mesh)
    up = np.array(orbit.up)
    east, north = across(up)
    return {
        "yaw": orbit.yaw,
        "pitch": orbit.pitch,
        "far": float(np.clip(orbit.distance * scale * orbit.fov / FOV, 0.05, 40)),
        "at": [float(x) for x in (np.array(orbit.target) - middle) * scale],
        "axes": [axis.tolist() for axis in (east, up, north)],
    }


def orbit_at(given: Mapping[str, Any], home: Orbit, mesh: Mesh) -> Orbit:
    """Have the camera where a page's is.

    Args:
        given: What the page says of it.
        home: Where it began.
        mesh: As it was sent.

    Raises:
        UsageError: A number is none, or out of bounds.
    """
    yaw, pitch, far = (number(given, name, FARTHEST) for name in ("yaw", "pitch", "far"))
    middle, scale = cube(mesh)
    x, y, z = (float(value) for value in np.array(numbers(given, "at", 3)) / scale + middle)
    distance = max(far, 1e-3) / scale
    return replace(home, target=(x, y, z), yaw=yaw, pitch=pitch, distance=distance, fov=FOV)
