"""A handout shows what students are to see, and nothing else."""

import io
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from grader import resources
from grader.model.mesh import Mesh
from grader.oracle.album import render_scenes
from grader.oracle.scenes import load_mesh, scenes
from grader.oracle.variant import Variant
from grader.package import handout as module
from grader.package.archive import zipped
from grader.package.handout import as_obj, members, points
from grader.package.kit import Choices
from grader.score.rubric import SHIPPED, load_rubric
from tests.oracle.own import own_folder
from tests.own_files import ROOT

ANYWHERE = {"namespace {", "} // namespace", "};", "AABB bounds;"}
"""Lines of the model solution that the exercise's own files have as well."""


def lines(path: Path) -> set[str]:
    """Read what a source says, line by line."""
    return {line.strip() for line in path.read_text("latin-1").splitlines()} - {""}


@pytest.fixture(scope="module")
def handout() -> zipfile.ZipFile:
    """Make the handout of the built-in rubric."""
    return zipfile.ZipFile(io.BytesIO(zipped(members(Choices()))))


def test_it_is_the_exercise_as_it_is_kept(handout: zipfile.ZipFile) -> None:
    """File for file, the starter among them."""
    stub = resources.stub_folder()
    for name in ("src/exercise03.cpp", "include/bvh.h", "CMakePresets.json", "README.md"):
        assert handout.read(f"exercise03/{name}") == (stub / name).read_bytes()


def test_nothing_of_reference_grader_or_tests_is_in_it(handout: zipfile.ZipFile) -> None:
    """Neither a file, nor a line of a solution that partitions, nor any of the model's."""
    names = handout.namelist()
    assert not [name for name in names if not name.startswith("exercise03/")]
    assert not [name for name in names if Path(name).suffix in {".py", ".whl", ".exr", ".npz"}]
    texts = [name for name in names if not name.endswith((".obj", ".png"))]
    told = "\n".join(handout.read(name).decode() for name in texts)
    starter = handout.read("exercise03/src/exercise03.cpp").decode()
    solutions = [
        resources.reference_source(),
        *(ROOT / "tests/submissions/right").glob("*.cpp"),
    ]
    theirs = {line for path in solutions for line in lines(path) if "nth_element(" in line}
    assert theirs
    assert not [line for line in theirs if line in told and line not in starter]
    own = lines(resources.reference_source()) - {line.strip() for line in starter.splitlines()}
    assert len(own) > 50
    assert own & {line.strip() for line in told.splitlines()} <= ANYWHERE


def test_a_hidden_scene_of_a_course_is_not_in_it(
    tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither its model, nor its picture, nor its name; the course's other scene is."""
    assert cache.is_dir()
    scalar = Variant("scalar_rgb", None, "always works")
    monkeypatch.setattr("grader.oracle.variant.working_variant", lambda: scalar)
    render_scenes((), lambda _: None, own_folder(tmp_path))
    # The built-in ones take long, and are looked at below.
    monkeypatch.setattr(module, "scenes", lambda folder: scenes(folder) if folder else ())
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(SHIPPED.read_text() + '\n[scenes]\nfolder = "ours"\n')
    made = {one.name: one.data for one in members(Choices(rubric))}
    assert {"exercise03/models/our-made.obj", "exercise03/models/our-made.png"} <= made.keys()
    assert not [name for name, data in made.items() if "our-few" in name or b"our-few" in data]


def test_every_visible_scene_comes_as_model_and_picture(handout: zipfile.ZipFile) -> None:
    """In the size that scenes.toml says."""
    for scene in scenes():
        picture = Image.open(io.BytesIO(handout.read(f"exercise03/models/{scene.name}.png")))
        assert picture.size == (scene.width, scene.height)
        assert len(picture.convert("RGB").getcolors(1 << 20) or ()) > 2
        assert f"exercise03/models/{scene.name}.obj" in handout.namelist()
    assert b"Stanford" in handout.read("exercise03/models/README.md")


def test_a_model_gives_every_float_back() -> None:
    """Nine digits are enough for any float32; faces count from 1."""
    vertices = np.array([[1 / 3, 1e-38, -0.0], [3e38, 16777215, 0.1], [1, 2, 3]], np.float32)
    lines = as_obj(Mesh(vertices, np.array([[0, 1, 2]], np.uint32))).decode().splitlines()
    read = np.array([line.split()[1:] for line in lines[:3]]).astype(np.float32)
    assert read.tobytes() == vertices.tobytes()
    assert lines[3:] == ["f 1 2 3"]


def test_a_stored_mesh_has_all_its_faces(handout: zipfile.ZipFile) -> None:
    """The smallest dragon, line by line."""
    mesh = load_mesh("dragon-res4")
    lines = handout.read("exercise03/models/dragon-res4.obj").decode().splitlines()
    faces = np.array([line.split()[1:] for line in lines if line[0] == "f"], np.int64)
    assert np.array_equal(faces - 1, mesh.faces)


def test_what_a_rubric_hides_has_points_but_no_name(tmp_path: Path) -> None:
    """Not even how many such checks there are."""
    text = SHIPPED.read_text()
    hidden = text.replace(
        'check = "image.equals-mitsuba"\n',
        'check = "image.equals-mitsuba"\nvisibility = "hidden"\n',
    )
    assert hidden != text
    path = tmp_path / "rubric.toml"
    path.write_text(hidden)
    told, usual = points(load_rubric(path)), points(load_rubric())
    assert "image.equals-mitsuba" in usual
    assert "image.equals-mitsuba" not in told
    assert "| 3 | what is not shown before the due date, or at all |" in told
    assert told.count(": 25 points") == 2


def test_a_gate_is_called_so() -> None:
    """It is worth nothing by itself, and everything if it fails."""
    told = points(load_rubric())
    (readable,) = [line for line in told.splitlines() if "`bvh.is-readable`" in line]
    (used,) = [line for line in told.splitlines() if "`work.uses-the-tree`" in line]
    assert readable.startswith("| gate | ")
    assert used.startswith("| 2, gate | ")
    assert "| 0 |" not in told
    assert told.endswith("If a gate passes nowhere, its part earns nothing.\n")
