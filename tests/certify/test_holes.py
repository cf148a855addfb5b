"""Every way in which a grader can be wrong is found in the rows of its corpus."""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.certify.corpus import Wrong
from grader.certify.holes import Hole, Kind, differing_seeds, holes, without_killer
from grader.certify.row import Row
from grader.score.rubric import load_rubric

RIGHT = Row("right/good.cpp", "1", 41, (25.0, 25.0), ())
WRONG = Row("wrong/bad.cpp", "2", 41, (20.0, 25.0), ("bvh.boxes-are-tight",))
PROMISE = Wrong(Path("wrong/bad.cpp"), ("bvh.boxes-are-tight",), "b")


def kinds(*rows: Row) -> list[Kind]:
    """Say what these rows show."""
    return [hole.kind for hole in holes(rows, [PROMISE])]


def test_a_grader_without_a_hole() -> None:
    """The right one keeps everything, the wrong one fails its own check, in its own part."""
    assert kinds(RIGHT, WRONG) == []


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        (replace(RIGHT, scores=(25.0, 24.75)), Kind.FALSE_REJECT),
        (replace(WRONG, scores=(25.0, 25.0)), Kind.FALSE_ACCEPT),
        (replace(WRONG, failed=("bvh.is-readable",)), Kind.UNSEEN),
        (replace(WRONG, scores=(20.0, 24.0)), Kind.LEAK),
        (replace(RIGHT, broken=("hits.special-rays",)), Kind.UNDECIDED),
    ],
)
def test_a_hole_is_found(row: Row, kind: Kind) -> None:
    """One row that is not as its file promises is one hole of that kind."""
    assert kinds(row) == [kind]


def test_two_runs_that_differ() -> None:
    """Of one seed they are a hole; of two seeds they are luck."""
    other = replace(WRONG, failed=(*WRONG.failed, "bvh.is-readable"))
    assert kinds(WRONG, other) == [Kind.UNSTEADY]
    assert kinds(WRONG, replace(other, seed=42)) == []
    assert differing_seeds([WRONG, replace(other, seed=42)]) == [WRONG.name]


def test_an_undecided_row_that_was_decided_later() -> None:
    """A machine that was too busy once is no hole once the row has been graded."""
    busy = replace(RIGHT, scores=(), broken=("stood in line",))
    assert kinds(busy, RIGHT) == []


def test_a_check_without_a_killer() -> None:
    """Only the check that owns a mistake, and sees it with every seed, has a killer."""
    every = {Hole(Kind.WITHOUT_KILLER, one.check) for one in load_rubric(None).criteria}
    own = Hole(Kind.WITHOUT_KILLER, "bvh.boxes-are-tight")
    assert every - set(without_killer([WRONG], [PROMISE])) == {own}
    lucky = replace(WRONG, seed=42, failed=())
    assert set(without_killer([WRONG, lucky], [PROMISE])) == every
