"""A scene's weight is how many cases it counts for; a hidden scene is counted and not told."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import pytest

from grader.model.grade import CheckScore
from grader.model.verdict import Evidence, Example, Finding, Verdict
from grader.score.points import score_checks
from grader.score.rubric import load_rubric
from grader.score.tally import Tally

IMAGE = "image.equals-mitsuba"


def finding(case: str, verdict: Verdict, weight: float = 1.0, shown: bool = True) -> Finding:
    """Make what the check of pictures says of one scene."""
    wrong = verdict is Verdict.FAIL
    evidence = Evidence(100, 5 * wrong, (Example(f"in {case}", "1", "2"),) * wrong)
    return Finding(IMAGE, case, verdict, evidence, weight=weight, shown=shown)


def scored(findings: Sequence[Finding], planned: Fraction | int) -> CheckScore:
    """Score the check of pictures, worth 4 points here."""
    (only,) = (one for one in load_rubric().criteria if one.check == IMAGE)
    rubric = replace(load_rubric(), criteria=(replace(only, points=4.0),))
    (score,) = score_checks(rubric, [(IMAGE, "title")], findings, {IMAGE: planned}, ("b",))
    return score


@pytest.mark.parametrize(
    ("weights", "wrong", "points"),
    [
        ((1, 1, 1, 1), 0, 3.0),
        ((3, 1, 1, 1), 0, 2.0),
        ((3, 1, 1, 1), 1, 3.25),
        ((0.5, 0.5, 0.5, 0.5), 0, 3.0),
        ((0.1, 0.1, 0.1, 0.1), 3, 3.0),
        ((0.01, 100, 1, 1), 0, 3.75),
        ((100, 0.01, 1, 1), 0, 0.0),
    ],
)
def test_points_follow_the_weights(weights: Sequence[float], wrong: int, points: float) -> None:
    """Of four scenes one is wrong; and however little it counts, not all is earned."""
    findings = [
        finding(f"scene {k}", Verdict.FAIL if k == wrong else Verdict.PASS, weight)
        for k, weight in enumerate(weights)
    ]
    score = scored(findings, Fraction(sum(map(Fraction, weights))))
    assert (score.score, score.verdict) == (points, Verdict.FAIL)
    right = [replace(one, verdict=Verdict.PASS) for one in findings]
    assert scored(right, Fraction(sum(map(Fraction, weights)))).score == 4.0


def test_half_of_what_was_planned_is_measured_by_weight() -> None:
    """One heavy scene is more than half of the plan, three light ones are less."""
    heavy = scored([finding("heavy", Verdict.PASS, 6.0)], 9)
    light = scored([finding(f"light {k}", Verdict.PASS) for k in range(3)], 9)
    assert (heavy.score, heavy.verdict) == (4.0, Verdict.PASS)
    assert (light.score, light.verdict) == (2.5, Verdict.FAIL)
    assert light.message.startswith("only 3 of 9 cases could be examined")


def test_tenths_are_exact() -> None:
    """Ten tenths are one, so that rounding takes a quarter from nobody."""
    passed = tuple(finding(f"{k}", Verdict.PASS, 0.1) for k in range(10))
    assert Tally(passed, (), (), (), 1).share == 1
    assert Tally(passed[:3], passed[3:], (), (), 1).share == Fraction(3, 10)


def test_exactly_half_suffices_however_it_adds_up() -> None:
    """In binary three tenths are more than 0.3, and half of them would be too few."""
    planned = sum((Fraction("0.1") for _ in range(6)), Fraction(0))
    passed = tuple(finding(f"{k}", Verdict.PASS, 0.1) for k in range(3))
    assert Tally(passed, (), (), (), planned).suffices


def test_a_hidden_scene_is_counted_and_not_told() -> None:
    """Neither its name nor what is wrong in it; a visible one that fails is told instead."""
    hidden = finding("trap", Verdict.FAIL, shown=False)
    alone = scored([finding("open", Verdict.PASS), hidden], 2)
    assert (alone.score, alone.wrong) == (2.0, 5)
    assert alone.message == "wrong in a case that is not shown"
    assert (alone.examples, alone.expected, alone.got) == ((), "", "")
    both = scored([hidden, finding("open", Verdict.FAIL)], 2)
    assert both.message == "5 of 100 wrong, first in `open`: in open"
    assert [example.message for example in both.examples] == ["in open"]
    passed = scored([finding("open", Verdict.PASS), replace(hidden, verdict=Verdict.PASS)], 2)
    assert passed.message == "in 1 case"
