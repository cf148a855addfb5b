"""Stored pictures come back to the last bit, or not at all."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from grader.errors import OracleFault
from grader.model.mesh import Mesh, Rays
from grader.model.scene import NO_FACE, Camera, Reference, Scene
from grader.oracle.exr import read_reference, scene_key, write_reference

WIDTH, HEIGHT = 33, 17
AGAIN = "bvhgrade scenes render tiny"

SCENE = Scene(
    name="tiny",
    title="one triangle",
    mesh="triangle",
    camera=Camera(origin=(0, 0, 3), target=(0, 0, 0), up=(0, 1, 0), fov=40),
    light=(0, -1, -1),
    albedo=(0.5, 0.5, 0.5),
    width=WIDTH,
    height=HEIGHT,
)
MESH = Mesh(
    vertices=np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=np.float32),
    faces=np.array([[0, 1, 2]], dtype=np.uint32),
)


def random_picture() -> Reference:
    """Return a picture of arbitrary float32, misses among them."""
    rng = np.random.default_rng(5)
    pixels = WIDTH * HEIGHT
    miss = rng.random(pixels) < 0.5
    vectors = rng.standard_normal((5, pixels, 3)).astype(np.float32)
    vectors[0, :9, 0] = [0.0, -0.0, 1e-45, -1e-45, 3e38, np.pi, 1e-38, 1.0, -1.0]
    t = rng.random(pixels).astype(np.float32)
    return Reference(
        key=scene_key(SCENE, MESH),
        made_with=(("mitsuba", "3.9.7"), ("drjit", "4.5.6"), ("variant", "scalar_rgb")),
        rays=Rays(
            origin=vectors[0],
            direction=vectors[1],
            t_min=np.full(pixels, 1e-5, dtype=np.float32),
            t_max=np.full(pixels, np.inf, dtype=np.float32),
        ),
        t=np.where(miss, np.float32(np.inf), t),
        point=vectors[2],
        normal=vectors[3],
        face=np.where(miss, NO_FACE, 16_777_217).astype(np.uint32),
        shaded=vectors[4],
    )


@pytest.fixture
def stored(tmp_path: Path) -> Path:
    """Store the random picture."""
    path = tmp_path / "folder" / "tiny.exr"
    write_reference(path, SCENE, random_picture())
    return path


def bits(picture: Reference) -> list[bytes]:
    """List the bytes of every array of a picture."""
    rays = picture.rays
    arrays = (rays.origin, rays.direction, rays.t_min, rays.t_max, picture.t, picture.point)
    return [a.tobytes() for a in (*arrays, picture.normal, picture.face, picture.shaded)]


def test_a_picture_comes_back_to_the_last_bit(stored: Path) -> None:
    """Infinities, signed zeros, denormals and face indices above 2^24 survive."""
    picture = read_reference(stored, SCENE, MESH, AGAIN)
    assert bits(picture) == bits(random_picture())
    assert picture.key == random_picture().key
    assert picture.made_with == random_picture().made_with


@pytest.mark.parametrize(
    "changed",
    [
        replace(SCENE, width=HEIGHT, height=WIDTH),
        replace(SCENE, camera=replace(SCENE.camera, fov=41)),
        replace(SCENE, camera=replace(SCENE.camera, origin=(0, 0, 3.0000002))),
        replace(SCENE, light=(0, -1, -2)),
        replace(SCENE, albedo=(0.5, 0.5, 0.6)),
    ],
)
def test_a_stale_picture_is_refused(stored: Path, changed: Scene) -> None:
    """Another camera, light or size: the fault says so and names the command that helps."""
    with pytest.raises(OracleFault, match=r"now give .* `bvhgrade scenes render tiny`"):
        read_reference(stored, changed, MESH, AGAIN)


def test_a_picture_of_another_mesh_is_refused(stored: Path) -> None:
    """One vertex that moved by one bit is another mesh; so are the same faces turned."""
    moved = MESH.vertices.copy()
    moved[1, 0] = np.nextafter(np.float32(1), np.float32(2))
    for other in (replace(MESH, vertices=moved), replace(MESH, faces=MESH.faces[:, [1, 2, 0]])):
        with pytest.raises(OracleFault, match="was rendered of scene"):
            read_reference(stored, SCENE, other, AGAIN)


def test_a_new_title_leaves_the_picture_valid(stored: Path) -> None:
    """Names are for people; the picture does not depend on them."""
    assert read_reference(stored, replace(SCENE, title="renamed"), MESH, AGAIN).key


def test_a_missing_picture_names_the_command(tmp_path: Path) -> None:
    """A scene that was never rendered."""
    with pytest.raises(OracleFault, match="missing; render it anew with `bvhgrade scenes"):
        read_reference(tmp_path / "tiny.exr", SCENE, MESH, AGAIN)


def test_one_flipped_bit_in_the_pixels_is_found(stored: Path) -> None:
    """Wherever pixels are stored, a flipped bit refuses the picture."""
    whole = stored.read_bytes()
    places = np.random.default_rng(1).integers(len(whole) // 3, len(whole), size=25)
    for place in places.tolist():
        broken = bytearray(whole)
        broken[place] ^= 16
        stored.write_bytes(broken)
        with pytest.raises(OracleFault, match="damaged"):
            read_reference(stored, SCENE, MESH, AGAIN)


@pytest.mark.parametrize("size", [0, 3, 100, 1500, -1])
def test_a_file_that_ends_too_early_is_refused(stored: Path, size: int) -> None:
    """An interrupted copy is no picture."""
    stored.write_bytes(stored.read_bytes()[:size])
    with pytest.raises(OracleFault, match="damaged"):
        read_reference(stored, SCENE, MESH, AGAIN)


def test_an_older_format_is_refused(stored: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A picture whose channels may mean something else is not read."""
    monkeypatch.setattr("grader.oracle.exr.FORMAT", "2")
    with pytest.raises(OracleFault, match="has format 1, but this grader reads 2"):
        read_reference(stored, SCENE, MESH, AGAIN)
