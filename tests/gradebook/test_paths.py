"""Results are looked for where the grader wrote them, and nowhere else."""

import json
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.paths import result_paths, strays_in
from grader.gradebook.results import results_in
from tests.cli.calls import call
from tests.gradebook.folders import write_batch, write_class
from tests.report import real

DOWNLOADS = ["download.zip", "download/eve/exercise03.cpp", "download/bob/work.zip", "eve.cpp"]


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """A class, and beside the students' folders the download, with a result that Eve forged."""
    write_batch(tmp_path, "plain", {"ada": ("ada", "", "")})
    for name in DOWNLOADS:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    for name in ("download/eve", "download/eve/ada"):
        write_class(tmp_path, {f"{name}/bvhgrade-out": "right"})
    return tmp_path


def test_a_download_may_lie_beside_the_results(home: Path) -> None:
    """Nothing in it is a result, nor worth a word."""
    assert result_paths(home) == [home / "students/ada/result.json"]
    assert [(one.student, one.why) for one in results_in(home)] == [("ada", "")]


def test_reports_are_those_of_the_class(home: Path) -> None:
    """Only of the student whom its store knows, whatever Eve wrote."""
    done = call("report", str(home))
    assert done.exit_code == 0
    assert "the reports of 1 submissions" in done.stdout
    assert not list((home / "download").rglob("*.html"))


def test_what_somebody_graded_beside_the_students_is_told(home: Path) -> None:
    """It may be a result that somebody waits for."""
    result = json.dumps(real.real("right"))
    (home / "result.json").write_text(result)
    write_class(home, {"again/bob": "right"})
    (home / "link").symlink_to(home / "again")
    strays = [home / "again/bob/result.json", home / "result.json"]
    assert list(strays_in(home)) == strays
    assert [one.student for one in results_in(home) if one.why] == ["again/bob", "."]


def test_a_submission_among_the_students_folders_is_refused(home: Path) -> None:
    """With it could have come any result."""
    (home / "students/ada/exercise03.cpp").touch()
    with pytest.raises(UsageError, match="apart from the submissions"):
        results_in(home)


def test_a_class_of_which_nothing_is_written_has_no_result(home: Path) -> None:
    """Whatever its download holds."""
    (home / "students").rename(home / "elsewhere")
    with pytest.raises(UsageError, match=r"no result\.json below it"):
        result_paths(home)
