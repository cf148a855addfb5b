"""Lists that need no file of a teacher: what may be made, and what has to be downloaded."""

from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.results import Marked, ids_of, results_in
from grader.gradebook.scratch import made
from tests.gradebook import rules
from tests.gradebook.folders import write_batch, write_class
from tests.report import real

USERS = {"ada@uni.example": "right", "bob@uni.example": "first-hit-wins"}


def a_class(students: dict[str, str]) -> list[Marked]:
    """Name students by their folders, and what became of them."""
    results = real.every_result()
    return [Marked(name, ids_of(name), results[ending]) for name, ending in students.items()]


def test_moodle_imports_points_and_feedback_together() -> None:
    """Feedback alone would take the points away; and a withheld score is left out and told."""
    list_made = made("moodle", a_class({**USERS, "eve@uni.example": "withheld"}), str)
    columns = ("Email address", "Exercise 3 BVH", "Exercise 3 BVH (feedback)")
    taken = rules.moodle_gradebook(list_made.data, set(USERS), columns)
    assert {who: points for who, (points, _) in taken.items()} == {
        "ada@uni.example": 50,
        "bob@uni.example": 38.25,
    }
    assert "38.25 of 50" in taken["bob@uni.example"][1]
    assert list_made.problems == (
        "eve@uni.example: left out, the score is withheld since the grader itself failed",
    )


def test_the_stand_in_for_moodle_aborts() -> None:
    """Otherwise the test above would be worth nothing."""
    columns = ("Username", "x", "x (feedback)")
    for row in ("eve,1,", "ada,one,", "ada,101,"):
        with pytest.raises(rules.ImportAbortedError):
            rules.moodle_gradebook(
                f"Username,x,x (feedback)\n{row}\n".encode(), {"ada"}, columns
            )


def test_logins_are_called_so() -> None:
    """Moodle is told by a person what the first column is."""
    assert made("moodle", a_class({"ada": "right"}), str).data.startswith(b"Username,")


@pytest.mark.parametrize(
    ("host", "students", "said"),
    [
        ("canvas", {"ada": "right"}, 'Export Entire Gradebook" with --worksheet'),
        ("moodle", {"Ada_1_assignsubmission_file": "right"}, "Download grading worksheet"),
        (
            "csv",
            {"adal_9001_55_x": "right"},
            "neither login nor.*a list of your own with --work",
        ),
        ("moodle", {"ada@uni.example": "right", "bob": "right"}, "bob is no address"),
    ],
)
def test_what_has_to_be_downloaded_is_told(
    host: str, students: dict[str, str], said: str
) -> None:
    """One unknown user would abort Moodle's whole import."""
    with pytest.raises(UsageError, match=said):
        made(host, a_class(students), str)


@pytest.mark.parametrize("host", ["moodle", "csv"])
def test_a_batch_s_folders_are_no_user_names(tmp_path: Path, host: str) -> None:
    """They are names that were made safe; who it is stands beside the result."""
    students = {
        "ada-l-777": ("Ada L", "777", "ada@uni.example"),
        "bob-b": ("Bob B", "", "bob@uni.example"),
    }
    written = write_batch(tmp_path / "gradescope", "Gradescope", students)
    rows = rules.read(made(host, results_in(written), str).data, ",")
    assert [row[0] for row in rows[1:]] == ["ada@uni.example", "bob@uni.example"]
    written = write_batch(tmp_path / "plain", "plain", {"jorg-m": ("jörg.m", "", "")})
    assert rules.read(made(host, results_in(written), str).data, ",")[1][0] == "jörg.m"
    written = write_batch(tmp_path / "moodle", "Moodle", {"ada-l-101": ("Ada L", "101", "")})
    with pytest.raises(UsageError, match=r"ada-l-101: neither login nor address.*--worksheet"):
        made(host, results_in(written), str)


def test_a_plain_list_has_every_student() -> None:
    """A withheld score is an empty cell, and 0 is 0."""
    list_made = made("csv", a_class({**USERS, "eve": "withheld", "zoe": "rejected"}), str)
    header, *rows = rules.read(list_made.data, ",")
    told = {row[0]: dict(zip(header, row, strict=True)) for row in rows}
    assert told["bob@uni.example"]["score"] == "38.25"
    assert told["bob@uni.example"]["part a"] == "25"
    assert (told["eve"]["score"], told["eve"]["needs_review"]) == ("", "yes")
    assert (told["eve"]["part a"], told["eve"]["part b"]) == ("25", "")
    assert (told["zoe"]["score"], told["zoe"]["needs_review"]) == ("0", "no")
    assert list_made.filled == 4


@pytest.mark.parametrize("host", ["moodle", "csv"])
def test_a_student_with_two_results_is_left_out(host: str) -> None:
    """Nobody can know which of them counts."""
    list_made = made(host, a_class({"ada": "right"}) * 2 + a_class({"bob": "right"}), str)
    assert len(rules.read(list_made.data, ",")) == 2
    assert list_made.problems == ("ada: several results, none is taken",)


@pytest.mark.parametrize("host", ["moodle", "csv"])
def test_a_folder_that_is_nobody_s_is_left_out(tmp_path: Path, host: str) -> None:
    """And told; it is the old one of somebody who is in the list with another."""
    write_batch(tmp_path, "plain", {"ada": ("ada", "", "")})
    write_class(tmp_path / "students", {"ada-1f2e3d": "first-hit-wins"})
    list_made = made(host, results_in(tmp_path), str)
    assert [row[:2] for row in rules.read(list_made.data, ",")[1:]] == [["ada", "50"]]
    (told,) = list_made.problems
    assert told.startswith("students/ada-1f2e3d: left out, batch.sqlite knows no student")


def test_the_name_of_a_folder_is_no_formula() -> None:
    """Whoever unpacked the submissions may have taken it from a student."""
    list_made = made("csv", a_class({"=1+1": "right"}), str)
    assert rules.read(list_made.data, ",")[1][0] == "'=1+1"
