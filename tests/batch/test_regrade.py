"""A new rubric, seed or grader: who would change, and why, is shown before it is applied."""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch.comparison import compared, lines, provenance_changes
from grader.batch.job import Job
from grader.batch.store import opened_store
from grader.cli.batch import regraded
from grader.errors import UsageError
from grader.report.as_json import to_json
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import SETTINGS, begun, job
from tests.report import samples


def test_equal_results_do_not_differ() -> None:
    """Times and processors may be others."""
    before = to_json(samples.perfect())
    after = before | {"timing": {}, "provenance": {}}
    assert compared(before, after) is None


def test_a_change_names_its_checks_and_why() -> None:
    """Only those that end otherwise."""
    change = compared(to_json(samples.perfect()), to_json(samples.failing()))
    assert change is not None
    first, *checks = lines(change)
    assert first.startswith("50 of 50 -> ")
    assert [line.partition(":")[0] for line in checks] == [
        "bvh.children-partition-their-parent",
        "bvh.boxes-are-tight",
        "hits.closest-wins",
        "hits.survives-every-ray",
    ]
    assert "it waits for bvh.boxes-are-tight" in checks[0]
    assert "reaches out" in checks[1]


def test_other_points_for_the_same_are_named() -> None:
    """The verdict is the same, and the rubric is another one."""
    before = to_json(samples.perfect())
    checks = [dict(one) for one in before["checks"]]
    checks[4] |= {"score": 8, "max_score": 8}
    change = compared(before, before | {"checks": checks, "score": 49, "max_score": 49})
    assert change is not None
    assert lines(change)[1:] == [
        "bvh.children-partition-their-parent: pass 9 of 9 -> pass 8 of 8: "
        "it is worth something else"
    ]


def test_parts_of_a_provenance_that_differ_are_named() -> None:
    """The processor may be another one: it decides nothing."""
    before = to_json(samples.perfect())["provenance"]
    after = before | {"seed": 7, "cpu": "another", "flags": ["-O0"]}
    changes = provenance_changes(before, after)
    assert [one.partition(":")[0] for one in changes] == ["seed", "flags"]


@pytest.fixture
def new(tmp_path: Path, log: Path) -> Job:
    """Other settings for a class that was graded already, of which one would change."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "moody", "cy.cpp": " "})
    old = job(tmp_path / "out")
    grade(path, old)
    settings, wish = replace(SETTINGS, seed=7), replace(old.wish, seed=7)
    return replace(old, settings=settings, wish=wish, preview=True)


def test_nothing_changes_before_it_is_applied(
    new: Job, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is said who would change, in which check, and why."""
    assert regraded(new, apply=False) == 0
    said = capsys.readouterr().out
    assert "seed: 41 -> 7" in said
    assert "bob: 50 of 50 -> " in said
    assert "bvh.boxes-are-tight: pass 12 of 12 -> fail " in said
    assert "ada: " not in said
    assert points(new.folder) == {"ada": 50, "bob": 50, "cy": 0}
    with opened_store(new.folder) as store:
        assert store.current() == SETTINGS


def test_what_was_shown_is_applied(new: Job, log: Path) -> None:
    """Without grading again; the results of before stay in the store."""
    regraded(new, apply=False)
    graded = len(begun(log))
    assert regraded(new, apply=True) == 0
    assert len(begun(log)) == graded
    found = points(new.folder)
    assert found["ada"] == 50
    assert found["bob"] not in (0, 50, None)
    with opened_store(new.folder) as store:
        assert store.current() == new.settings
        bob = next(one for one in store.students() if one.name == "bob")
        assert store.result(bob.sha256 or "", SETTINGS) is not None


def test_what_could_not_be_graded_anew_keeps_all_as_it_is(tmp_path: Path, log: Path) -> None:
    """Half of a class by other rules would be unfair."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "die once", "bob.cpp": CODE})
    out = tmp_path / "out"
    grade(path, job(out))
    log.unlink()
    with opened_store(out) as store:
        ada = next(store.students())
        store.put(replace(ada, sha256="0" * 64, path="exercise03.cpp"), b"raise")
    old = job(out)
    new = replace(old, settings=replace(SETTINGS, seed=7), preview=True)
    assert regraded(new, apply=True) == 3
    with opened_store(out) as store:
        assert store.current() == SETTINGS


def test_there_has_to_be_something_to_compare_with(tmp_path: Path) -> None:
    """A mistyped folder."""
    with pytest.raises(UsageError, match="no results yet"):
        regraded(job(tmp_path), apply=False)
