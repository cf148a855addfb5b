"""The stored scenes are complete, and are what they say."""

import hashlib
import re
from pathlib import Path

import numpy as np
import pytest

from grader.errors import OracleFault, UsageError
from grader.model.mesh import Mesh
from grader.model.scene import NO_FACE, Scene
from grader.oracle.album import list_scenes
from grader.oracle.described import StoredMesh
from grader.oracle.scenes import (
    GENERATORS,
    answers_path,
    load_mesh,
    load_reference,
    mesh_path,
    reference_path,
    scene_named,
    scenes,
    scenes_sha256,
    stored_meshes,
)
from grader.oracle.storage import load_mesh_file, mesh_sha256, save_mesh
from grader.resources import scenes_folder


def test_the_sheets_scenes_are_there() -> None:
    """The grid of figure 3, nested spheres, loose and thin triangles, land, three dragons."""
    made = ["grid", "nested", "dragon", "soup", "thin", "landscape"]
    assert [scene.name for scene in scenes()] == [*made, "dragon-res2", "dragon-res4"]
    dragon = scene_named("dragon")
    assert (dragon.width, dragon.height) == (512, 512)
    assert len(load_mesh(dragon.mesh).faces) == 871_414


def test_every_reference_can_be_used() -> None:
    """No stored picture is stale, and together they stay small."""
    listed = list_scenes()
    assert [status.problem for status in listed] == [""] * len(listed)
    assert sum(status.reference_mib for status in listed) < 10


@pytest.mark.parametrize("stored", stored_meshes(), ids=lambda mesh: mesh.name)
def test_every_mesh_is_whole(stored: StoredMesh) -> None:
    """A mesh loads, hashes to what is written down, and its faces are in range."""
    mesh = load_mesh(stored.name)
    assert mesh.faces.max() < len(mesh.vertices)
    assert np.isfinite(mesh.vertices).all()


def test_the_readme_tells_every_files_hash() -> None:
    """What a course can verify by hand is true."""
    told = (scenes_folder() / "README.md").read_text(encoding="utf-8")
    hashes = dict(re.findall(r"`([\w./-]+)`\W+`([0-9a-f]{64})`", told))
    files = [mesh_path(mesh.name) for mesh in stored_meshes() if mesh.recipe is None]
    for scene in scenes():
        files += [reference_path(scene.name), answers_path(scene.name)]
    actual = {
        str(path.relative_to(scenes_folder())): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in files
    }
    assert hashes == actual


@pytest.mark.parametrize("stored", stored_meshes(), ids=lambda mesh: mesh.name)
def test_generated_meshes_can_be_made_again(stored: StoredMesh) -> None:
    """The generators still give the bytes that are stored."""
    source = stored.source
    if source in GENERATORS:
        assert mesh_sha256(GENERATORS[source]()) == stored.sha256


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_a_picture_shows_its_scene(scene: Scene) -> None:
    """Every picture has hits and misses, lit and dark pixels, and an unclipped border."""
    picture = load_reference(scene, load_mesh(scene.mesh))
    hit = np.isfinite(picture.t).reshape(scene.height, scene.width)
    assert 0.2 < hit.mean() < 0.8
    assert np.array_equal(hit.ravel(), picture.face != NO_FACE)
    assert (picture.shaded[hit.ravel()].max(axis=1) > 0.3).mean() > 0.4
    assert not hit[[0, -1]].any()
    lengths = np.linalg.norm(picture.normal[hit.ravel()].astype(np.float64), axis=1)
    assert np.allclose(lengths, 1, atol=1e-5)


def test_the_hash_covers_the_folder() -> None:
    """One hash stands for everything in a grade that comes from the scenes."""
    assert re.fullmatch(r"[0-9a-f]{64}", scenes_sha256())


def test_an_unknown_scene_is_the_callers_mistake() -> None:
    """The sentence lists what there is."""
    with pytest.raises(UsageError, match="there are grid, nested, dragon, soup"):
        scene_named("bunny")


def test_a_mesh_survives_storing(tmp_path: Path) -> None:
    """Any float32 and any index come back, NaN and signed zero too."""
    rng = np.random.default_rng(2)
    words = rng.integers(0, 2**32, size=(50, 3), dtype=np.uint32)
    mesh = Mesh(vertices=words.view(np.float32), faces=words[:7].copy())
    save_mesh(tmp_path / "mesh.npz", mesh)
    loaded = load_mesh_file(tmp_path / "mesh.npz")
    assert mesh_sha256(loaded) == mesh_sha256(mesh)


@pytest.mark.parametrize("size", [0, 10, 1000, -1])
def test_a_damaged_mesh_is_our_fault(tmp_path: Path, size: int) -> None:
    """A file that ends early is refused with its name."""
    path = tmp_path / "cut.npz"
    path.write_bytes(mesh_path("nested").read_bytes()[:size])
    with pytest.raises(OracleFault, match=r"cut\.npz"):
        load_mesh_file(path)
