"""One camera for both panes: rays and projection say the same."""

import numpy as np
import pytest

from grader.model.scene import Camera
from grader.oracle.scenes import scenes
from grader.view.camera import (
    FARTHEST,
    NEAREST,
    STEEPEST,
    Orbit,
    frame_of,
    orbit_around,
    orbit_of,
    projection,
    rays_of,
)

CAMERA = Camera((3.0, -4.0, 5.0), (0.5, 0.0, -0.25), (0.0, 0.0, 1.0), 40.0)


def usual() -> Orbit:
    """Look at something."""
    return orbit_of(CAMERA, 4.0)


@pytest.mark.parametrize("camera", [CAMERA, *(scene.camera for scene in scenes())])
def test_it_begins_where_a_scene_says(camera: Camera) -> None:
    """Eye and direction are those of the scene's own camera."""
    frame = frame_of(orbit_of(camera, 1.0))
    ahead = np.array(camera.target) - np.array(camera.origin)
    assert frame.eye == pytest.approx(np.array(camera.origin), abs=1e-6)
    assert -frame.back == pytest.approx(ahead / np.linalg.norm(ahead), abs=1e-9)
    assert frame.right @ np.array(camera.up) == pytest.approx(0, abs=1e-9)
    assert frame.up @ np.array(camera.up) > 0


@pytest.mark.parametrize("orbit", [usual(), usual().turned(2.0, -1.0).panned(0.2, 0.1)])
@pytest.mark.parametrize(("width", "height"), [(64, 48), (30, 50), (1, 1)])
def test_a_ray_goes_where_its_pixel_is_drawn(orbit: Orbit, width: int, height: int) -> None:
    """A point on the ray of a pixel is projected onto the middle of that pixel."""
    pixels = np.arange(width * height)
    rays = rays_of(orbit, width, height, pixels).astype(np.float64)
    points = rays[:, 0:3] + orbit.distance * rays[:, 3:6]
    clip = np.c_[points, np.ones(len(points))] @ projection(orbit, width, height).T
    x = (clip[:, 0] / clip[:, 3] + 1) * width / 2
    y = (1 - clip[:, 1] / clip[:, 3]) * height / 2
    assert x == pytest.approx(pixels % width + 0.5, abs=0.01)
    assert y == pytest.approx(pixels // width + 0.5, abs=0.01)
    assert (np.abs(clip[:, 2]) < clip[:, 3]).all()


@pytest.mark.parametrize("size", [1e-12, 1e-3, 1.0, 1e31])
def test_rays_begin_in_front_of_what_is_seen(size: float) -> None:
    """However small it is; and what goes to the graphics card is about 1."""
    corner = np.full(3, size)
    orbit = orbit_around(-corner, corner)
    rays = rays_of(orbit, 4, 4, np.arange(16))
    assert (rays[:, 6] < orbit.distance - 2 * size).all()
    clip = projection(orbit, 4, 4) @ np.array([*corner, 1.0], np.float32)
    assert 1e-3 < np.abs(clip).max() < 1e3


def test_turning_keeps_the_distance_and_stops_at_the_poles() -> None:
    """Whoever goes on turning upwards ends just before the pole."""
    orbit = usual().turned(0.3, 100.0)
    assert orbit.pitch == STEEPEST
    away = frame_of(orbit).eye - np.array(orbit.target)
    assert np.linalg.norm(away) == pytest.approx(usual().distance)
    assert np.isfinite(projection(orbit, 8, 8)).all()


def test_zooming_has_two_ends() -> None:
    """Nobody gets lost behind the model or at the end of the world."""
    assert usual().zoomed(1e-9).distance == NEAREST * 4.0
    assert usual().zoomed(1e9).distance == FARTHEST * 4.0


def test_panning_moves_what_is_seen_by_as_much() -> None:
    """The point in the middle moves half a pane to the right."""
    orbit = usual().panned(0.5, 0.0)
    clip = projection(orbit, 10, 10) @ np.array([*CAMERA.target, 1.0])
    assert clip[0] / clip[3] == pytest.approx(1.0, abs=1e-5)
    assert clip[1] / clip[3] == pytest.approx(0.0, abs=1e-5)


def test_a_point_can_be_looked_at() -> None:
    """A mesh without any extent gives a camera, too."""
    orbit = orbit_around(np.zeros(3), np.zeros(3))
    assert np.isfinite(rays_of(orbit, 4, 4, np.arange(16))[:, 0:6]).all()
