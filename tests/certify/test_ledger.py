"""A run that is killed goes on, and what was graded is not graded again."""

from collections.abc import Callable, Iterator, Sequence
from itertools import starmap
from pathlib import Path
from typing import Any

import pytest

from grader.certify import run
from grader.certify.corpus import digest_of, name_of
from grader.certify.ledger import Ledger
from grader.certify.row import Row
from grader.certify.run import Work, certified_rows

FILES: list[str] = []
GRADED: list[tuple[str, int]] = []
BUSY: list[tuple[str, int]] = []


def stand_in(path: Path, seeds: Sequence[int]) -> list[Row]:
    """Grade nothing; the first time, the machine may be too busy."""
    FILES.append(path.name)
    return [row_of(path, seed) for seed in seeds]


def row_of(path: Path, seed: int) -> Row:
    """Make a row, and take note of it."""
    GRADED.append((path.name, seed))
    busy = GRADED[-1] in BUSY
    if busy:
        BUSY.remove(GRADED[-1])
    return Row(name_of(path), digest_of(path), seed, (25.0, 25.0), (), ("busy",) * busy)


def in_this_process(
    task: Callable[..., list[Row]], orders: Sequence[tuple[Any, ...]], jobs: int
) -> Iterator[list[Row]]:
    """Stand in for processes."""
    assert jobs == 1
    return starmap(task, orders)


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Two submissions and a grader that only says that it was asked."""
    FILES.clear()
    GRADED.clear()
    BUSY.append(("a.cpp", 42))
    monkeypatch.setattr(run, "graded_rows", stand_in)
    monkeypatch.setattr(run, "mapped", in_this_process)
    paths = [tmp_path / "a.cpp", tmp_path / "b.cpp"]
    for path in paths:
        path.write_text(path.name)
    return paths


def rows_of(paths: list[Path], ledger: Ledger, again: bool = False) -> list[Row]:
    """Grade two seeds."""
    return certified_rows(Work(paths, (41, 42), 1, again), ledger, lambda _: None)


def test_a_row_is_graded_once(files: list[Path], tmp_path: Path) -> None:
    """What is undecided is tried again, what is known is not, unless it is asked for.

    The seeds of a file are graded together, from one build.
    """
    ledger = Ledger(tmp_path / "rows", "g")
    assert len(rows_of(files, ledger)) == 5
    assert GRADED == [("a.cpp", 41), ("a.cpp", 42), ("b.cpp", 41), ("b.cpp", 42), ("a.cpp", 42)]
    assert FILES == ["a.cpp", "b.cpp", "a.cpp"]
    GRADED.clear()
    rows_of(files, ledger)
    assert GRADED == []
    rows_of(files, ledger, again=True)
    assert len(GRADED) == 4


def test_another_grader_or_file_is_graded_anew(files: list[Path], tmp_path: Path) -> None:
    """A row says nothing of a file, or of a grader, that has changed."""
    rows_of(files, Ledger(tmp_path / "rows", "g"))
    GRADED.clear()
    files[1].write_text("changed")
    rows_of(files, Ledger(tmp_path / "rows", "g"))
    assert GRADED == [("b.cpp", 41), ("b.cpp", 42)]
    GRADED.clear()
    rows_of(files, Ledger(tmp_path / "rows", "another"))
    assert len(GRADED) == 4


def test_a_line_that_was_cut_off_is_passed_over(files: list[Path], tmp_path: Path) -> None:
    """A run that was killed while it wrote loses that row only."""
    ledger = Ledger(tmp_path / "rows", "g")
    rows_of(files, ledger)
    text = (tmp_path / "rows").read_text()
    (tmp_path / "rows").write_text(text[:-20])
    before = list(ledger.rows())
    ledger.add(before[0])
    assert list(ledger.rows()) == [*before, before[0]]
