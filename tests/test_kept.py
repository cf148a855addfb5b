"""What is kept of a grade leaves the same files whenever it is written."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from grader.errors import OutputFault, UsageError
from grader.kept import Result, kept, write_result
from grader.output import ready
from tests.gallery.shown import some_views
from tests.report import samples
from tests.report.small_inputs import small


def failing() -> Result:
    """Keep a grade with a counterexample and with views."""
    grade = samples.failing()
    checks = tuple(
        replace(one, counterexample=small()) if one.check == small().check else one
        for one in grade.checks
    )
    return kept(replace(grade, checks=checks, views=some_views()))


def test_everything_is_written(tmp_path: Path) -> None:
    """The page is where it says, and the counterexample where the result says."""
    page = write_result(tmp_path, failing(), "en")
    assert page.read_text().startswith("<!doctype html>")
    told = json.loads((tmp_path / "result.json").read_text())
    named = [one["counterexample"]["file"] for one in told["checks"] if one["counterexample"]]
    assert named
    assert all(json.loads((tmp_path / name).read_text()) for name in named)
    assert json.loads((tmp_path / "views.json").read_text())["schema"] == 1


def breaks(_: object) -> str:
    """Fail for our own reason.

    Raises:
        TypeError: Always.
    """
    raise TypeError("float32 is not JSON serializable")


@pytest.mark.parametrize(
    ("writer", "lost"),
    [
        ("grader.counterexample.written.to_text", "counterexamples/"),
        ("grader.report.views.to_text", "views.json"),
    ],
)
@pytest.mark.usefixtures("forgiving")
def test_an_attachment_that_cannot_be_written_costs_itself(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, writer: str, lost: str
) -> None:
    """The result names no file that is not there, and a remark says why."""
    whole = dict(failing().attachments)
    monkeypatch.setattr(writer, breaks)
    result = failing()
    write_result(tmp_path, result, "en")
    left = {name: text for name, text in whole.items() if not name.startswith(lost)}
    assert dict(result.attachments) == left != whole
    told = json.loads(result.text)
    files = [one["counterexample"]["file"] for one in told["checks"] if one["counterexample"]]
    assert all((tmp_path / name).exists() for name in files)
    remark = told["build"]["diagnostics"][-1]["text"]
    assert remark.startswith(lost)
    assert "is missing, which is our own fault (TypeError)" in remark


def test_what_belongs_to_an_earlier_result_is_removed(tmp_path: Path) -> None:
    """And nothing else: whoever copied a counterexample keeps the copy."""
    write_result(tmp_path, failing(), "en")
    own = tmp_path / "counterexamples" / "my-copy.json"
    own.write_text("{}")
    write_result(tmp_path, kept(samples.perfect()), "en")
    assert [each.name for each in own.parent.iterdir()] == [own.name]
    assert not (tmp_path / "views.json").exists()


def test_a_file_in_the_way_is_named(tmp_path: Path) -> None:
    """Without an example to write nobody minds it."""
    (tmp_path / "counterexamples").write_text("notes")
    write_result(tmp_path, kept(samples.perfect()), "en")
    with pytest.raises((UsageError, OutputFault), match="counterexamples"):
        write_result(tmp_path, failing(), "en")


@pytest.mark.parametrize("link", ["mine", "mine/counterexamples"])
def test_nothing_is_written_or_removed_through_a_link(tmp_path: Path, link: str) -> None:
    """A submission may bring one into the folder of somebody else."""
    other = tmp_path / link.replace("mine", "other")
    other.mkdir(parents=True)
    write_result(tmp_path / "other", failing(), "en")
    before = {path: path.read_bytes() for path in other.rglob("*.json")}
    (tmp_path / link).parent.mkdir(exist_ok=True)
    (tmp_path / link).symlink_to(other)
    for result in (kept(samples.perfect()), failing()):
        with pytest.raises(UsageError, match=r"is a link.*nothing is written through it"):
            write_result(tmp_path / "mine", result, "en")
    assert before == {path: path.read_bytes() for path in other.rglob("*.json")}


@pytest.mark.parametrize(
    ("output", "submission", "refused"),
    [
        ("class/mal/bvhgrade-out", None, True),
        ("class/mal/bvhgrade-out", "class/mal", True),
        ("class/mal/link/out", "class/mal", True),
        ("class/mal/link/out", "class/mal/exercise03.cpp", True),
        ("class/mal/out", "class/mal", False),
        ("results/mal", "class/mal", True),
        ("own/class/mal/out", "own/class/mal", False),
        ("out", None, False),
    ],
)
def test_a_folder_behind_a_link_is_found_before_grading(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    output: str,
    submission: str | None,
    refused: bool,
) -> None:
    """Unless the user's own way to the submission leads through that link, too."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "class/mal").mkdir(parents=True)
    (tmp_path / "bob").mkdir()
    (tmp_path / "own").symlink_to(tmp_path)
    for link in ("class/mal/bvhgrade-out", "class/mal/link", "results"):
        (tmp_path / link).symlink_to(tmp_path / "bob")
    for here in (Path(), tmp_path):
        graded = None if submission is None else here / submission
        if not refused:
            assert ready(here / output, submission=graded).is_dir()
            continue
        with pytest.raises(UsageError, match="is a link"):
            ready(here / output, submission=graded)
    assert list((tmp_path / "bob").iterdir()) == []


def test_links_of_the_system_are_no_submission_s(tmp_path: Path) -> None:
    """Where nothing but the root holds both, the folders above are the user's own."""
    (tmp_path / "link").symlink_to(tmp_path)
    far = Path("/elsewhere/submission")
    assert ready(tmp_path / "link" / "out", submission=far).is_dir()


def test_a_link_does_not_say_who_may_write_a_result(tmp_path: Path) -> None:
    """It is replaced, and what it leads to stays as it is and counts for nothing."""
    (tmp_path / "everybody's").touch(0o666)
    (tmp_path / "everybody's").chmod(0o666)
    (tmp_path / "result.json").symlink_to(tmp_path / "everybody's")
    write_result(tmp_path, kept(samples.perfect()), "en")
    assert not (tmp_path / "result.json").is_symlink()
    assert not (tmp_path / "result.json").stat().st_mode & 0o022
    assert (tmp_path / "everybody's").read_bytes() == b""
