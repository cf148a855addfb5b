"""The quick run finds most mistakes, and leaves out what takes long."""

import csv
from pathlib import Path

from grader.model.cases import BuildCase, SourceCase
from grader.options import Options
from grader.quick import BEST, CHECKS, LARGEST_FACES, is_quick, quick_checks
from grader.run.trials import is_sanitized
from grader.selection import quickest, select
from grader.verify.planned import kinds_of
from tests.own_files import ROOT
from tests.test_selection import hiding
from tests.verify.trials import construct, every_trial

MATRIX = ROOT / "tests" / "submissions" / "kill-matrix.csv"


def killed() -> dict[str, set[str]]:
    """Which wrong submissions each check fails, by the stored matrix."""
    with MATRIX.open() as file:
        rows = [row for row in csv.DictReader(file) if row["submission"].startswith("wrong/")]
    return {
        check: {row["submission"] for row in rows if row[check]}
        for check in rows[0]
        if "." in check
    }


def test_each_check_finds_more_than_the_next() -> None:
    """The order is the matrix's: what adds most comes first."""
    left = set().union(*killed().values())
    added = []
    for check in CHECKS[:BEST]:
        added.append(len(killed()[check] & left))
        left -= killed()[check]
    assert added == sorted(added, reverse=True)
    assert min(added) > 5


def test_the_rest_finds_something_more() -> None:
    """Those behind the ten best find what none of these finds anywhere."""
    known = set().union(*(killed()[check] for check in CHECKS[:BEST]))
    assert set().union(*(killed()[check] for check in CHECKS[BEST:])) - known


def test_whole_runs_of_the_quick_checks_find_most_mistakes() -> None:
    """With the gates at least seven in eight of all wrong submissions fail one of them.

    The matrix is of whole runs; how many fail on the small meshes, `grader/quick.py` says.
    """
    matrix = killed()
    gates = {one.check for one in select(None, ()).rubric.criteria if one.gate}
    found = set().union(*(matrix[check] for check in {*CHECKS, *gates}))
    assert len(found) >= 7 / 8 * len(set().union(*matrix.values()))


def test_every_quick_check_has_something_to_look_at() -> None:
    """The short trials alone give each of them a case."""
    short = [trial for trial in every_trial() if is_quick(trial)]
    kinds = {kind for trial in short for kind in kinds_of(trial)} | {BuildCase, SourceCase}
    for each in select(None, CHECKS).checks:
        assert each.kind in kinds, each.id
    assert all(not is_sanitized(trial) for trial in short)


def test_large_meshes_are_left_out() -> None:
    """Whatever is done with them."""
    assert is_quick(construct(9))
    assert not is_quick(construct(LARGEST_FACES + 1))


def test_a_rubric_may_hide_some(tmp_path: Path) -> None:
    """What a student is not to see is not run either."""
    rubric = hiding(tmp_path, CHECKS[0])
    assert CHECKS[0] not in quickest(rubric, for_student=True)
    assert quickest(None, for_student=True) == CHECKS
    assert quick_checks(["image.equals-mitsuba"]) == ()


def test_nobody_gets_it_unasked() -> None:
    """A grade runs everything."""
    assert Options.__dataclass_fields__["quick"].default is False
