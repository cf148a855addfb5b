"""A class's store belongs to one batch at a time, and to this version of it."""

import sqlite3
from pathlib import Path

import pytest

from grader.batch.store import opened_store, read_store
from grader.cli.batch import dropped
from grader.errors import OutputFault, UsageError
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import SETTINGS, job


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


def test_an_older_store_is_not_carried_over_by_a_reader(tmp_path: Path) -> None:
    """Who grades does that."""
    with sqlite3.connect(tmp_path / "batch.sqlite") as base:
        base.execute("PRAGMA user_version = 1")
    base.close()
    with pytest.raises(UsageError, match="call `bvhgrade batch` again"), read_store(tmp_path):
        pass


def test_another_data_base_is_left_alone(tmp_path: Path) -> None:
    """It has the file's name, and tables of its own."""
    with sqlite3.connect(tmp_path / "batch.sqlite") as base:
        base.execute("CREATE TABLE student (name TEXT)")
    base.close()
    with pytest.raises(UsageError, match="no store of results"), opened_store(tmp_path):
        pass


def test_a_store_of_another_version_is_left_alone(tmp_path: Path) -> None:
    """Neither read wrongly nor changed."""
    with sqlite3.connect(tmp_path / "batch.sqlite") as base:
        base.execute("PRAGMA user_version = 99")
    base.close()
    with pytest.raises(UsageError, match="version 99"), opened_store(tmp_path):
        pass


def test_a_file_that_is_no_store_is_left_alone(tmp_path: Path) -> None:
    """Somebody else's file of this name."""
    (tmp_path / "batch.sqlite").write_bytes(b"this is no data base at all" * 100)
    with pytest.raises(UsageError, match="no store of results"), opened_store(tmp_path):
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
