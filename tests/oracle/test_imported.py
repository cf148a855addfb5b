"""A course's own model becomes a scene: read, cleaned, seen well and rendered."""

from pathlib import Path

import numpy as np
import pytest

from grader.errors import MissingTool, OutputFault, UsageError
from grader.model.mesh import Mesh
from grader.oracle import imported
from grader.oracle.described import described
from grader.oracle.fitted import FILLED, FOV, fitted_camera, fitted_light
from grader.oracle.imported import Wish, import_scene
from grader.oracle.scenes import image_trials, load_mesh, load_reference, scene_named
from grader.oracle.variant import Variant
from tests.oracle.test_models import QUAD, model
from tests.oracle.treebuilder import tree_of


def wish(path: Path, into: Path, name: str | None = None) -> Wish:
    """Ask for a model to be imported."""
    return Wish(path, into, name, None)


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Render small pictures with what always works."""
    scalar = Variant("scalar_rgb", None, "always works")
    monkeypatch.setattr("grader.oracle.variant.working_variant", lambda: scalar)
    monkeypatch.setattr(imported, "SIZE", 32)


@pytest.mark.parametrize("up", ["y", "z"])
@pytest.mark.parametrize("seed", range(3))
def test_a_fitted_camera_sees_everything_in_the_middle(seed: int, up: str) -> None:
    """Every vertex is in the picture, which is filled in one direction, from above."""
    rng = np.random.default_rng(seed)
    points = (rng.standard_normal((200, 3)) * rng.uniform(0.05, 1, 3)).astype(np.float32)
    mesh = Mesh(points, np.arange(198, dtype=np.uint32).reshape(-1, 3))
    camera = fitted_camera(mesh, up)
    origin, above = np.array(camera.origin), np.array(camera.up)
    ahead = np.array(camera.target) - origin
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, above)
    right /= np.linalg.norm(right)
    seen = points - origin
    depth = seen @ ahead
    places = [seen @ axis / depth for axis in (right, np.cross(right, ahead))]
    reach = np.tan(np.radians(FOV) / 2)
    assert depth.min() > 0
    widest = max(np.abs(place).max() for place in places)
    assert widest == pytest.approx(FILLED * reach, rel=0.01)
    assert all(abs(place.min() + place.max()) < 0.02 * reach for place in places)
    assert origin @ above > points.mean(axis=0) @ above
    assert np.array(fitted_light(up)) @ above < 0


def test_an_import_is_a_scene_that_can_be_graded(tmp_path: Path) -> None:
    """Mesh, picture and description lie in the folder, and what was there stays."""
    into = tmp_path / "ours"
    path = model(tmp_path, QUAD + "v 1 1 3\nf 1 2 3 4\nf 1 2 5\n", "My Model (2).obj")
    told: list[str] = []
    status, _ = import_scene(wish(path, into), told.append)
    assert (status.scene.name, status.faces, status.problem) == ("my-model-2", 3, "")
    assert "rendering" in " ".join(told)
    toml = into / "scenes.toml"
    toml.write_text("# ours\n" + toml.read_text(encoding="utf-8"), encoding="utf-8")
    import_scene(wish(path, into, "second"), told.append)
    assert toml.read_text(encoding="utf-8").startswith("# ours\n[[mesh]]")
    assert [scene.name for scene in described(into).scenes] == ["my-model-2", "second"]
    scene = scene_named("second", into)
    hit = np.isfinite(load_reference(scene, load_mesh("second", into), into).t)
    assert 0.1 < hit.mean() < 0.9
    trials = image_trials(lambda meshes: [tree_of(mesh) for mesh in meshes], into)
    assert [trial.name for trial in trials] == ["my-model-2", "second"]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("grid", "there is a scene grid already"),
        ("Ä", "is no name of a scene"),
        ("../up", "is no name of a scene"),
        ("", "is no name of a scene"),
    ],
)
def test_a_name_has_to_be_free_and_plain(tmp_path: Path, name: str, expected: str) -> None:
    """It becomes the name of files, and is asked for before anything is read."""
    with pytest.raises(UsageError, match=expected):
        import_scene(wish(tmp_path / "none.obj", tmp_path / "ours", name), lambda _: None)
    assert not (tmp_path / "ours").exists()


def test_a_name_is_not_taken_twice(tmp_path: Path) -> None:
    """A second import of one model says so, and changes nothing."""
    path = model(tmp_path, QUAD + "f 1 2 3 4\n")
    import_scene(wish(path, tmp_path / "ours"), lambda _: None)
    before = (tmp_path / "ours" / "scenes.toml").read_bytes()
    with pytest.raises(UsageError, match="scene model already"):
        import_scene(wish(path, tmp_path / "ours"), lambda _: None)
    assert (tmp_path / "ours" / "scenes.toml").read_bytes() == before


def test_without_mitsuba_nothing_is_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The sentence says what to install."""
    monkeypatch.setattr(imported, "mitsuba_version", lambda: None)
    path = model(tmp_path, QUAD + "f 1 2 3 4\n")
    with pytest.raises(MissingTool, match=r"pip install 'bvhgrade\[render\]'"):
        import_scene(wish(path, tmp_path / "ours"), lambda _: None)
    assert not (tmp_path / "ours").exists()


def test_an_unwritable_folder_is_said(tmp_path: Path) -> None:
    """A file stands where the folder should be."""
    path = model(tmp_path, QUAD + "f 1 2 3 4\n")
    with pytest.raises(OutputFault, match="--into"):
        import_scene(wish(path, path / "ours"), lambda _: None)
