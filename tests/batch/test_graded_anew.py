"""Who cannot be graded anew: nobody loses points, and nobody keeps others waiting."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from errno import EACCES
from pathlib import Path

import pytest

from grader.batch.store import opened_store
from grader.batch.work import Failed, Order
from grader.cli.regrading import regraded
from grader.intake.candidates import Entry
from grader.intake.handed_in import handed_in
from grader.kept import Result, kept
from grader.model.stages import Rejected, Submission
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import SETTINGS, anew, begun, job
from tests.report import samples

Entries = Callable[[], Iterator[Entry]]


def test_what_could_not_be_graded_anew_keeps_all_as_it_is(tmp_path: Path, log: Path) -> None:
    """Half of a class by other rules would be unfair."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "hard", "bob.cpp": CODE})
    out = tmp_path / "out"
    grade(path, job(out))
    failing = replace(anew(out), entry="tests.batch.test_graded_anew:failed")
    assert regraded(failing, apply=True) == 3
    assert points(out) == {"ada": 50, "bob": 50}
    with opened_store(out) as store:
        assert store.current() == SETTINGS


def test_points_withheld_anew_keep_all_as_it_is(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Who has points keeps them, and the next try grades only what was withheld."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "withheld once", "bob.cpp": "wrong"})
    out = tmp_path / "out"
    log.write_text("1 withheld once\n")
    grade(path, job(out))
    log.unlink()
    before = points(out)
    assert before["ada"] == 50
    assert regraded(anew(out), apply=True) == 3
    said = capsys.readouterr().out
    assert "ada: not graded anew\n" in said
    assert said.endswith(
        "1 not graded anew, so nothing was changed; the same command goes on\n"
    )
    assert points(out) == before
    assert regraded(anew(out), apply=True) == 0
    *first, again = begun(log)
    # Two are graded at once, so either may have begun first.
    assert sorted(first) == ["withheld once", "wrong"]
    assert again == "withheld once"


def test_what_we_failed_at_before_is_tried_anew(tmp_path: Path, log: Path) -> None:
    """Its bytes are in the store; once it is graded nothing tells of the fault any more."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "raise", "bob.cpp": CODE})
    out = tmp_path / "out"
    grade(path, job(out))
    assert points(out) == {"ada": None, "bob": 50}
    assert regraded(anew(out), apply=False) == 3
    assert begun(log).count("raise") == 2
    healed = replace(anew(out), entry="tests.batch.test_graded_anew:perfect")
    assert regraded(healed, apply=True) == 0
    assert points(out) == {"ada": 50, "bob": 50}
    assert "not graded" not in (out / "class.csv").read_text()
    with opened_store(out) as store:
        assert not [one for one in store.students() if one.fault or not one.written]


@pytest.mark.parametrize("text", ["raise", "withheld once"])
def test_who_has_no_points_does_not_block_a_class(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str], text: str
) -> None:
    """After an update the settings of before cannot be had again; a person is told of whom."""
    path = folder_of(tmp_path, "class", {"ada.cpp": text, "bob.cpp": "moody", "cy.cpp": CODE})
    out = tmp_path / "out"
    grade(path, job(out))
    new = replace(anew(out), entry="tests.batch.test_graded_anew:failed")
    assert regraded(new, apply=False) == 3
    assert points(out) == {"ada": None, "bob": 50, "cy": 50}
    assert regraded(new, apply=True) == 3
    said = capsys.readouterr().out
    assert "ada: not graded anew; no points before either: grade the download again\n" in said
    assert "2 graded, 1 withheld, 0 waiting\n" in said
    assert points(out) == {"ada": None, "bob": 50, "cy": 50}
    with opened_store(out) as store:
        assert store.current() == new.settings
    now = replace(new, entry="tests.batch.test_graded_anew:perfect", preview=False)
    assert grade(path, now)[0].graded == 3
    assert points(out) == {"ada": 50, "bob": 50, "cy": 50}


def test_who_was_never_read_does_not_block_a_class(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """There is nothing to grade anew and nothing to lose; the download still has the file."""
    out = tmp_path / "out"
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"})
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("grader.batch.runner.handed_in", unread)
        grade(path, job(out))
    assert points(out) == {"ada": None, "bob": 50}
    assert regraded(anew(out), apply=True) == 3
    assert "ada: not graded anew, since its file was never read; no" in capsys.readouterr().out
    assert points(out) == {"ada": None, "bob": 50}
    with opened_store(out) as store:
        assert store.current() == anew(out).settings
    assert grade(path, replace(anew(out), preview=False))[0].graded == 2


def perfect(order: Order, tell: Callable[[str], None]) -> Result:
    """Do what a clerk does, without a fault."""
    return kept(replace(samples.perfect(), submission=order.submission))


def failed(order: Order, tell: Callable[[str], None]) -> Result | Failed:
    """Fail at some files."""
    assert isinstance(order.submission, Submission)
    hard = order.submission.source in (b"hard", b"raise", b"withheld once")
    return Failed("no more file descriptors") if hard else perfect(order, tell)


def unread(student: str, entries: Entries, limit: int) -> Submission | Rejected:
    """Read nothing of Ada's, as if it lay on a disk that is gone."""
    if student == "ada":
        raise PermissionError(EACCES, "Permission denied")
    return handed_in(student, entries, limit)
