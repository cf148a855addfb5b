"""What was decided while somebody edited the grader is kept nowhere."""

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import starmap
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from grader.certify import certificate, matrix, run, seeds, smallest, state
from grader.certify import ledger as ledgers
from grader.certify.corpus import digest_of, name_of
from grader.certify.fates import Fate, Studied
from grader.certify.mutants import Mutant
from grader.certify.row import Row
from grader.cli import cli
from grader.identity import grader_digest


def in_this_process(
    task: Callable[..., Any], orders: Sequence[tuple[Any, ...]], _: int
) -> Iterator[Any]:
    """Stand in for processes."""
    return starmap(task, orders)


def graded(path: Path, seeds_of: Sequence[int]) -> list[Row]:
    """Stand in for a grade."""
    return [Row(name_of(path), digest_of(path), seed, (25, 25), ()) for seed in seeds_of]


def studied(mutant: Mutant, seed: int) -> Studied:
    """Stand in for the study of a mutant."""
    told = (mutant.digest, seed, mutant.original, mutant.kind, mutant.line, mutant.change)
    return Studied(*told, Fate.CAUGHT.value, "")


@pytest.fixture
def places(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Give places for everything that is stored, and grade nothing."""
    monkeypatch.setattr(run, "mapped", in_this_process)
    monkeypatch.setattr(smallest, "mapped", in_this_process)
    monkeypatch.setattr(run, "graded_rows", graded)
    monkeypatch.setattr(run, "study_or_none", studied)
    monkeypatch.setattr(smallest, "smallest_inputs", lambda *_: [])
    monkeypatch.setattr(ledgers, "usual_ledger", lambda: tmp_path / "ledger")
    monkeypatch.setattr(matrix, "matrix_file", lambda: tmp_path / "matrix.csv")
    monkeypatch.setattr("grader.certify.fates.counts_file", lambda: tmp_path / "mutants.csv")
    monkeypatch.setattr(smallest, "smallest_file", lambda: tmp_path / "sizes.csv")
    monkeypatch.setattr(seeds, "tried_file", lambda: tmp_path / "seeds.json")
    monkeypatch.setattr(certificate, "certificate_file", lambda: tmp_path / "certificate.md")
    return tmp_path


@pytest.mark.parametrize(
    "words",
    [
        ("--seeds", "1", "--match", "best-first"),
        ("--mutants", "1"),
        ("--counterexamples", "--match", "last-hit-wins.cpp"),
    ],
)
@pytest.mark.parametrize("last", [False, True])
def test_an_edit_stops_a_run(
    monkeypatch: pytest.MonkeyPatch, places: Path, words: tuple[str, ...], last: bool
) -> None:
    """Before the first row, or after the last one: nothing is stored under either state."""
    asked = []

    def digest(without: Collection[str]) -> str:
        asked.append(without)
        return "edited" if not last or len(asked) > 1 else grader_digest(without)

    monkeypatch.setattr(state, "grader_digest", digest)
    result = CliRunner().invoke(cli, ["certify", *words])
    assert result.exit_code == 2, result.output
    assert "the grader was edited while it ran" in " ".join(result.output.split())
    kept = ["ledger"] if last else []
    assert sorted(path.name for path in places.iterdir()) == kept


def test_an_unchanged_grader_stores_what_it_decided(places: Path) -> None:
    """Under the state that it began with."""
    assert CliRunner().invoke(cli, ["certify", "--match", "best-first"]).exit_code == 0
    grader = grader_digest()
    assert matrix.stored_states() == {grader: 1}
    assert grader in (places / "ledger").read_text()
