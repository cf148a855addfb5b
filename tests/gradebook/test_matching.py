"""Whose row is it? The strongest name that a platform told decides, and nothing else."""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.columns import Asked
from grader.gradebook.results import results_in
from tests.gradebook import rules, sheets
from tests.gradebook.folders import CLASS, write_batch, write_class
from tests.gradebook.test_fill import a_class, fill


def test_a_batch_s_namesake_gets_no_points(tmp_path: Path) -> None:
    """The class was graded by `batch`, which says whose a folder is in a file of its own."""
    students = {"ada": ("Ada Lovelace", "555", ""), "jm": ("Jörg Müller", "103", "")}
    given = results_in(write_batch(tmp_path, "Moodle", students))
    made = fill(sheets.ENGLISH, "moodle", given)
    assert rules.moodle_worksheet(made.data, "en").keys() == {103}
    assert made.problems == ("ada: no row has this student",)


@pytest.mark.parametrize(("layout", "host"), [("Moodle", "moodle"), ("Canvas", "canvas")])
def test_a_platform_s_number_is_nobody_s_account(
    tmp_path: Path, layout: str, host: str
) -> None:
    """Somebody else's ID number, or SIS user ID, may be the same."""
    text = {
        "moodle": sheets.GRADEBOOK.replace(",u1,", ",777,"),
        "canvas": sheets.CANVAS.replace(",u1,", ",777,"),
    }[host]
    given = results_in(write_batch(tmp_path, layout, {"bob": ("Bob B", "777", "")}))
    asked = Asked(grade="Exercise 3 BVH" if host == "canvas" else "")
    with pytest.raises(UsageError, match="bob: no row has this student"):
        fill(text, host, given, asked)
    named = replace(asked, id="ID number" if host == "moodle" else "SIS User ID")
    with pytest.raises(UsageError, match="bob: no row has this student"):
        fill(text, host, given, named)


def test_gradescope_tells_number_and_address(tmp_path: Path) -> None:
    """A file may have either; if they are in two rows, or in none, no row is filled."""
    students = {
        "ada": ("Ada Lovelace", "777", "ada@uni.example"),
        "bob": ("Bob B", "778", "bob@uni.example"),
        "cy": ("Cy", "779", "cy@uni.example"),
    }
    given = results_in(write_batch(tmp_path, "Gradescope", students))
    text = "email,score\nbob@uni.example,\nada@uni.example,\n"
    assert fill(text, "csv", given).data.endswith(b"bob@uni.example,50\nada@uni.example,50\n")
    text = "id,email,name,score\n777,,,\n778,x,,\n,bob@uni.example,,\n1,y,Cy,\n"
    made = fill(text, "csv", given)
    assert made.data.endswith(b"\n777,,,50\n778,x,,\n,bob@uni.example,,\n1,y,Cy,\n")
    assert made.problems == (
        "bob: rows 3, 4 may all be meant",
        "cy: no row has this student",
    )


def test_a_number_stands_where_the_host_writes_it_in_any_language(tmp_path: Path) -> None:
    """A Dutch header says nothing here, but who names the column means what is in it."""
    whole_class = results_in(write_class(tmp_path, CLASS))
    text = sheets.ENGLISH.replace("Identifier", "Identificatie").replace("Full name", "Naam")
    asked = Asked(id="Identificatie")
    assert fill(text, "moodle", whole_class, asked).filled == 4
    assert fill(text, "moodle", whole_class, replace(asked, id="Naam")).filled == 2
    text = sheets.CANVAS.replace("Student,ID,", "Étudiant,Numéro,")
    given = a_class(lovelaceada_9001_55_x="right")
    asked = Asked(grade="Exercise 3 BVH", id="Numéro")
    assert fill(text, "canvas", given, asked).filled == 1


def test_everybody_is_told_if_nobody_is_in_a_file() -> None:
    """The first one may be the only one who is rightly missing."""
    with pytest.raises(UsageError, match="bob: no row has this student\neve: no row"):
        fill("email,score\nada,\n", "csv", a_class(bob="right", eve="right"))


def test_an_old_folder_does_not_stand_in_its_student_s_way(tmp_path: Path) -> None:
    """It would be a second result for the row; nobody's it is, and told."""
    written = write_batch(tmp_path, "Moodle", {"jm": ("Jörg Müller", "103", "")})
    write_class(tmp_path / "students", {"Jörg Müller_103_assignsubmission_file": "rejected"})
    made = fill(sheets.ENGLISH, "moodle", results_in(written))
    assert rules.moodle_worksheet(made.data, "en")[103][0] == 50
    (told,) = made.problems
    assert told.startswith("students/Jörg Müller_103_assignsubmission_file: batch.sqlite knows")
