"""What Moodle knows of a row decides whether it takes what a worksheet says.

Nothing in the file tells it, so these are the rows that docs/instructor.md warns of.
"""

from datetime import datetime, timedelta
from pathlib import Path

import pytest

from grader.gradebook.columns import Asked
from grader.gradebook.fill import filled
from grader.gradebook.results import results_in
from tests.gradebook import rules, sheets
from tests.gradebook.folders import CLASS, POINTS, write_class
from tests.gradebook.rules import Kept, Site

DOWNLOADED = datetime(2025, 1, 6, 8)
"""What the row of participant 102 says of its last grade."""


@pytest.fixture
def sheet(tmp_path: Path) -> bytes:
    """A worksheet with the points of everybody whose row is not locked."""
    results = results_in(write_class(tmp_path, CLASS))
    return filled(sheets.ENGLISH.encode(), "moodle", Asked(), results, str).data


ALL = {who for who in POINTS if who != 104}


def test_a_grade_that_was_changed_after_the_download_stays(sheet: bytes) -> None:
    """More than a minute later, unless the teacher ticks that it may be replaced."""
    for seconds, taken in ((0, ALL), (60, ALL), (61, ALL - {102})):
        kept = {102: Kept(7, DOWNLOADED + timedelta(seconds=seconds))}
        assert set(rules.moodle_worksheet(sheet, "en", site=Site(kept))) == taken
    ticked = rules.moodle_worksheet(sheet, "en", site=Site(kept, ignore_modified=True))
    assert ticked[102][0] == POINTS[102]


def test_a_site_in_another_language_takes_every_grade_for_changed(tmp_path: Path) -> None:
    """PHP does not read the date of its own worksheet, so the tick is needed."""
    german = sheets.GERMAN.replace("Ja;-;-;", "Ja;-;Montag, 6. Januar 2025, 08:00;", 1)
    results = results_in(write_class(tmp_path, CLASS))
    data = filled(german.encode(), "moodle", Asked(), results, str).data
    kept = {102: Kept(7, DOWNLOADED)}
    assert set(rules.moodle_worksheet(data, "de", ";", site=Site(kept))) == {101}
    again = rules.moodle_worksheet(data, "de", ";", site=Site(kept, ignore_modified=True))
    assert set(again) == {101, 102}


def test_a_grade_that_is_the_same_is_passed_over(sheet: bytes) -> None:
    """A second upload of a file counts nobody."""
    first = rules.moodle_worksheet(sheet, "en")
    kept = {who: Kept(points, DOWNLOADED) for who, (points, _) in first.items()}
    assert set(first) == ALL
    assert rules.moodle_worksheet(sheet, "en", site=Site(kept, ignore_modified=True)) == {}


def test_a_row_that_was_locked_after_the_download_stays(sheet: bytes) -> None:
    """Where the file says so, no points are written; where only Moodle knows, they are lost."""
    row = next(row for row in rules.read(sheet, ",") if row[0] == "Participant 104")
    assert row[4] == ""
    kept = {101: Kept(locked=True), 104: Kept(locked=True)}
    taken = rules.moodle_worksheet(sheet, "en", site=Site(kept, ignore_modified=True))
    assert set(taken) == ALL - {101}
