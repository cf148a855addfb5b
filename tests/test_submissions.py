"""Right submissions earn everything, wrong ones lose what their mistake touches, no more."""

from pathlib import Path

import pytest

from grader.certify.corpus import (
    Wrong,
    digest_of,
    name_of,
    right_submissions,
    wrong_submissions,
)
from grader.certify.matrix import SEED, line_of, stored_lines
from grader.certify.row import graded_row
from grader.score.rubric import load_rubric

FULL = "25"
WRONG = wrong_submissions()


def killers() -> list[Wrong]:
    """For each check the first wrong submission that only this check sees.

    Grading the whole corpus takes half an hour; `bvhgrade certify` does.
    """
    lines = stored_lines()
    chosen: dict[str, Wrong] = {}
    for wrong in WRONG:
        line = lines.get(name_of(wrong.path), {})
        failed = [check for check, letter in line.items() if letter == "F"]
        if failed == [wrong.checks[0]]:
            chosen.setdefault(wrong.checks[0], wrong)
    return list(chosen.values())


@pytest.mark.parametrize("path", right_submissions(), ids=lambda path: path.stem)
def test_a_right_submission_earns_everything(path: Path) -> None:
    """50 of 50, whatever allowed reading of the sheet it takes; and the matrix says so."""
    graded = graded_row(path, SEED)
    assert sum(graded.scores) == 50, sorted(graded.failed)
    assert line_of(graded) == stored_lines()[name_of(path)]


@pytest.mark.parametrize("wrong", killers(), ids=lambda wrong: wrong.path.stem)
def test_a_wrong_submission_is_seen_as_the_matrix_says(wrong: Wrong) -> None:
    """The same checks fail, the same points are lost."""
    assert line_of(graded_row(wrong.path, SEED)) == stored_lines()[name_of(wrong.path)]


def test_the_matrix_is_of_these_files() -> None:
    """Whoever edits a submission writes the matrix anew."""
    paths = [*right_submissions(), *(wrong.path for wrong in WRONG)]
    stored = {name: line["sha256"] for name, line in stored_lines().items()}
    assert stored == {name_of(path): digest_of(path) for path in paths}


def test_every_check_has_a_killer() -> None:
    """For each check there is a mistake that it owns, and for most one that only it sees."""
    owned = {wrong.checks[0] for wrong in WRONG}
    assert owned == {criterion.check for criterion in load_rubric(None).criteria}


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: wrong.path.stem)
def test_the_matrix_keeps_what_the_file_promises(wrong: Wrong) -> None:
    """The named checks fail, points are lost, the untouched part keeps all of its own."""
    line = stored_lines()[name_of(wrong.path)]
    assert [line[check] for check in wrong.checks] == ["F"] * len(wrong.checks)
    assert float(line["a"]) + float(line["b"]) < 50
    if wrong.untouched != "-":
        assert line[wrong.untouched] == FULL
    assert "!" not in line.values()


def test_there_are_enough_of_them() -> None:
    """At least 15 right ones and 50 wrong ones."""
    assert len(right_submissions()) >= 15
    assert len(WRONG) >= 50
