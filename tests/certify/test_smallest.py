"""Sizes of counterexamples are kept by file, and their medians are told by check."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import starmap
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from grader.certify import certificate, smallest
from grader.certify import ledger as ledgers
from grader.certify.corpus import corpus_folder, name_of
from grader.certify.ledger import Ledger
from grader.certify.matrix import FAILED, stored_lines
from grader.certify.row import Row
from grader.certify.smallest import (
    WITHOUT_INPUT,
    Smallest,
    failing_pairs,
    searched,
    smallest_inputs,
    smallest_lines,
    store_smallest,
    stored_smallest,
)
from grader.cli import cli
from grader.counterexample.written import to_text
from grader.errors import GraderError
from grader.identity import WITHOUT_SIZES, grader_digest
from grader.model.verdict import Verdict
from grader.resources import reference_source
from tests.report import samples
from tests.report.small_inputs import small

TIGHT, MEDIAN, CLOSEST = (
    "bvh.boxes-are-tight",
    "bvh.splits-at-the-median",
    "hits.closest-wins",
)
FOUND = [
    Smallest(TIGHT, "wrong/a.cpp", 5, 0),
    Smallest(CLOSEST, "wrong/a.cpp", 3, 1),
    Smallest(CLOSEST, "wrong/b.cpp", 9, 2),
    Smallest(CLOSEST, "wrong/c.cpp", None, None),
]


@pytest.fixture
def stored(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Keep sizes in a file of this test."""
    path = tmp_path / "sizes.csv"
    monkeypatch.setattr(smallest, "smallest_file", lambda: path)
    return path


def files(folder: Path, *names: str) -> list[Path]:
    """Make wrong submissions that hold their name."""
    (folder / "wrong").mkdir()
    paths = [folder / "wrong" / name for name in names]
    for path in paths:
        path.write_text(path.name)
    return paths


def test_what_is_stored_is_of_failed_checks() -> None:
    """The kill matrix knows every one of them; none is of a check without an input."""
    lines = stored_lines()
    for one in stored_smallest():
        assert lines[one.submission][one.check] == FAILED
        assert one.check not in WITHOUT_INPUT


def test_only_what_was_searched_is_written_anew(stored: Path, tmp_path: Path) -> None:
    """Sizes of other files stay, and those of files that are gone do not."""
    paths = files(tmp_path, "a.cpp", "b.cpp")
    store_smallest(FOUND, paths, "older")
    assert stored.read_text().splitlines()[:2] == [
        "check,submission,faces,rays,grader",
        f"{TIGHT},wrong/a.cpp,5,0,older",
    ]
    store_smallest([Smallest(MEDIAN, "wrong/a.cpp", 7, 0)], paths, "newer")
    assert stored_smallest() == [
        Smallest(MEDIAN, "wrong/a.cpp", 7, 0, "newer"),
        replace(FOUND[2], grader="older"),
    ]


def test_medians_are_told_by_check_and_of_all() -> None:
    """What was not found counts as failed, and has no size; part a has no rays."""
    assert [line.strip() for line in smallest_lines(FOUND, 9)[4:]] == [
        f"| `{TIGHT}` | 1 | 1 | 5 |  | 5 |",
        f"| `{CLOSEST}` | 3 | 2 | 6 | 1.5 | 9 |",
        "| all | 4 | 3 | 5 | 1.5 | 9 |",
    ]


def test_a_sample_says_so_and_who_searched_it() -> None:
    """How many pairs there are without an input tells how far the medians can be believed."""
    rows = [Row("wrong/a.cpp", "0", 41, (), (TIGHT, CLOSEST, "source.construct-loops"))]
    assert failing_pairs(rows) == 2
    searched_once, by_state, *_ = smallest_lines([FOUND[0], replace(FOUND[1], grader="s")], 2)
    assert searched_once == "Searched: 2 of 2 failing pairs of a file and a check.\n"
    assert by_state.strip() == "By state of the grader: `s` 1, `unknown` 1."


def test_a_grade_gives_the_size_of_each_failed_check(monkeypatch: pytest.MonkeyPatch) -> None:
    """A check that looks at no input has none; a check that passes is not told."""
    found = replace(samples.check(1), verdict=Verdict.FAIL, counterexample=small())
    checks = [
        replace(found, check=TIGHT),
        replace(found, check=MEDIAN, counterexample=None),
        replace(found, check="source.construct-loops"),
        replace(found, check=CLOSEST, verdict=Verdict.PASS),
    ]
    monkeypatch.setattr(smallest, "grade_one", lambda *_: samples.graded(checks))
    faces, name = small().faces, name_of(reference_source())
    assert smallest_inputs(reference_source(), None) == [
        Smallest(TIGHT, name, faces, 0),
        Smallest(MEDIAN, name, None, None),
    ]


def test_inputs_are_kept_as_check_writes_them(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One file for each, and none of an earlier search."""
    checks = [
        replace(samples.check(1), check=CLOSEST, verdict=Verdict.FAIL, counterexample=small()),
        replace(samples.check(1), check=MEDIAN, verdict=Verdict.FAIL, counterexample=None),
    ]
    monkeypatch.setattr(smallest, "grade_one", lambda *_: samples.graded(checks))
    folder = tmp_path / "into" / reference_source().stem
    folder.mkdir(parents=True)
    (folder / f"{TIGHT}.json").write_text("of an earlier search")
    smallest_inputs(reference_source(), tmp_path / "into")
    assert [each.name for each in folder.iterdir()] == [f"{CLOSEST}.json"]
    assert (folder / f"{CLOSEST}.json").read_text() == to_text(small())
    assert list(folder.parent.iterdir()) == [folder]


def test_our_own_fault_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was stored of the file before stays."""

    def busy(*_: object) -> None:
        raise GraderError("busy")

    monkeypatch.setattr(smallest, "grade_one", busy)
    assert smallest_inputs(reference_source(), None) is None


def test_a_search_goes_on_where_it_was(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """What the ledger knows is not searched again, what was undecided is."""
    paths, asked = files(tmp_path, "a.cpp", "b.cpp"), []

    def stand_in(path: Path, _: Path | None) -> list[Smallest] | None:
        asked.append(path.name)
        undecided = path.name == "b.cpp" and asked.count("b.cpp") == 1
        return None if undecided else [one for one in FOUND if one.submission == name_of(path)]

    def in_this_process(
        task: Callable[..., Any], orders: Sequence[tuple[Any, ...]], _: int
    ) -> Iterator[Any]:
        return starmap(task, orders)

    monkeypatch.setattr(smallest, "smallest_inputs", stand_in)
    monkeypatch.setattr(smallest, "mapped", in_this_process)
    ledger, told = Ledger(tmp_path / "rows", "g"), []
    for _ in range(3):
        found = searched(paths, 1, ledger, lambda name, _: told.append(name))
    assert asked == ["a.cpp", "b.cpp", "b.cpp"]
    assert told == ["wrong/a.cpp", "wrong/b.cpp", "wrong/b.cpp"]
    assert found == FOUND[:3]
    # Their sizes are known, but the inputs of only one of them are where they are to be.
    (tmp_path / "into/a").mkdir(parents=True)
    searched(paths, 1, ledger, lambda *_: None, tmp_path / "into")
    assert asked[3:] == ["b.cpp"]


def test_the_command_stores_and_tells(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, stored: Path
) -> None:
    """One file: its sizes are stored, and the certificate is written with their medians."""
    name = "last-hit-wins.cpp"
    found = [Smallest(CLOSEST, f"wrong/{name}", 2, 1)]

    def mapped(_: object, orders: Sequence[tuple[Path, None]], jobs: int) -> list[Any]:
        assert [path for path, _ in orders] == [corpus_folder() / "wrong" / name]
        return [found]

    monkeypatch.setattr(smallest, "mapped", mapped)
    monkeypatch.setattr(ledgers, "usual_ledger", lambda: tmp_path / "rows")
    monkeypatch.setattr(certificate, "certificate_file", lambda: tmp_path / "certificate.md")
    result = CliRunner().invoke(cli, ["certify", "--counterexamples", "--match", name])
    assert result.exit_code == 0, result.output
    assert f"wrong/{name}: {CLOSEST} 2 faces 1 rays" in result.output
    grader = grader_digest(WITHOUT_SIZES)
    assert stored_smallest() == [replace(one, grader=grader) for one in found]
    assert "| all | 1 | 1 | 2 | 1 | 2 |\n" in (tmp_path / "certificate.md").read_text()


def test_a_folder_for_inputs_goes_with_their_search(tmp_path: Path) -> None:
    """Nothing else finds any, and nobody would see that none is kept."""
    result = CliRunner().invoke(cli, ["certify", "--stored", "--into", str(tmp_path / "a")])
    assert result.exit_code == 2
    assert "--into keeps what --counterexamples finds; give that as well" in result.output
    assert not (tmp_path / "a").exists()
