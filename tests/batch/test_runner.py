"""A class is graded whatever happens to one submission, and nothing is graded twice."""

import csv
import os
import shutil
from errno import EACCES
from pathlib import Path

import pytest

from grader.batch.runner import Batch
from grader.batch.store import Store
from grader.errors import OutputFault
from grader.intake.handed_in import handed_in
from grader.kept import Result
from grader.report.as_json import to_text
from tests.batch.classes import CODE, folder_of, grade, points, results, zip_of
from tests.batch.stand_in import TRACEBACK, begun, job
from tests.report import samples

TEXT = to_text(samples.perfect())


def test_every_submission_gets_its_result(tmp_path: Path, log: Path) -> None:
    """Right, wrong and refused ones; each in its own folder and in the table."""
    path = folder_of(
        tmp_path, "class", {"ada.cpp": CODE, "bob/exercise03.cpp": "wrong", "cy.cpp": " "}
    )
    totals, seen = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld, totals.waiting) == (3, 0, 0)
    found = points(tmp_path / "out")
    assert list(found) == ["ada", "bob", "cy"]
    assert found["ada"] == 50
    assert found["bob"] not in (0, 50, None)
    assert found["cy"] == 0
    assert seen.stages == {"[red]tracing[/red]"}
    assert not seen.troubles


def test_the_table_has_a_row_for_each(tmp_path: Path, log: Path) -> None:
    """Excel reads it: a mark of UTF-8, and points that are numbers."""
    path = folder_of(tmp_path, "class", {"ädä.cpp": CODE, "bob.cpp": "raise"})
    grade(path, job(tmp_path / "out"))
    text = (tmp_path / "out/class.csv").read_bytes()
    assert text.startswith(b"\xef\xbb\xbf")
    ada, bob = csv.DictReader(text.decode("utf-8-sig").splitlines())
    assert (ada["name"], ada["folder"], ada["score"]) == ("ädä", "students/ada", "50")
    assert (bob["score"], bob["needs_review"]) == ("", "yes")
    assert "file descriptors" in bob["note"]


def test_a_name_is_no_formula(tmp_path: Path, log: Path) -> None:
    """A spreadsheet would compute it."""
    path = folder_of(tmp_path, "class", {"=1+1.cpp": CODE})
    grade(path, job(tmp_path / "out"))
    (row,) = csv.DictReader((tmp_path / "out/class.csv").read_text("utf-8-sig").splitlines())
    assert row["name"] == "'=1+1"


def test_the_same_bytes_are_graded_once(tmp_path: Path, log: Path) -> None:
    """Each who handed them in has the result under the own name, in a later run too."""
    given = {"ada.cpp": CODE, "bob/exercise03.cpp": CODE}
    path = folder_of(tmp_path, "class", given)
    grade(path, job(tmp_path / "out"))
    folder_of(
        tmp_path,
        "class",
        {"cy.zip": zip_of(tmp_path, "z", {"exercise03.cpp": CODE}).read_bytes()},
    )
    grade(path, job(tmp_path / "out"))
    assert begun(log) == [CODE.strip()]
    names = [one["submission"]["name"] for one in results(tmp_path / "out").values()]
    assert names == ["ada", "bob", "cy"]


def test_a_withheld_score_is_tried_again(tmp_path: Path, log: Path) -> None:
    """By the same command: the grader failed, so nothing was concluded."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "withheld once", "bob.cpp": CODE})
    totals, _ = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld) == (1, 1)
    assert points(tmp_path / "out") == {"ada": None, "bob": 50}
    totals, _ = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld) == (2, 0)
    assert points(tmp_path / "out") == {"ada": 50, "bob": 50}
    assert begun(log).count(CODE.strip()) == 1


def test_a_changed_file_is_graded_again(tmp_path: Path, log: Path) -> None:
    """A second download, with a newer file of somebody."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "wrong", "bob.cpp": CODE})
    grade(path, job(tmp_path / "out"))
    folder_of(tmp_path, "class", {"ada.cpp": "better"})
    grade(path, job(tmp_path / "out"))
    assert begun(log).count("better") == 1
    assert points(tmp_path / "out") == {"ada": 50, "bob": 50}


@pytest.mark.parametrize("text", ["die", "raise"])
def test_our_own_fault_is_never_0_points(tmp_path: Path, log: Path, text: str) -> None:
    """A dead clerk costs its submission, after a second try; a person has to look."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": text, "cy.cpp": "other"})
    totals, seen = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld) == (2, 1)
    assert points(tmp_path / "out") == {"ada": 50, "bob": None, "cy": 50}
    bob = results(tmp_path / "out")["bob"]
    assert bob["needs_review"] is True
    assert {one["verdict"] for one in bob["checks"]} == {"broken"}
    assert begun(log).count(text) == (2 if text == "die" else 1)
    (said,) = seen.troubles
    assert said.startswith("bob: ")


@pytest.mark.parametrize("text", ["die aloud", "stumble", "broken"])
def test_a_traceback_of_ours_is_in_a_file_that_is_named(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    """For a maintainer; nothing that a student or a teacher may open holds it."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    totals, seen = grade(folder_of(tmp_path, "class", {"bob.cpp": text}), job(tmp_path / "out"))
    assert totals.withheld == 1
    (noted,) = (tmp_path / "cache" / "faults").iterdir()
    assert noted.read_text() == TRACEBACK
    (said,) = seen.troubles
    assert said.startswith("bob: ")
    assert said.endswith(f". What a maintainer needs is in {noted}")
    for written in (tmp_path / "out").rglob("*"):
        assert written.is_dir() or TRACEBACK.encode() not in written.read_bytes()


def test_a_clerk_may_die_once(tmp_path: Path, log: Path) -> None:
    """The second one does what the first one began."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "die once", "bob.cpp": CODE})
    totals, seen = grade(path, job(tmp_path / "out", clerks=1))
    assert (totals.graded, totals.withheld) == (2, 0)
    assert not seen.troubles


def test_what_we_failed_at_is_tried_by_the_next_run(tmp_path: Path, log: Path) -> None:
    """The cause may be gone by then."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "raise"})
    for _ in range(2):
        totals, _ = grade(path, job(tmp_path / "out"))
    assert totals.withheld == 1
    assert begun(log) == ["raise", "raise"]


def test_a_deleted_file_stops_nobody(tmp_path: Path, log: Path) -> None:
    """Gone after it was graded: the result stays. A pipe in its place is the student's own."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    out = job(tmp_path / "out")
    grade(path, out)
    (path / "ada.cpp").unlink()
    (path / "bob.cpp").unlink()
    os.mkfifo(path / "bob.cpp")
    folder_of(tmp_path, "class", {"cy.cpp": "c"})
    totals, seen = grade(path, out)
    assert (totals.graded, totals.withheld) == (3, 0)
    assert points(tmp_path / "out") == {"ada": 50, "bob": 0, "cy": 50}
    assert "a pipe" in str(results(tmp_path / "out")["bob"]["build"])
    assert not seen.troubles


def test_a_newer_file_that_cannot_be_read_is_told(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was graded before still counts, and somebody has to know that it does."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "wrong", "bob.cpp": CODE})
    out = job(tmp_path / "out")
    grade(path, out)
    before = points(tmp_path / "out")
    monkeypatch.setattr("grader.batch.runner.handed_in", unreadable)
    totals, seen = grade(path, out)
    assert totals.graded == 2
    assert points(tmp_path / "out") == before
    told = "it could not be read: Permission denied; the earlier file still counts"
    assert seen.troubles == [f"ada: {told}", f"bob: {told}"]


def unreadable(student: str, entries: object, limit: int) -> object:
    """Be a disk that somebody else's file lies on."""
    raise PermissionError(EACCES, "Permission denied")


def test_a_file_that_vanishes_is_withheld(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Listed, and not there when it is read."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    real = handed_in

    def late(student: str, entries: object, limit: int) -> object:
        if student == "ada":
            (path / "ada.cpp").unlink()
        return real(student, entries, limit)  # type: ignore[arg-type]  # passed on as it came

    monkeypatch.setattr("grader.batch.runner.handed_in", late)
    totals, _ = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld) == (1, 1)
    assert points(tmp_path / "out") == {"ada": None, "bob": 50}


def test_a_result_that_cannot_be_stored_is_told(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A full disk loses this one; the others go on, and the next run grades it."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    real = Store.keep

    def full(self: Store, sha256: str, settings: object, result: Result) -> None:
        if '"ada"' in result.text:
            raise OutputFault("database or disk is full")
        real(self, sha256, settings, result)  # type: ignore[arg-type]  # passed on as it came

    with monkeypatch.context() as patch:
        patch.setattr(Store, "keep", full)
        totals, seen = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.waiting) == (1, 1)
    assert "disk is full" in seen.troubles[0]
    totals, _ = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.waiting) == (2, 0)


def test_a_folder_that_cannot_be_written_is_written_later(tmp_path: Path, log: Path) -> None:
    """A file lies where the folder belongs; the result is in the store."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    (tmp_path / "out/students").mkdir(parents=True)
    (tmp_path / "out/students/ada").write_text("in the way")
    _, seen = grade(path, job(tmp_path / "out"))
    assert "ada" in seen.troubles[0]
    assert points(tmp_path / "out") == {"bob": 50}
    (tmp_path / "out/students/ada").unlink()
    _, seen = grade(path, job(tmp_path / "out"))
    assert not seen.troubles
    assert points(tmp_path / "out") == {"ada": 50, "bob": 50}
    assert sorted(begun(log)) == ["b", CODE.strip()]


def test_an_end_between_a_result_and_its_folder_costs_nothing(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was withheld is graded at last, and the process is killed before it is written."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "withheld once"})
    grade(path, job(tmp_path / "out"))

    def killed(self: Batch, students: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(Batch, "_write", killed)
        with pytest.raises(KeyboardInterrupt):
            grade(path, job(tmp_path / "out"))
    assert points(tmp_path / "out") == {"ada": None}
    grade(path, job(tmp_path / "out"))
    assert points(tmp_path / "out") == {"ada": 50}
    assert len(begun(log)) == 2


def test_folders_that_are_gone_are_written_again(tmp_path: Path, log: Path) -> None:
    """`batch.sqlite` is what to back up: all the rest comes from it, without grading."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": " ", "cy.cpp": "c"})
    grade(path, job(tmp_path / "out"))
    (tmp_path / "out/students/cy/student.json").unlink()
    shutil.rmtree(tmp_path / "out/students/ada")
    shutil.rmtree(tmp_path / "out/students/bob")
    _, seen = grade(path, job(tmp_path / "out"))
    assert points(tmp_path / "out") == {"ada": 50, "bob": 0, "cy": 50}
    assert (tmp_path / "out/students/cy/student.json").exists()
    assert len(begun(log)) == 2
    assert not seen.troubles


def test_an_archive_that_breaks_its_reader_stops_nobody(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever a reader raises, it is one submission's."""
    real = handed_in

    def broken(student: str, entries: object, limit: int) -> object:
        if student == "ada":
            raise RecursionError("an archive [in an archive]")
        return real(student, entries, limit)  # type: ignore[arg-type]  # passed on as it came

    monkeypatch.setattr("grader.batch.runner.handed_in", broken)
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    totals, _ = grade(path, job(tmp_path / "out"))
    assert (totals.graded, totals.withheld) == (1, 1)
