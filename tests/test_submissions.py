"""Right submissions earn everything, wrong ones lose what their mistake touches, no more."""

import json
from pathlib import Path

import pytest

from grader.certify.corpus import (
    Wrong,
    corpus_folder,
    digest_of,
    every_submission,
    name_of,
    right_submissions,
    wrong_submissions,
)
from grader.certify.matrix import SEED, line_of, stored_lines
from grader.certify.row import graded_row
from grader.certify.sample import killers
from grader.kept import kept, write_result
from grader.model.stages import Further
from grader.model.verdict import Verdict
from grader.options import Options
from grader.pipeline import grade_one
from grader.resources import reference_source
from grader.score.rubric import load_rubric
from grader.selection import select

FULL = "25"
WRONG = wrong_submissions()
KILLERS = killers()

DIFFERENT = ("literals-and-german-comments", "parallel-levels", "strategy-pattern")
"""Right files: a literal 20 for the depth limit, threads, and virtual functions."""


WHOLE = ("boxes-padded", "first-hit-wins", "face-indices-count-from-one")


def verdicts(path: Path, *checks: str) -> dict[str, Verdict]:
    """Grade a file for some checks only."""
    grade = grade_one(path, Options(SEED, None, checks, lambda *_: None))
    return {one.check: one.verdict for one in grade.checks if one.check in checks}


def drawn(path: Path, folder: Path, *checks: str) -> dict[str, Verdict]:
    """Grade a file as `bvhgrade grade` does, and write all that belongs to the result."""
    options = Options(SEED, None, checks, lambda *_: None, counterexamples=True, views=True)
    grade = grade_one(path, options)
    write_result(folder, kept(grade), "de")
    assert (folder / "report.html").stat().st_size > 0
    return {one.check: one.verdict for one in grade.checks if one.check in (checks or KILLERS)}


def checks_by_build() -> dict[frozenset[Further], list[str]]:
    """Group the checks by what is compiled for one of them alone."""
    groups: dict[frozenset[Further], list[str]] = {}
    for check in KILLERS:
        groups.setdefault(select(None, (check,)).further, []).append(check)
    return groups


@pytest.mark.parametrize("check", KILLERS)
def test_a_wrong_submission_fails_its_own_check(check: str, tmp_path: Path) -> None:
    """Also if nothing else is graded; `bvhgrade certify --sample` grades it as a whole.

    All that a report shows of it is drawn and written.
    """
    assert drawn(KILLERS[check].path, tmp_path, check) == {check: Verdict.FAIL}


@pytest.mark.parametrize("name", WHOLE)
def test_a_whole_result_is_written(name: str, tmp_path: Path) -> None:
    """A scene with a wrong box, one with a wrong pixel, and one whose tree is unreadable."""
    path = corpus_folder() / "wrong" / f"{name}.cpp"
    failed = {id for id, one in drawn(path, tmp_path).items() if one is Verdict.FAIL}
    line = stored_lines()[name_of(path)]
    assert failed == {check for check in KILLERS if line[check] == "F"}


@pytest.mark.parametrize(
    ("name", "verdict"),
    [
        ("right/exceptions-mark-the-leaves", Verdict.PASS),
        ("wrong/longest-side-is-a-dangling-reference", Verdict.FAIL),
    ],
)
def test_sanitizers_know_the_stack_in_a_box(name: str, verdict: Verdict) -> None:
    """There is no /proc to read it from: frames that are gone are told from those in use."""
    path = corpus_folder() / f"{name}.cpp"
    assert verdicts(path, "bvh.memory-is-safe") == {"bvh.memory-is-safe": verdict}


def test_two_runs_say_the_same_of_a_mistake(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Words, examples and small inputs; only what was measured, and the processor, may differ.

    On a busy machine the search for a small input is given up, so it is given time here.
    """
    monkeypatch.setattr("grader.counterexample.search.CHECK_SECONDS", 60.0)
    path = corpus_folder() / "wrong" / "first-hit-wins.cpp"
    found = []
    for folder in (tmp_path / "first", tmp_path / "second"):
        verdicts = drawn(path, folder, "hits.closest-wins", "hits.special-rays")
        assert set(verdicts.values()) == {Verdict.FAIL}
        result = json.loads((folder / "result.json").read_text())
        assert all(one["counterexample"] for one in result["checks"] if one["wrong"])
        del result["timing"], result["provenance"]["cpu"]
        found.append(result)
    assert found[0] == found[1]


@pytest.mark.parametrize("further", checks_by_build(), ids=lambda one: f"{len(one)} builds")
def test_the_reference_passes_the_same_checks(further: frozenset[Further]) -> None:
    """With the same builds as the wrong ones."""
    checks = checks_by_build()[further]
    assert select(None, checks).further == further
    assert verdicts(reference_source(), *checks) == dict.fromkeys(checks, Verdict.PASS)


@pytest.mark.parametrize("name", DIFFERENT)
def test_a_right_submission_earns_everything(name: str) -> None:
    """50 of 50, whatever allowed reading of the sheet it takes; and the matrix says so."""
    path = corpus_folder() / "right" / f"{name}.cpp"
    graded = graded_row(path, SEED)
    assert sum(graded.scores) == 50, sorted(graded.failed)
    assert line_of(graded) == stored_lines()[name_of(path)]


def test_the_matrix_is_of_these_files() -> None:
    """Whoever edits a submission writes the matrix anew.

    What the grader says of them today, `bvhgrade certify` asks: a sample in each run of CI.
    """
    stored = {name: line["sha256"] for name, line in stored_lines().items()}
    assert stored == {name_of(path): digest_of(path) for path in every_submission()}


def test_every_check_has_a_killer() -> None:
    """For each check there is a mistake that it owns."""
    assert set(KILLERS) == {criterion.check for criterion in load_rubric(None).criteria}


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: wrong.path.stem)
def test_the_matrix_keeps_what_the_file_promises(wrong: Wrong) -> None:
    """The named checks fail, points are lost, the untouched part keeps all of its own."""
    line = stored_lines()[name_of(wrong.path)]
    assert [line[check] for check in wrong.checks] == ["F"] * len(wrong.checks)
    assert float(line["a"]) + float(line["b"]) < 50
    if wrong.untouched != "-":
        assert line[wrong.untouched] == FULL
    assert "!" not in line.values()


def test_there_are_enough_of_them() -> None:
    """At least 40 right ones and 120 wrong ones."""
    assert len(right_submissions()) >= 40
    assert len(WRONG) >= 120
