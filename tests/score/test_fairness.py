"""Properties of grader/score/points.py that hold for all findings whatsoever."""

from dataclasses import replace

from hypothesis import assume, given
from hypothesis import strategies as st

from grader.model.grade import CheckScore
from grader.model.verdict import Evidence, Finding, Verdict
from grader.score.points import final_score, score_checks, score_parts
from grader.score.rubric import load_rubric

RUBRIC = load_rubric()
CHECKS = [(one.check, "title") for one in RUBRIC.criteria]
IDS = [id for id, _ in CHECKS]

_finding = st.builds(
    Finding,
    check=st.sampled_from(IDS),
    case=st.sampled_from("pqrs"),
    verdict=st.sampled_from(Verdict),
    evidence=st.builds(Evidence, examined=st.integers(0, 9), wrong=st.integers(0, 3)),
    reason=st.sampled_from(IDS),
)
findings_of = st.lists(
    _finding, max_size=60, unique_by=lambda finding: (finding.check, finding.case)
)
plans = st.dictionaries(st.sampled_from(IDS), st.integers(0, 6))
started_parts = st.sampled_from([(), ("a",), ("b",), ("a", "b")])


def scored(
    findings: list[Finding], planned: dict[str, int], started: tuple[str, ...] = ("a", "b")
) -> dict[str, CheckScore]:
    """Score by the shipped rubric."""
    scores = score_checks(RUBRIC, CHECKS, findings, planned, started)
    return {score.check: score for score in scores}


@given(findings_of, plans, started_parts)
def test_points_stay_within_bounds(
    findings: list[Finding], planned: dict[str, int], started: tuple[str, ...]
) -> None:
    """No check and no part earns less than nothing or more than it is worth, in quarters."""
    scores = scored(findings, planned, started)
    parts = score_parts(RUBRIC, list(scores.values()), started)
    earned = [(one.score, one.max_score) for one in scores.values()]
    earned += [(one.score, one.max_score) for one in parts]
    for score, most in earned:
        assert 0 <= score <= most
        assert score * 4 == int(score * 4)
    total = final_score(scores.values())
    assert total is None or total == sum(part.score for part in parts)
    assert all(not part.score for part in parts if part.part not in started)


@given(findings_of, plans)
def test_nothing_passes_unseen(findings: list[Finding], planned: dict[str, int]) -> None:
    """A pass has looked at something, saw nothing wrong, and is full."""
    for one in scored(findings, planned).values():
        if one.verdict is Verdict.PASS:
            assert one.examined > 0
            assert one.score == one.max_score
            assert {verdict for _, verdict in one.cases} == {Verdict.PASS}


@given(findings_of, plans)
def test_full_points_are_earned(findings: list[Finding], planned: dict[str, int]) -> None:
    """Whoever earns all points passes, unless our own fault decided in favour."""
    for one in scored(findings, planned).values():
        if one.max_score and one.score == one.max_score:
            assert one.verdict in {Verdict.PASS, Verdict.BROKEN}


@given(findings_of, plans, st.data())
def test_a_fault_of_ours_never_lowers_points(
    findings: list[Finding], planned: dict[str, int], data: st.DataObject
) -> None:
    """Whatever finding becomes BROKEN, no check earns less, and the sum is withheld."""
    assume(findings)
    chosen = data.draw(st.sampled_from(findings))
    broken = replace(chosen, verdict=Verdict.BROKEN, reason="fault")
    after_list = [broken if one is chosen else one for one in findings]
    before, after = scored(findings, planned), scored(after_list, planned)
    assert all(after[id].score >= before[id].score for id in IDS)
    assert final_score(after.values()) is None


@given(findings_of, plans, st.data())
def test_being_right_once_more_never_costs(
    findings: list[Finding], planned: dict[str, int], data: st.DataObject
) -> None:
    """Whatever failing case passes instead, no check earns less."""
    failing = [one for one in findings if one.verdict is Verdict.FAIL]
    assume(failing)
    chosen = data.draw(st.sampled_from(failing))
    right = replace(chosen, verdict=Verdict.PASS, evidence=Evidence(1, 0))
    after_list = [right if one is chosen else one for one in findings]
    before, after = scored(findings, planned), scored(after_list, planned)
    assert all(after[id].score >= before[id].score for id in IDS)


@given(findings_of, plans)
def test_the_other_part_is_never_touched(
    findings: list[Finding], planned: dict[str, int]
) -> None:
    """What is found in part a changes nothing in part b, and the other way round."""
    part = {one.check: one.part for one in RUBRIC.criteria}
    local = [
        one
        for one in findings
        if part[one.check] == part[one.reason] or one.verdict is not Verdict.BLOCKED
    ]
    whole = scored(local, planned)
    for name in ("a", "b"):
        alone = scored([one for one in local if part[one.check] in {name, "both"}], planned)
        assert all(alone[id] == whole[id] for id in IDS if part[id] == name)
