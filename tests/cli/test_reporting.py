"""`bvhgrade report` makes the same pages from what is stored, and refuses what is damaged."""

import json
import shutil
from pathlib import Path

import pytest

from grader.report.as_json import to_text
from grader.report.views import to_text as views_text
from tests.cli.calls import call
from tests.gallery.shown import some_views
from tests.report import samples


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Store a result with views."""
    (tmp_path / "result.json").write_text(to_text(samples.failing()))
    (tmp_path / "views.json").write_text(views_text(some_views()))
    return tmp_path


def test_a_page_is_written_anew_the_same_each_time(folder: Path) -> None:
    """And says what the result says."""
    assert call("report", str(folder)).exit_code == 0
    first = (folder / "report.html").read_bytes()
    (folder / "report.html").unlink()
    result = call("report", str(folder))
    assert "report.html" in result.stdout
    assert (folder / "report.html").read_bytes() == first
    assert b"bvh.boxes-are-tight" in first
    assert b"s0427" in first
    assert not (folder / "class.html").exists()


def test_a_page_without_views_is_a_page(folder: Path) -> None:
    """As of a file that does not compile."""
    with_views = len(read(folder))
    (folder / "views.json").unlink()
    assert 1_000 < len(read(folder)) < with_views


def read(folder: Path) -> bytes:
    """Write the page of a folder and read it."""
    assert call("report", str(folder)).exit_code == 0
    return (folder / "report.html").read_bytes()


def test_several_students_get_a_page_of_the_class(folder: Path, tmp_path: Path) -> None:
    """With a link to each report, and every report is there."""
    group = tmp_path / "group"
    for name in ("ada", "bob"):
        shutil.copytree(folder, group / name, ignore=lambda *_: ["group"])
    result = call("report", str(group), "--language", "de")
    assert result.exit_code == 0
    assert "2 submissions" in result.stdout
    page = (group / "class.html").read_text()
    for name in ("ada", "bob"):
        assert f'href="{name}/report.html"' in page
        assert (group / name / "report.html").is_file()
    assert 'lang="de"' in page


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("result.json", "{", "it is not JSON"),
        ("result.json", '{"schema": 2}', "schema is 2, but 1 is read here"),
        ("result.json", '{"schema": 1}', "is not as `bvhgrade schema` says"),
        ("views.json", '{"schema": 7}', "schema is 7, but 1 is read here"),
        ("views.json", "[NaN]", "NaN is no number"),
    ],
)
def test_what_is_damaged_is_named(folder: Path, name: str, content: str, reason: str) -> None:
    """With the file, the fault and what to do; no page is written."""
    (folder / name).write_text(content)
    result = call("report", str(folder))
    assert result.exit_code == 2
    assert name in result.stderr
    assert reason in result.stderr
    assert "Traceback" not in result.stderr
    assert not (folder / "report.html").exists()


def test_a_folder_without_results_is_named(tmp_path: Path) -> None:
    """Nothing is written into it."""
    result = call("report", str(tmp_path))
    assert result.exit_code == 2
    assert "no result.json below it" in result.stderr
    assert not list(tmp_path.iterdir())


def test_views_may_lack_what_a_submission_did_not_bring(folder: Path) -> None:
    """A scene that was not drawn is shown as Mitsuba renders it."""
    views = json.loads((folder / "views.json").read_text())
    for picture in views["pictures"]:
        picture["images"] = {"reference": picture["images"]["reference"]}
        for key in ("wrong", "first_wrong", "flip", "cost_scale", "cost_mean"):
            del picture[key]
    (folder / "views.json").write_text(json.dumps(views))
    assert b"wall" in read(folder)
