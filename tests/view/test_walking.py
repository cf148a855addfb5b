"""Which t is wrong follows from the rule of closest hits, and from nothing else."""

from dataclasses import replace
from typing import cast

import numpy as np
import pytest

from grader.model.mesh import EDGE, SOLID, WILD, Answers
from grader.model.path import Path
from grader.model.trials import AlteredTrial, RepeatTrial, TraceTrial, Trial
from grader.view.walking import Followed, Walk, unanswered, walk_of
from tests.verify.builder import build, soup
from tests.view.found import trials

MESH = soup(30)
TREE = build(MESH)
RAY = np.array([-6, 0, 0, 1, 0, 0, 0, np.inf], np.float32)
MISS = float("inf")


def one(kind: type[Trial]) -> Trial:
    """Give a trial of a kind."""
    return next(each for each in trials() if isinstance(each, kind))


def found(t: float) -> Path:
    """Return a t without a single test."""
    none, rows = np.zeros(0, np.bool_), np.zeros(0, np.float32)
    corners = np.zeros((0, 9), np.float32)
    return Path(none, none, np.zeros(0, np.uint32), rows, rows, rows, corners, t, 0)


def walk(trial: Trial, t: float) -> Walk:
    """Return a t for the second ray of a trial."""
    return walk_of(MESH, TREE, found(t), Followed(RAY, "ray 1", trial, 1))


def of_second(*candidates: tuple[float, int]) -> Answers:
    """Know t and kind of the candidates of the second ray; the first has one at 1."""
    t = np.array([1.0, *(each for each, _ in candidates)])
    kind = np.array([SOLID, *(each for _, each in candidates)], np.uint8)
    sure = [each + 0.1 for each, what in candidates if what == SOLID]
    limit = np.array([1.1, min(sure, default=np.inf)])
    first = np.array([0, 1, 1 + len(candidates)])
    face = np.arange(len(t))
    return Answers(limit, first, face, t, np.full(len(t), 0.1), kind)


def plain(*candidates: tuple[float, int]) -> Trial:
    """Ask for closest hits."""
    return replace(cast("TraceTrial", one(TraceTrial)), answers=of_second(*candidates))


@pytest.mark.parametrize("t", [3.0, 5.0, 5.09])
def test_where_two_are_right_neither_is_wrong(t: float) -> None:
    """A face that is met at its edge may be hit or not, within its own tolerance."""
    told = walk(plain((3.0, EDGE), (5.0, SOLID)), t)
    assert told.wrong is False
    assert told.expected is None


@pytest.mark.parametrize(("t", "wrong"), [(7.0, False), (8.0, False), (MISS, True)])
def test_where_float_cannot_decide_nothing_is_wrong(t: float, wrong: bool) -> None:
    """But a sure hit may still be missed."""
    told = walk(plain((7.5, WILD), (7.9, SOLID)), t)
    assert told.wrong == wrong
    assert told.expected == (7.9 if wrong else None)


@pytest.mark.parametrize(
    ("t", "wrong"), [(5.0, False), (5.2, True), (4.8, True), (MISS, True), (np.nan, True)]
)
def test_a_sure_hit_is_expected(t: float, wrong: bool) -> None:
    """Another t is wrong, and so is none."""
    told = walk(plain((5.0, SOLID)), t)
    assert told.wrong == wrong
    assert told.expected == 5.0


def test_a_miss_is_expected_where_nothing_is() -> None:
    """A hit there is wrong."""
    assert walk(plain(), MISS).wrong is False
    told = walk(plain(), 2.0)
    assert told.wrong
    assert told.expected == MISS


@pytest.mark.parametrize(
    ("t", "wrong"), [(5.0, True), (9.0, False), (4.0, False), (MISS, False), (np.nan, False)]
)
def test_of_a_face_that_is_gone_only_its_hit_is_wrong(t: float, wrong: bool) -> None:
    """What lies behind it may be hit, and nobody knows what that is."""
    trial = cast("AlteredTrial", one(AlteredTrial))
    lost = np.array([False, True])
    trial = replace(trial, answers=of_second((5.0, SOLID)), lost=lost)
    told = walk(trial, t)
    assert told.wrong == wrong
    assert told.expected is None
    assert unanswered(Followed(RAY, "ray 1", trial, 1)).expected is None


def test_whoever_does_not_come_back_is_wrong() -> None:
    """What is right is told all the same, also of rays that are traced again."""
    trial = replace(cast("RepeatTrial", one(RepeatTrial)), answers=of_second((5.0, SOLID)))
    told = unanswered(Followed(RAY, "ray 1", trial, 1))
    assert told.wrong
    assert told.expected == 5.0


@pytest.mark.parametrize(
    ("expected", "t", "wrong"), [(None, 2.0, None), (2.0, 2.0, False), (2.0, 3.0, True)]
)
def test_a_pixel_is_held_against_the_model_solution(
    expected: float | None, t: float, wrong: bool | None
) -> None:
    """If that has traced it."""
    told = walk_of(MESH, TREE, found(t), Followed(RAY, "pixel", expected=expected))
    assert told.wrong == wrong
    assert told.expected == expected
