"""What is opened first, and which scenes there are."""

from pathlib import Path

import pytest

from grader.cli.progress import silent
from grader.errors import UsageError
from grader.options import Options
from grader.oracle.scenes import scenes
from grader.score.rubric import SHIPPED
from grader.view.opening import Wish, wanted
from grader.view.subject import of_scene, own_scenes, scene_folders
from tests.oracle.own import MESH, own_folder


@pytest.fixture
def rubric(tmp_path: Path) -> Path:
    """Write the shipped rubric with a folder of two own scenes."""
    own_folder(tmp_path)
    path = tmp_path / "rubric.toml"
    path.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    return path


def wish(rubric: Path | None, scene: str) -> Wish:
    """Want to see a scene."""
    return Wish(Path("a.cpp"), Options(41, rubric, (), silent), scene, None, str)


def test_a_course_s_own_scene_opens(rubric: Path) -> None:
    """By its name, and it is listed behind the shipped ones."""
    subject = wanted(wish(rubric, "our-few"))()
    assert subject.title == "a few triangles"
    assert (subject.mesh.faces == MESH.faces).all()
    own = own_scenes(Options(41, rubric, (), silent))
    shipped = [scene.name for scene in scenes()]
    assert list(scene_folders(own)) == [*shipped, "our-few", "our-made"]
    assert of_scene(shipped[0], own).name == shipped[0]


def test_without_the_rubric_it_is_unknown() -> None:
    """Those that there are are named."""
    with pytest.raises(UsageError, match=r"no scene is called our-few; there are .*dragon"):
        wanted(wish(None, "our-few"))
