"""The sample has right files and one wrong one for each check, held to the matrix."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from grader.certify import certificate, matrix, run
from grader.certify.corpus import name_of, right_submissions, wrong_submissions
from grader.certify.matrix import SEED, matrix_file, row_of, stored_lines
from grader.certify.row import Row
from grader.certify.sample import differences, killers, sampled
from grader.cli import cli
from grader.score.rubric import load_rubric

STORED = {name: row_of(line) for name, line in stored_lines().items()}
ANY = STORED["right/stackless-walk.cpp"]


def test_a_sample_holds_half_of_the_right_files_and_one_mistake_of_each_check() -> None:
    """And none of them twice."""
    names = [name_of(path) for path in sampled("a")]
    assert len(set(names)) == len(names)
    every = [name_of(one) for one in right_submissions()]
    drawn = [name for name in names if name in every]
    assert len(every) / 3 < len(drawn) < 2 * len(every) / 3
    owners = [one.checks[0] for one in wrong_submissions() if name_of(one.path) in names]
    assert sorted(owners) == sorted(one.check for one in load_rubric(None).criteria)


def test_each_state_of_the_grader_draws_another_half() -> None:
    """After a few of them every right file has been graded."""
    every = {name_of(one) for one in right_submissions()}
    drawn = [{name_of(path) for path in sampled(str(state))} & every for state in range(16)]
    assert drawn[0] != drawn[1]
    assert set.union(*drawn) == every


def test_a_file_that_is_not_stored_as_it_is_comes_always(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A new one, or one that has changed since."""
    changed, gone, *_ = (name_of(one) for one in right_submissions())
    lines = {**stored_lines()}
    lines[changed] = {**lines[changed], "sha256": "0"}
    del lines[gone]
    monkeypatch.setattr("grader.certify.sample.stored_lines", lambda: lines)
    for state in range(16):
        assert {changed, gone} <= {name_of(path) for path in sampled(str(state))}


def test_a_killer_is_seen_by_as_few_checks_as_possible() -> None:
    """One that only its own check sees, wherever there is one."""
    for check, killer in killers().items():
        own = [name_of(one.path) for one in wrong_submissions() if one.checks[0] == check]
        fewest = min(len(STORED[name].failed) for name in own)
        assert len(STORED[name_of(killer.path)].failed) == fewest


@pytest.mark.parametrize(
    ("row", "told"),
    [
        (ANY, []),
        (replace(ANY, because="other words"), []),
        (replace(ANY, seed=SEED + 1, scores=(0.0, 0.0)), []),
        (replace(ANY, broken=("busy",)), []),
        (replace(ANY, scores=(24.0, 25.0)), ["24 + 25 points", "25 + 25 points"]),
        (replace(ANY, failed=("hits.closest-wins",)), ["failed: hits.closest-wins"]),
        (replace(ANY, digest="0"), ["stored is a row of another file"]),
        (replace(ANY, name="right/new.cpp"), ["stored is nothing"]),
    ],
)
def test_what_differs_from_the_matrix_is_told(row: Row, told: list[str]) -> None:
    """Points and failed checks of the matrix's seed; an undecided row says nothing."""
    found = list(differences([row]))
    assert bool(found) == bool(told)
    assert all(words in found[0] for words in told)


@pytest.fixture
def graded(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> dict[str, Row]:
    """Put the stored rows in the place of grading, and forbid that anything is written."""
    rows = dict(STORED)

    def stand_in(work: run.Work, *_: Any) -> Sequence[Row]:  # noqa: ANN401 - unused
        return [rows[name_of(path)] for path in work.paths]

    monkeypatch.setattr(run, "certified_rows", stand_in)
    monkeypatch.setattr(matrix, "store", lambda *_: pytest.fail("the matrix was written"))
    monkeypatch.setattr(certificate, "certificate_file", lambda: tmp_path / "no" / "file")
    return rows


def certified(*options: str) -> Result:
    """Call the command with one seed."""
    return CliRunner().invoke(cli, ["certify", "--sample", "--seeds", "1", *options])


def test_a_sample_that_says_what_is_stored_is_good(graded: dict[str, Row]) -> None:
    """Exit status 0, and nothing is written."""
    before = matrix_file().read_bytes()
    result = certified()
    assert result.exit_code == 0, result.output
    assert "0 differ from the stored matrix" in result.output
    assert "0 checks without a killer" in result.output
    assert matrix_file().read_bytes() == before


def test_a_difference_that_is_no_hole_is_seen(graded: dict[str, Row]) -> None:
    """One check more fails on a wrong file: exit status 1, and the line says both."""
    name = name_of(killers()["hits.closest-wins"].path)
    graded[name] = replace(graded[name], failed=("hits.closest-wins", "image.equals-mitsuba"))
    result = certified()
    assert result.exit_code == 1, result.output
    assert f"1 differ from the stored matrix\n  {name}: " in result.output


def test_a_hole_is_seen(graded: dict[str, Row], monkeypatch: pytest.MonkeyPatch) -> None:
    """A right file without full marks: exit status 1."""
    monkeypatch.setattr("grader.certify.sample._is_drawn", lambda *_: True)
    graded[ANY.name] = replace(ANY, scores=(24.0, 25.0))
    result = certified("--match", ANY.name)
    assert result.exit_code == 1, result.output
    assert "1 false rejects" in result.output
