"""What is kept of a grade leaves the same files whenever it is written."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from grader.errors import OutputFault, UsageError
from grader.kept import Result, kept, write_result
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
