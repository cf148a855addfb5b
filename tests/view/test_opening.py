"""What is opened first, and which scenes there are."""

import os
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest

from grader import pipeline
from grader.cli.progress import silent
from grader.counterexample.written import to_text
from grader.errors import UsageError
from grader.model.counterexample import Counterexample
from grader.model.grade import CheckScore
from grader.model.trials import ConstructTrial
from grader.model.verdict import Verdict
from grader.options import Options
from grader.oracle.scenes import scenes
from grader.score.rubric import SHIPPED
from grader.view import opening as opening_module
from grader.view import screenshot as screenshot_module
from grader.view.opening import Wish, opening, wanted
from grader.view.subject import Subject, of_scene, own_scenes, scene_folders
from tests.oracle.own import MESH, own_folder
from tests.report import samples
from tests.verify.builder import soup
from tests.view import sources


@pytest.fixture
def rubric(tmp_path: Path) -> Path:
    """Write the shipped rubric with a folder of two own scenes."""
    own_folder(tmp_path)
    path = tmp_path / "rubric.toml"
    path.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    return path


def wish(rubric: Path | None, scene: str) -> Wish:
    """Want to see a scene."""
    return Wish(Path("a.cpp"), Options(41, rubric, (), silent), scene, None)


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


def of_check(folder: Path, check: str) -> Wish:
    """Want to see what fails a check."""
    return Wish(folder / "a.cpp", Options(41, None, (), silent), None, check)


def test_a_check_that_does_not_exist_is_told_at_once(tmp_path: Path) -> None:
    """Before anything is opened, and what is spelled alike is named."""
    with pytest.raises(UsageError, match=r"--check hits.closest-win: .* hits.closest-wins"):
        wanted(of_check(tmp_path, "hits.closest-win"))


def written(folder: Path, name: str, check: str) -> Path:
    """Write a counterexample of a check into a folder, under the name of any."""
    there = folder / "counterexamples"
    there.mkdir(parents=True)
    file = there / f"{name}.json"
    trial = ConstructTrial("x", soup(5))
    file.write_text(to_text(Counterexample(check, trial, 5, 0, "x", "", "", "")))
    return file


def test_a_counterexample_of_another_check_is_none_of_it(tmp_path: Path) -> None:
    """Whoever handed the folder in may have put it there; the next place has the real one."""
    check = "hits.closest-wins"
    written(tmp_path / "ada", check, "bvh.boxes-are-tight")
    real = written(tmp_path / "bvhgrade-out", check, check)
    subject = wanted(replace(of_check(tmp_path, check), path=tmp_path / "ada"))()
    assert subject.check == check
    assert str(real) in subject.origin


def test_a_counterexample_that_lies_there_is_named(tmp_path: Path) -> None:
    """With its date: it may be somebody else's, and old."""
    check = "hits.closest-wins"
    file = written(tmp_path / "bvhgrade-out", check, check)
    noon = datetime(2026, 2, 3, 12, 0).timestamp()
    os.utime(file, (noon, noon))
    subject = wanted(of_check(tmp_path, check))()
    assert subject.check == check
    assert str(file) in subject.origin
    assert "2026-02-03 12:00" in subject.origin
    assert not wanted(of_check(tmp_path, str(file)))().origin


PASSING = samples.check(1)


@pytest.mark.parametrize(
    ("score", "told"),
    [
        (PASSING, "it passes, so there is no input that fails it"),
        (
            replace(PASSING, verdict=Verdict.FAIL, message="too\nslow"),
            r"it fails, but no small input was found: too slow",
        ),
        (samples.uncompiled().checks[1], "it is not decided, because build.compiles fails"),
        (replace(PASSING, verdict=Verdict.BROKEN, message="full"), "it is not decided: full"),
    ],
    ids=["passes", "large", "blocked", "broken"],
)
def test_why_there_is_nothing_to_show_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, score: CheckScore, told: str
) -> None:
    """A file that does not compile fails no check, but it does not pass one either."""
    found = samples.graded([samples.check(0), score])
    monkeypatch.setattr(pipeline, "grade_one", lambda *_: found)
    with pytest.raises(UsageError, match=told):
        wanted(of_check(tmp_path, PASSING.check))()


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize("web", [True, False], ids=["web", "screenshot"])
def test_what_cannot_be_had_ends_the_viewer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, web: bool
) -> None:
    """Nobody is left with nothing to look at, and a status of 0."""

    def search(_: Wish, check: str) -> Subject:
        raise UsageError(f"{check}: there is no input that fails it")

    monkeypatch.setattr(opening_module, "_searched", search)
    monkeypatch.setattr(screenshot_module, "surfaceless", lambda: None)
    # A result of somebody's own may lie where the tests are started.
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "a.cpp"
    file.write_text(sources.given())
    picture = None if web else tmp_path / "a.png"
    with pytest.raises(UsageError, match="no input that fails it"):
        opening(of_check(tmp_path, "hits.closest-wins"), web, picture)
