"""Tests of grader/score/points.py and grader/score/tally.py: examples."""

from collections.abc import Sequence
from dataclasses import replace

import pytest

from grader.model.grade import CheckScore, Rubric
from grader.model.stages import Stop
from grader.model.verdict import Evidence, Example, Finding, Verdict
from grader.score.points import crashes_earn_nothing, final_score, score_checks, score_parts
from grader.score.rubric import load_rubric

BOXES = "bvh.boxes-are-tight"
READABLE = "bvh.is-readable"
SURVIVES = "bvh.survives-every-mesh"
STARTED = ("a", "b")


def rubric() -> Rubric:
    """Part a with three criteria: a gate, one of 4 points, one of 1 point."""
    kept = [one for one in load_rubric().criteria if one.check in {READABLE, BOXES, SURVIVES}]
    return replace(load_rubric(), criteria=tuple(kept))


def found(check: str, verdicts: str, reason: str = "") -> list[Finding]:
    """Make a finding a letter: Pass, Fail, Blocked, broKen, or `.` for a worker that died."""
    kinds = {"P": Verdict.PASS, "F": Verdict.FAIL, "B": Verdict.BLOCKED, "K": Verdict.BROKEN}
    return [
        Finding(check, f"case {number}", kinds[letter], Evidence(10, letter == "F"), reason)
        for number, letter in enumerate(verdicts)
        if letter != "."
    ]


def scored(findings: Sequence[Finding], cases: int, check: str = BOXES) -> CheckScore:
    """Score `check` where every check has this many planned cases."""
    planned = dict.fromkeys((READABLE, BOXES, SURVIVES), cases)
    checks = [(id, f"title of {id}") for id in planned]
    scores = score_checks(rubric(), checks, findings, planned, STARTED)
    return {score.check: score for score in scores}[check]


@pytest.mark.parametrize(
    ("verdicts", "points", "verdict"),
    [
        ("PPPPPPPP", 4.0, Verdict.PASS),
        ("PPPPPPPF", 3.5, Verdict.FAIL),
        ("PPPFFF..", 2.0, Verdict.FAIL),
        ("PFF.....", 1.0, Verdict.FAIL),
        ("PPPP....", 4.0, Verdict.PASS),
        ("PPP.....", 3.0, Verdict.BLOCKED),
        ("P.......", 1.0, Verdict.BLOCKED),
        ("FFFFFFFF", 0.0, Verdict.FAIL),
        ("........", 0.0, Verdict.BLOCKED),
    ],
)
def test_points_follow_the_share_of_cases(
    verdicts: str, points: float, verdict: Verdict
) -> None:
    """Passed over examined, but over no less than half of what was planned."""
    died = verdicts.replace("P", "p").replace("F", "p")
    ends = found(SURVIVES, died.replace("p", "P").replace(".", "F"))
    score = scored([*found(READABLE, "P"), *found(BOXES, verdicts), *ends], 8)
    assert (score.score, score.verdict) == (points, verdict)
    assert score.blocked_by == (SURVIVES if verdict is Verdict.BLOCKED else None)


@pytest.mark.parametrize(
    ("passed", "points"), [(99, 3.75), (100, 4.0), (50, 2.0), (49, 1.75), (1, 0.0)]
)
def test_points_are_rounded_down_to_quarters(passed: int, points: float) -> None:
    """One case in a hundred costs a quarter and not nothing."""
    verdicts = "P" * passed + "F" * (100 - passed)
    assert scored([*found(READABLE, "P"), *found(BOXES, verdicts)], 100).score == points


def test_a_case_blocked_by_a_failure_counts_as_not_passed() -> None:
    """The blocker is named."""
    findings = [*found(READABLE, "PPPF"), *found(BOXES, "PPPB", reason=READABLE)]
    score = scored(findings, 4)
    assert (score.score, score.verdict, score.blocked_by) == (3.0, Verdict.BLOCKED, READABLE)
    assert "1 of 4 cases, first in `case 3`" in score.message


def test_a_chain_of_blocks_ends_at_the_failure() -> None:
    """Blocked by a check that is itself blocked: the one that failed is named."""
    findings = [
        *found(SURVIVES, "PF"),
        *found(READABLE, "PB", reason=SURVIVES),
        *found(BOXES, "PB", reason=READABLE),
    ]
    assert scored(findings, 2).blocked_by == SURVIVES


@pytest.mark.parametrize("blocker", ["K", "P", "."])
def test_a_case_blocked_by_no_failure_is_our_fault(blocker: str) -> None:
    """Blocked by BROKEN, by a pass, or by nothing: withheld, and counted in favour."""
    findings = [*found(READABLE, blocker + "P"), *found(BOXES, "BP", reason=READABLE)]
    score = scored(findings, 2)
    assert (score.verdict, score.score) == (Verdict.BROKEN, 4.0)


def test_blocks_in_a_circle_are_our_fault() -> None:
    """Two checks that block each other end the search."""
    findings = [*found(READABLE, "B", reason=BOXES), *found(BOXES, "B", reason=READABLE)]
    assert scored(findings, 1).verdict is Verdict.BROKEN


def test_a_gate_that_passes_nowhere_takes_the_part() -> None:
    """A pass behind it becomes BLOCKED by the gate; a failure stays one."""
    findings = [*found(READABLE, "FF"), *found(BOXES, "PP"), *found(SURVIVES, "PF")]
    boxes, survives = scored(findings, 2), scored(findings, 2, SURVIVES)
    assert (boxes.score, boxes.verdict, boxes.blocked_by) == (0, Verdict.BLOCKED, READABLE)
    assert (survives.score, survives.verdict) == (0, Verdict.FAIL)


@pytest.mark.parametrize("gate", ["PF", "KF"])
def test_a_gate_that_passes_once_is_open(gate: str) -> None:
    """Also one that could only be undecided by our own fault."""
    assert scored([*found(READABLE, gate), *found(BOXES, "PP")], 2).score == 4


@pytest.mark.parametrize(
    ("gate", "earned"),
    [("PAAA", 0), ("PAAF", 4), ("PFFFFF", 4), ("PKAAAAA", 4), ("PBAAAAAAA", 0)],
)
def test_a_gate_that_is_mostly_bypassed_is_closed(gate: str, earned: float) -> None:
    """Nobody opens it by the smallest case, going Around all others; a failure is no such way.

    Our own fault does not close it.
    """
    around = Evidence(1, 1, bypassed=True)
    findings = [
        *found(SURVIVES, "F" * len(gate)),
        *found(READABLE, gate.replace("A", "F"), reason=SURVIVES),
        *found(BOXES, "PP"),
    ]
    findings = [
        replace(each, evidence=around)
        if each.check == READABLE and gate[int(each.case.split()[1])] == "A"
        else each
        for each in findings
    ]
    checks = [(READABLE, "readable"), (BOXES, "boxes"), (SURVIVES, "survives")]
    plan = {READABLE: 4, BOXES: 2}
    boxes = score_checks(rubric(), checks, findings, plan, STARTED)[1]
    assert boxes.score == earned
    assert ("fails nearly everywhere" in boxes.message) == (not earned)


@pytest.mark.parametrize(("boxes", "verdict"), [("P", Verdict.BLOCKED), ("F", Verdict.FAIL)])
def test_crashes_alone_earn_nothing(boxes: str, verdict: Verdict) -> None:
    """Where it ends well it does what the given code does; what failed is still told."""
    findings = [*found(READABLE, "P"), *found(BOXES, boxes), *found(SURVIVES, "F")]
    checks = [(READABLE, "readable"), (BOXES, "boxes"), (SURVIVES, "survives")]
    plan = dict.fromkeys((READABLE, BOXES, SURVIVES), 1)
    scores = score_checks(rubric(), checks, findings, plan, STARTED)
    assert crashes_earn_nothing(scores, {"b"}) == scores
    scores = crashes_earn_nothing(scores, {"a"})
    assert not sum(one.score for one in scores)
    assert scores[1].verdict is verdict
    assert scores[2].verdict is Verdict.FAIL


def test_a_gate_that_nobody_lived_to_see_is_closed() -> None:
    """Every worker died: the gate is blocked by that, and everything else by the gate."""
    ends = found(SURVIVES, "FF")
    gate, boxes = scored(ends, 2, READABLE), scored(ends, 2)
    assert (gate.verdict, gate.blocked_by) == (Verdict.BLOCKED, SURVIVES)
    assert (boxes.verdict, boxes.blocked_by) == (Verdict.BLOCKED, READABLE)


@pytest.mark.parametrize(("gate", "earned"), [("", 4), ("F", 0), ("B", 0)])
def test_a_gate_without_a_plan_closes_by_a_failure_only(gate: str, earned: float) -> None:
    """That nobody asked is no reason to take a part's points."""
    checks = [(READABLE, "readable"), (BOXES, "boxes"), (SURVIVES, "survives")]
    findings = [
        *found(SURVIVES, "F" * len(gate)),
        *found(READABLE, gate, reason=SURVIVES),
        *found(BOXES, "P"),
    ]
    scores = score_checks(rubric(), checks, findings, {BOXES: 1}, STARTED)
    assert scores[1].score == earned


def test_odd_points_are_earned_in_full() -> None:
    """A weight that is no multiple of a quarter is not rounded if every case passes."""
    tenth = replace(next(one for one in rubric().criteria if one.check == BOXES), points=0.1)
    weighed = replace(rubric(), criteria=(tenth,))
    checks = [(BOXES, "boxes")]
    for verdicts, earned in (("PP", 0.1), ("PF", 0.0)):
        (score,) = score_checks(weighed, checks, found(BOXES, verdicts), {BOXES: 2}, STARTED)
        assert score.score == earned


def test_what_does_not_compile_earns_nothing_in_both_parts() -> None:
    """Every other check is BLOCKED by the build, though nothing else was planned."""
    full = load_rubric()
    checks = [(one.check, "title") for one in full.criteria]
    failed = [Finding("build.compiles", "build", Verdict.FAIL, Evidence(1, 1))]
    first, *others = score_checks(full, checks, failed, {"build.compiles": 1}, STARTED)
    assert first.verdict is Verdict.FAIL
    assert {(one.verdict, one.score, one.blocked_by) for one in others} == {
        (Verdict.BLOCKED, 0.0, "build.compiles")
    }
    assert final_score((first, *others)) == 0


def test_a_part_that_was_not_started_earns_and_blames_nothing() -> None:
    """Neither passes nor failures of the given code are the student's."""
    findings = [*found(READABLE, "PP"), *found(BOXES, "PF")]
    checks = [(READABLE, "readable"), (BOXES, "boxes")]
    scores = score_checks(rubric(), checks, findings, {READABLE: 2, BOXES: 2}, ("b",))
    assert {(one.verdict, one.score) for one in scores} == {(Verdict.BLOCKED, 0.0)}
    assert "not started" in scores[1].message
    a, b = score_parts(rubric(), scores, ("b",))
    assert (a.score, a.max_score, a.started) == (0, 4, False)
    assert (b.score, b.max_score, b.started) == (0, 0, True)


def test_the_first_failure_is_worded_with_counts() -> None:
    """Message, expected, got, line and stop are those of the first failing case."""
    wrong = Evidence(
        524_287, 2, (Example("node 5: too wide", "4", "6"),), Stop.CRASHED, line=41
    )
    other = Evidence(10, 1, tuple(Example(f"other {number}") for number in range(3)))
    findings = [
        *found(READABLE, "P"),
        Finding(BOXES, "cube", Verdict.FAIL, wrong),
        Finding(BOXES, "grid", Verdict.FAIL, other),
    ]
    score = scored(findings, 2)
    expected = "3 of 524,297 wrong, first in `cube`: node 5: too wide"
    assert score.message == expected
    assert (score.expected, score.got, score.line) == ("4", "6", 41)
    assert score.stop is Stop.CRASHED
    assert [one.message for one in score.examples] == ["node 5: too wide", "other 0", "other 1"]
    assert score.cases == (("cube", Verdict.FAIL), ("grid", Verdict.FAIL))


def test_a_check_without_anything_to_see_fails() -> None:
    """A tree that is only a root has no split to judge: that is no pass, and not our fault."""
    score = scored([*found(READABLE, "PPPP"), *found(SURVIVES, "PPPP")], 4)
    assert (score.verdict, score.score) == (Verdict.FAIL, 0)
    assert "only 0 of 4 cases" in score.message


def test_a_check_without_any_plan_is_our_fault() -> None:
    """No submission can empty the plan."""
    score = scored([*found(READABLE, "P")], 0)
    assert score.verdict is Verdict.BROKEN
    assert final_score([score]) is None


def test_a_dropped_criterion_is_not_reported() -> None:
    """Only what the rubric names appears, in the order of the checks."""
    full = load_rubric()
    checks = [(one.check, "title") for one in reversed(full.criteria)]
    scores = score_checks(rubric(), checks, [], {}, STARTED)
    assert [one.check for one in scores] == [SURVIVES, BOXES, READABLE]


def test_a_case_may_forfeit_all_points() -> None:
    """Seven cases of eight are right, and the eighth leaves nothing of them."""
    *right, wrong = found(BOXES, "PPPPPPPF")
    evidence = replace(wrong.evidence, forfeits=True)
    score = scored([*right, replace(wrong, evidence=evidence)], 8)
    assert (score.verdict, score.score) == (Verdict.FAIL, 0.0)
