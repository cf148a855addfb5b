"""What protects a Moodle's grades is found in its language, or said to be missing."""

from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.columns import Asked
from grader.gradebook.results import results_in
from tests.gradebook import rules, sheets
from tests.gradebook.folders import CLASS, write_class
from tests.gradebook.test_fill import a_class, fill

SHEETS = {"fr": sheets.FRENCH, "es": sheets.SPANISH, "it": sheets.ITALIAN}


@pytest.mark.parametrize("language", SHEETS)
def test_a_worksheet_is_understood(tmp_path: Path, language: str) -> None:
    """No option is needed; Ada's row is locked, and numbers have a comma."""
    given = results_in(write_class(tmp_path, CLASS))
    made = fill(SHEETS[language], "moodle", given)
    taken = rules.moodle_worksheet(made.data, language)
    assert {who: points for who, (points, _) in taken.items()} == {102: 38.25}
    assert "closest hit" in taken[102][1]
    (locked,) = (one for one in made.problems if "Ada" in one)
    assert "row 3 is left as it was: its grade cannot be changed there" in locked
    assert not any(one.startswith("row 1") for one in made.problems)


@pytest.mark.parametrize("language", SHEETS)
def test_another_maximum_is_refused(language: str) -> None:
    """Points out of 50 would be half of what they were."""
    text = SHEETS[language].replace("50,00", "100,00")
    with pytest.raises(UsageError, match="out of 100 points, but results are out of 50"):
        fill(text, "moodle", a_class(**{"grace@uni.example": "right"}))


def test_what_is_not_found_in_another_language_is_told() -> None:
    """The file is filled, since the columns were named, and is to be looked at."""
    given = a_class(**{"Grace Hopper_102_assignsubmission_file": "right"})
    asked = Asked(grade="Cijfer", id="Identificatie")
    made = fill(sheets.DUTCH, "moodle", given, asked)
    assert made.filled == 1
    feedback, maximum, changeable = made.problems
    assert "'Maximumcijfer'" in feedback
    assert feedback.endswith("for feedback, so nobody has any; name it with --feedback-column")
    assert "no known column of the maximum, so nothing was compared with it" in maximum
    assert "whether a grade can be changed, so locked rows may be filled" in changeable
    named = Asked(grade="Cijfer", id="Identificatie", feedback="Feedback opm")
    assert fill(sheets.DUTCH, "moodle", given, named).problems == (maximum, changeable)


def test_a_gradebook_has_neither_maximum_nor_locks() -> None:
    """So only its missing feedback is told."""
    text = "Email address,Exercise 3 (Real)\nada@uni.example,-\n"
    (told,) = fill(text, "moodle", a_class(**{"ada@uni.example": "right"})).problems
    assert "for feedback" in told


def test_a_list_of_one_s_own_needs_no_feedback() -> None:
    """A teacher knows what is in it."""
    assert not fill("email,score\nada,\n", "csv", a_class(ada="right")).problems
