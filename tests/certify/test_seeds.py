"""The certificate says with how many seeds everything was graded, and what was found."""

from pathlib import Path

import pytest

from grader.certify import seeds
from grader.certify.holes import Hole, Kind
from grader.certify.row import Row
from grader.certify.seeds import store_tried, stored_tried, tried, tried_lines


@pytest.fixture
def file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Give a place for the stored run, with nothing in it."""
    path = tmp_path / "seeds.json"
    monkeypatch.setattr(seeds, "tried_file", lambda: path)
    return path


def row(name: str, seed: int, broken: tuple[str, ...] = ()) -> Row:
    """Make a row of full marks."""
    return Row(name, "0", seed, (25, 25), (), broken)


def test_a_run_is_summed_up(file: Path) -> None:
    """What was decided counts once, however often it was tried; it is read back as it was."""
    rows = [
        row("right/x.cpp", 41, ("crowded",)),
        row("right/x.cpp", 41),
        row("right/x.cpp", 42),
        row("wrong/y.cpp", 41),
        row("wrong/y.cpp", 42, ("crowded",)),
    ]
    found = [Hole(Kind.FALSE_ACCEPT, "y"), Hole(Kind.UNDECIDED, "y")]
    run = tried(rows, found, "abc")
    assert (list(run.seeds), run.files, run.grades) == ([41, 42], 2, 3)
    assert {name for name, count in run.found.items() if count} == {"FALSE_ACCEPT", "UNDECIDED"}
    assert stored_tried() is None
    store_tried(run)
    assert stored_tried() == run
    assert file.read_text().endswith("}\n")


@pytest.mark.parametrize(
    ("seeds", "grader", "kept"),
    [(2, "abc", False), (3, "abc", True), (2, "new", True), (1, "new", False)],
)
@pytest.mark.usefixtures("file")
def test_fewer_seeds_do_not_replace_more(seeds: int, grader: str, kept: bool) -> None:
    """Of the same grader; of another one the stored run says nothing. One seed is no news."""
    first = tried([row("right/x.cpp", seed) for seed in (41, 42, 43)], [], "abc")
    second = tried([row("right/z.cpp", 41 + seed) for seed in range(seeds)], [], grader)
    store_tried(first)
    store_tried(second)
    assert stored_tried() == (second if kept else first)


def test_flaky_is_told_only_of_what_ran_twice() -> None:
    """Two runs of one seed can differ; two seeds are no two runs."""
    once = [row("right/x.cpp", seed) for seed in (41, 42)]
    assert "UNSTEADY" not in tried(once, [], "abc").found
    found = [Hole(Kind.UNSTEADY, "x")]
    run = tried([*once, row("right/x.cpp", 41)], found, "abc")
    assert f"| {Kind.UNSTEADY.value} | 1 |\n" in tried_lines(run)


def test_a_run_is_worded() -> None:
    """A line for each kind of hole, and what was graded."""
    run = tried([row("right/x.cpp", seed) for seed in (41, 42, 43)], [], "abc")
    text = "".join(tried_lines(run))
    assert "All 1 files were graded with 3 seeds (41 to 43): 3 grades,\nby state `abc`" in text
    told = [line for line in text.splitlines() if line.endswith(" | 0 |")]
    assert [line.startswith("| flaky") for line in told] == [False] * (len(Kind) - 1)
    assert tried_lines(None) == ["The whole corpus was graded with no other seed yet.\n"]
