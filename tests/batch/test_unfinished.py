"""A gradebook gets no points that a newer file of the student, or its store, knows better."""

import csv
from pathlib import Path

import pytest

from grader.batch.runner import Batch
from grader.cli.export import exported
from grader.errors import UsageError
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import job

ASKED = dict.fromkeys(("language", "grade_column", "feedback_column", "id_column"), "")
SHEET = "name,score\nada,\nbob,1\ncy,\ndan,\n"


def test_who_is_not_finished_is_left_out(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Bob's old points are not for his new file, and Cy handed something in."""
    out, sheet = tmp_path / "out", tmp_path / "sheet.csv"
    sheet.write_text(SHEET)
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "wrong"})
    grade(path, job(out))
    folder_of(tmp_path, "class", {"bob.cpp": "better", "cy.cpp": "c"})
    with monkeypatch.context() as patch:
        patch.setattr(Batch, "grade", lambda _: None)
        grade(path, job(out))
    early = exported("csv", out, sheet, ASKED)
    assert scores(early.data) == {"ada": "50", "bob": "1", "cy": "", "dan": ""}
    assert [row.rpartition(" ")[2] for row in early.empty] == ["dan"]
    assert early.problems == tuple(
        f"{name}: row {row} is left as it was: it is not finished: call `bvhgrade batch` again"
        for name, row in (("bob", 3), ("cy", 4))
    )
    plain = exported("csv", out, None, ASKED)
    assert (plain.rows, len(plain.problems)) == (1, 2)
    grade(path, job(out))
    late = exported("csv", out, sheet, ASKED)
    assert scores(late.data) == {"ada": "50", "bob": "50", "cy": "50", "dan": ""}
    assert not late.problems


def test_a_withheld_score_is_told_as_one(tmp_path: Path, log: Path) -> None:
    """Whatever lies in the folder: here the points of an older file."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    grade(path, job(tmp_path / "out"))
    assert points(tmp_path / "out") == {"ada": 50, "bob": 50}
    folder_of(tmp_path, "class", {"bob.cpp": "raise"})
    grade(path, job(tmp_path / "out"))
    made = exported("csv", tmp_path / "out", None, ASKED)
    assert made.problems == (
        "bob: left out, its points are withheld: call `bvhgrade batch` again",
    )


def test_who_left_a_class_has_no_points(tmp_path: Path, log: Path) -> None:
    """The store was removed and made anew without Bob, whose folder is still there."""
    out, sheet = tmp_path / "out", tmp_path / "sheet.csv"
    sheet.write_text(SHEET)
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    grade(path, job(out))
    (out / "batch.sqlite").unlink()
    (path / "bob.cpp").unlink()
    grade(path, job(out))
    made = exported("csv", out, sheet, ASKED)
    assert scores(made.data) == {"ada": "50", "bob": "1", "cy": "", "dan": ""}
    (told,) = made.problems
    assert told.startswith("students/bob: batch.sqlite knows no student of this folder")


def test_a_download_in_the_folder_of_its_results_is_no_obstacle(
    tmp_path: Path, log: Path
) -> None:
    """Everybody's points are in the file, and not those that somebody handed in."""
    out = tmp_path / "out"
    files = {"bob/exercise03.cpp": "b", "bob/bvhgrade-out/result.json": "{", "ada.zip": CODE}
    grade(folder_of(tmp_path, "out/download", files), job(out))
    made = exported("csv", out, None, ASKED)
    assert (made.filled, made.problems) == (2, ())


def test_the_folder_of_the_students_alone_is_refused(tmp_path: Path, log: Path) -> None:
    """Bob's file is a newer one, which only the store of the class knows."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    grade(path, job(tmp_path / "out"))
    folder_of(tmp_path, "class", {"bob.cpp": "raise"})
    grade(path, job(tmp_path / "out"))
    with pytest.raises(UsageError, match=r"name the folder of the class, .*out$"):
        exported("csv", tmp_path / "out/students", None, ASKED)


def scores(data: bytes) -> dict[str, str]:
    """Read what a teacher's file holds."""
    return {row["name"]: row["score"] for row in csv.DictReader(data.decode().splitlines())}
