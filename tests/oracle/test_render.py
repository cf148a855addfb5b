"""Mitsuba renders what is stored, along rays through the pixels' centres."""

import numpy as np
import pytest

from grader.model.mesh import Doubles
from grader.model.scene import Scene
from grader.oracle.render import render
from grader.oracle.scenes import answers_path, load_mesh, load_reference, scenes
from grader.oracle.shipped import read_answers
from grader.oracle.variant import Variant, llvm_libraries, working_variant
from grader.tolerances import PICTURE_PIXELS, PICTURE_RELATIVE

SCALAR = Variant("scalar_rgb", None, "always works")
by_name = pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)


def centre_directions(scene: Scene) -> Doubles:
    """Return (R, 3) float64, unit directions of a pinhole camera, by the textbook."""
    origin, target, up = (
        np.array(v) for v in (scene.camera.origin, scene.camera.target, scene.camera.up)
    )
    forward = target - origin
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    above = np.cross(right, forward)
    y, x = np.divmod(np.arange(scene.width * scene.height), scene.width)
    half = np.tan(np.radians(scene.camera.fov) / 2)
    across = ((x + 0.5) / scene.width * 2 - 1) * half * scene.width / scene.height
    down = (1 - (y + 0.5) / scene.height * 2) * half
    direction: Doubles = forward + across[:, None] * right + down[:, None] * above
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    return direction


@by_name
def test_rays_go_through_the_pixels_centres(scene: Scene) -> None:
    """All start at the camera, to the last bit, and none is off by a hundredth of a pixel."""
    rays = load_reference(scene, load_mesh(scene.mesh)).rays
    assert (rays.origin == np.array(scene.camera.origin, dtype=np.float32)).all()
    pixel = np.radians(scene.camera.fov) / scene.height
    assert np.abs(rays.direction - centre_directions(scene)).max() < 0.01 * pixel


@by_name
@pytest.mark.parametrize("fast", [False, True], ids=["scalar", "llvm"])
def test_rendering_again_gives_the_stored_picture(scene: Scene, fast: bool) -> None:
    """The scalar variant and the one of LLVM agree with the repository."""
    mesh = load_mesh(scene.mesh)
    stored = load_reference(scene, mesh)
    variant = working_variant() if fast else SCALAR
    # On a machine without LLVM this proves nothing, and so it is red there.
    assert variant.name == ("llvm_ad_rgb" if fast else "scalar_rgb"), "apt install libllvm19"
    again = render(scene, mesh, variant)
    assert again.key == stored.key
    assert np.abs(again.rays.direction - stored.rays.direction).max() < 1e-6
    both = np.isfinite(again.t) & np.isfinite(stored.t)
    flags = np.isfinite(again.t) != np.isfinite(stored.t)
    far = np.abs(again.t[both] - stored.t[both]) > PICTURE_RELATIVE * stored.t[both]
    assert np.count_nonzero(flags) + np.count_nonzero(far) <= PICTURE_PIXELS
    found = read_answers(answers_path(scene.name), stored)
    assert found is not None
    # Either face of an edge may be named, but no face that the rule rules out.
    for ray in np.flatnonzero(both & (again.face != stored.face)):
        allowed = found.face[found.first[ray] : found.first[ray + 1]]
        assert {again.face[ray], stored.face[ray]} <= set(allowed)


def test_points_lie_on_their_rays() -> None:
    """Point, distance and ray of the stored dragon belong together."""
    (scene,) = (each for each in scenes() if each.name == "dragon")
    picture = load_reference(scene, load_mesh(scene.mesh))
    hit = np.isfinite(picture.t)
    along = picture.t[hit, None].astype(np.float64) * picture.rays.direction[hit]
    assert np.abs(picture.rays.origin[hit] + along - picture.point[hit]).max() < 1e-5


def test_only_llvm_that_can_work_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    """A path that is no file is never loaded, so nothing can abort."""
    monkeypatch.setenv("DRJIT_LIBLLVM_PATH", "/nowhere/libLLVM.so")
    assert llvm_libraries() == ()
