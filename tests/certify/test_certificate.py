"""docs/certificate.md says what the stored matrix says, and the command judges it."""

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from grader import resources
from grader.certify import certificate as written
from grader.certify import matrix
from grader.certify.certificate import certificate, certificate_file, mutant_lines
from grader.certify.corpus import every_submission, name_of, wrong_submissions
from grader.certify.fates import FATES
from grader.certify.matrix import SEED, line_of, row_of, stored_lines, stored_rows
from grader.cli import cli
from grader.cli.certify import print_holes

STORED = stored_lines()


def test_the_stored_certificate_is_of_the_stored_matrix() -> None:
    """Otherwise `bvhgrade certify --stored` writes it anew."""
    told = certificate(stored_rows(every_submission()), wrong_submissions())
    assert certificate_file().read_text() == told


def test_a_file_without_a_row_of_its_own_is_undecided(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """New, or changed since: both are holes, in the output and in the certificate."""
    new, changed, *_ = paths = every_submission()
    kept = {name: line for name, line in STORED.items() if name != name_of(new)}
    kept |= {name_of(changed): {**STORED[name_of(changed)], "sha256": "0"}}
    monkeypatch.setattr(matrix, "stored_lines", lambda: kept)
    monkeypatch.setattr(written, "certificate_file", lambda: tmp_path / "certificate.md")
    told = [row.broken for row in stored_rows(paths[:2])]
    assert told == [("no row of it is stored",), ("the stored row is of an older file",)]
    result = CliRunner().invoke(cli, ["certify", "--stored", "--match", name_of(new)])
    assert result.exit_code == 1, result.output
    assert f"  {name_of(new)} (seed {SEED}): no row of it is stored\n" in result.output
    assert "| undecided: " in (tmp_path / "certificate.md").read_text()


def test_no_two_runs_are_said_to_agree_where_there_is_one(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Flaky is only what ran twice with one seed."""
    row = row_of(next(iter(STORED.values())))
    print_holes([row, replace(row, seed=SEED + 1)], [])
    assert "flaky" not in capsys.readouterr().out
    print_holes([row, row], [])
    assert "0 flaky" in capsys.readouterr().out


def test_a_line_of_the_matrix_is_read_back() -> None:
    """Nothing is lost between a row and its line."""
    for line in STORED.values():
        assert line_of(row_of(line)) == line


def test_the_stored_matrix_has_no_hole(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The command judges it without grading, writes the certificate, and ends with 0."""
    monkeypatch.setattr(written, "certificate_file", lambda: tmp_path / "certificate.md")
    result = CliRunner().invoke(cli, ["certify", "--stored"])
    assert result.exit_code == 0, result.output
    assert "0 false accepts" in result.output
    assert (tmp_path / "certificate.md").read_text() == certificate_file().read_text()


def test_each_line_knows_which_grader_made_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Lines of an older one stay, and the certificate counts both."""
    monkeypatch.setattr(matrix, "matrix_file", lambda: tmp_path / "matrix.csv")
    first, second, *_ = (row_of(line) for line in STORED.values())
    names = [first.name, second.name]
    matrix.store([first, second], names, "older")
    matrix.store([second], names, "newer")
    assert stored_lines() == {name: STORED[name] for name in names}
    assert matrix.stored_states() == {"older": 1, "newer": 1}
    told = certificate(stored_rows(every_submission()), wrong_submissions())
    assert "Graded by state of the grader: `newer` 1, `older` 1.\n" in told


def test_the_table_of_mutants() -> None:
    """A line for each original, their sum, and the share that is caught."""
    counts = {"x.cpp": dict.fromkeys(FATES, 1), "y.cpp": dict.fromkeys(FATES, 2)}
    *_, first, second, total, share = mutant_lines(counts)
    assert (first[:11], second[:11]) == ("| x.cpp | 1", "| y.cpp | 2")
    assert total == "| all |" + " 3 |" * len(FATES) + "\n"
    assert share == "\nCaught: 33.3 % of all other programs without explanation.\n"


def test_a_name_that_nothing_has() -> None:
    """A misspelt name is wrong usage: grading nothing proves nothing."""
    result = CliRunner().invoke(cli, ["certify", "--match", "no-such-file"])
    assert result.exit_code == 2, result.output


def test_a_wheel_says_what_is_missing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Without a checkout the command ends with one sentence."""
    monkeypatch.setattr(resources, "stub_folder", lambda: tmp_path / "student_stub")
    result = CliRunner().invoke(cli, ["certify", "--stored"])
    assert result.exit_code == 2, result.output
    assert "clone the project" in result.output
