"""docs/certificate.md says what the stored matrix says, and the command judges it."""

from pathlib import Path

import pytest
from click.testing import CliRunner

from grader import resources
from grader.certify import certificate as written
from grader.certify.certificate import certificate, certificate_file, mutant_lines
from grader.certify.corpus import wrong_submissions
from grader.certify.fates import FATES
from grader.certify.matrix import line_of, row_of, stored_lines
from grader.cli import cli

STORED = stored_lines()


def test_the_stored_certificate_is_of_the_stored_matrix() -> None:
    """Otherwise `bvhgrade certify --stored` writes it anew."""
    rows = [row_of(line) for line in STORED.values()]
    assert certificate_file().read_text() == certificate(rows, wrong_submissions())


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
