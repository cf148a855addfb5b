"""A class's store belongs to one batch at a time, and to this version of it."""

import sqlite3
from collections.abc import Callable
from contextlib import AbstractContextManager, closing
from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch.store import Store, opened_store, read_store
from grader.cli.batch import dropped
from grader.errors import OutputFault, UsageError
from grader.score.rubric import SHIPPED
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import SETTINGS, job

Opened = Callable[[Path], AbstractContextManager[Store]]


def test_a_second_batch_is_kept_away(tmp_path: Path) -> None:
    """Two would grade everything twice and write over each other."""
    other = opened_store(tmp_path)
    with opened_store(tmp_path), pytest.raises(UsageError, match="another batch"):
        other.__enter__()
    with opened_store(tmp_path) as store:
        store.know(SETTINGS)
        assert store.current() == SETTINGS


def test_who_only_reads_keeps_no_reader_away(tmp_path: Path) -> None:
    """Several look something up at once, but not while a batch writes."""
    with opened_store(tmp_path) as store:
        store.know(SETTINGS)
        with pytest.raises(UsageError, match="another batch"), read_store(tmp_path):
            pass
    with read_store(tmp_path) as one, read_store(tmp_path) as other:
        assert one.current() == other.current() == SETTINGS
        with pytest.raises(UsageError, match="another batch"), opened_store(tmp_path):
            pass


def test_a_class_can_be_read_where_nothing_can_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An archive of the last term, or the folder of a colleague, whose lock is the colleague's.

    The tests may run as root, who can write everywhere: what is asked is whether it tries to.
    """
    with opened_store(tmp_path) as store:
        store.know(SETTINGS)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    (tmp_path / ".batch.lock").unlink()
    monkeypatch.setattr("os.access", lambda *_: False)
    with read_store(tmp_path) as store:
        assert store.current() == SETTINGS
        assert not (tmp_path / ".batch.lock").exists()
        assert {path.name for path in tmp_path.iterdir()} <= set(before)
        with pytest.raises(OutputFault, match=r"readonly database$"):
            store.make_current(SETTINGS)


def made_otherwise(folder: Path, statement: str) -> None:
    """Make a data base that no batch of today has made."""
    with closing(sqlite3.connect(folder / "batch.sqlite")) as base, base:
        base.execute(statement)


@pytest.mark.parametrize(
    ("opened", "statement", "words"),
    [
        (read_store, "PRAGMA user_version = 1", "call `bvhgrade batch` again"),
        (read_store, "PRAGMA user_version = 99", "version 99"),
        (opened_store, "PRAGMA user_version = 99", "version 99"),
        (opened_store, "CREATE TABLE student (name TEXT)", "no store of results"),
    ],
    ids=["older, read", "newer, read", "newer", "another one"],
)
def test_another_data_base_is_left_alone(
    tmp_path: Path, opened: Opened, statement: str, words: str
) -> None:
    """Neither read wrongly nor changed; an older one is carried over by who grades."""
    made_otherwise(tmp_path, statement)
    before = (tmp_path / "batch.sqlite").read_bytes()
    with pytest.raises(UsageError, match=words), opened(tmp_path):
        pass
    assert (tmp_path / "batch.sqlite").read_bytes() == before


@pytest.mark.parametrize("opened", [read_store, opened_store])
def test_a_file_that_is_no_store_is_left_alone(tmp_path: Path, opened: Opened) -> None:
    """Somebody else's file of this name."""
    (tmp_path / "batch.sqlite").write_bytes(b"this is no data base at all" * 100)
    with pytest.raises(UsageError, match="no store of results"), opened(tmp_path):
        pass


def test_a_student_can_be_taken_out(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By the name of the folder, which the table tells; the others stay as they are."""
    out = job(tmp_path / "out")
    grade(folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "b"}), out)
    with pytest.raises(UsageError, match="no student's folder is called eve"):
        dropped(out, "eve")
    assert dropped(out, "ada") == 0
    assert "ada: taken out of the class\n1 graded" in capsys.readouterr().out
    assert points(tmp_path / "out") == {"bob": 50}
    assert "ada" not in (tmp_path / "out/class.csv").read_text()


def test_a_student_can_be_taken_out_after_an_update(tmp_path: Path, log: Path) -> None:
    """Of the grader or the compiler; the others keep all that they have, whatever it is."""
    old = job(tmp_path / "out")
    files = {"ada.cpp": "raise", "bob.cpp": "wrong", "cy.cpp": " ", "di.cpp": CODE}
    grade(folder_of(tmp_path, "class", files), old)
    header, *rows = (old.folder / "class.csv").read_text().splitlines()
    path = tmp_path / "rubric.toml"
    path.write_text(SHIPPED.read_text().replace("\npoints = 3\n", "\npoints = 4\n", 1))
    settings = replace(SETTINGS, grader="0.2", seed=7)
    new = replace(old, settings=settings, wish=replace(old.wish, rubric=path))
    assert dropped(new, "di") == 3
    assert (old.folder / "class.csv").read_text().splitlines() == [header, *rows[:3]]
    assert dropped(new, "ada") == 0
    assert "bvhgrade 0.1" in (old.folder / "class.html").read_text()
    with opened_store(old.folder) as store:
        assert store.current() == SETTINGS
        for one in list(store.students()):
            store.put(replace(one, written=""), b"")
    assert dropped(new, "bob") == 3, "nobody knows whether Cy's folder is of the newest file"
