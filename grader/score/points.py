"""How many points does each check and each part earn, and what is the student told?

Theory of operation: a criterion earns points x passed / max(examined, planned / 2), rounded
down to quarters; nothing, if a case forfeits them. A gate that passes nowhere, or is bypassed,
takes the points of its part, and the gate of both parts those of both. Our own fault counts in
the student's favour here, and `final_score` withholds the sum, so that nobody mistakes it for
a grade.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice

from grader.model.grade import CheckScore, Criterion, PartScore, Rubric
from grader.model.stages import Stop
from grader.model.verdict import Example, Finding, Verdict
from grader.score.rubric import BOTH
from grader.score.tally import Tally, by_place, points, tally

SURVIVAL = {"a": "bvh.survives-every-mesh", "b": "hits.survives-every-ray"}
"""The check of each part that says whose workers died."""

_ONLY_CRASHES = "earns nothing: where it does not crash, it does what the given code does"

_MAX_EXAMPLES = 3
_NAMED_CASES = 8


@dataclass(frozen=True, slots=True)
class _Outcome:
    verdict: Verdict
    message: str = ""
    blocked_by: str | None = None


def score_checks(
    rubric: Rubric,
    checks: Sequence[tuple[str, str]],
    findings: Sequence[Finding],
    planned: Mapping[str, Fraction | int],
    started: Collection[str],
) -> tuple[CheckScore, ...]:
    """Give every check of the rubric its points and its words, in the order of `checks`.

    Args:
        rubric: What each check is worth; a check that it leaves out is left out here.
        checks: Id and title of every check there is.
        findings: One of each check and case.
        planned: Per check, the weight of the cases that a right submission gives it.
        started: The parts that no longer are the given code.
    """
    placed = by_place(findings)
    tallies = {
        id: tally((one for one in findings if one.check == id), placed, planned.get(id, 0))
        for id, _ in checks
    }
    worth = {criterion.check: criterion for criterion in rubric.criteria}
    scores = tuple(
        _scored(worth[id], title, tallies[id], _died(worth[id].part, tallies))
        for id, title in checks
        if id in worth
    )
    return _behind_gates(_idle(scores, started), rubric.criteria, tallies)


def crashes_earn_nothing(
    scores: Sequence[CheckScore], parts: Collection[str]
) -> tuple[CheckScore, ...]:
    """Take the points of parts that do what the given code does, wherever they survive."""
    return tuple(
        _worthless(score, _ONLY_CRASHES, SURVIVAL[score.part]) if score.part in parts else score
        for score in scores
    )


def score_parts(
    rubric: Rubric, checks: Sequence[CheckScore], started: Collection[str]
) -> tuple[PartScore, ...]:
    """Add up the checks of each part."""
    return tuple(
        PartScore(
            part=part,
            title=title,
            score=sum(one.score for one in checks if one.part == part),
            max_score=sum(one.max_score for one in checks if one.part == part),
            started=part in started,
        )
        for part, title in rubric.titles
    )


def final_score(checks: Iterable[CheckScore]) -> float | None:
    """The sum of the points; None while our own fault leaves a check undecided."""
    checks = tuple(checks)
    if any(one.verdict is Verdict.BROKEN for one in checks):
        return None
    return sum(one.score for one in checks)


def _scored(criterion: Criterion, title: str, of: Tally, died: str | None) -> CheckScore:
    outcome = _outcome(of, died)
    first = next((one for one in of.failed if one.shown), None)
    examples = tuple(islice(_examples(of.failed), _MAX_EXAMPLES))
    shown = examples[0] if examples else Example("")
    counted = (*of.passed, *of.failed)
    return CheckScore(
        check=criterion.check,
        part=criterion.part,
        title=title,
        verdict=outcome.verdict,
        score=points(criterion.points, of.share),
        max_score=criterion.points,
        visibility=criterion.visibility,
        examined=sum(one.evidence.examined for one in counted),
        wrong=sum(one.evidence.wrong for one in of.failed),
        message=outcome.message,
        expected=shown.expected,
        got=shown.got,
        examples=examples,
        blocked_by=outcome.blocked_by,
        stop=first.evidence.stop if first else Stop.FINISHED,
        line=first.evidence.line if first else 0,
        cases=tuple((one.case, one.verdict) for one in of.every),
        seconds=0.0,
    )


def _outcome(of: Tally, died: str | None) -> _Outcome:
    """Decide the verdict over all cases; a check that examined nothing does not pass."""
    if of.undecided:
        first = of.undecided[0]
        return _Outcome(Verdict.BROKEN, f"`{first.case}`: {first.reason or 'undecided'}")
    if of.failed:
        return _Outcome(Verdict.FAIL, _told(of))
    if of.blocked:
        return _waits(of)
    if not of.passed or not of.suffices:
        return _too_little(of, died)
    return _Outcome(Verdict.PASS, _passed(of))


def _waits(of: Tally) -> _Outcome:
    """Say what keeps a check from being decided, and in how many cases that a student sees."""
    shown = [(one, cause) for one, cause in of.blocked if one.shown]
    if not shown:
        cause = of.blocked[0][1]
        why = f"could not be decided in a case that is not shown, because `{cause}` fails there"
        return _Outcome(Verdict.BLOCKED, why, cause)
    (first, cause), every = shown[0], sum(one.shown for one in of.every)
    counted = f"could not be decided in {len(shown)} of {every} cases"
    why = f"{counted}, first in `{first.case}`, because `{cause}` fails there"
    return _Outcome(Verdict.BLOCKED, why, cause)


def _too_little(of: Tally, died: str | None) -> _Outcome:
    """Say why less than half of what was planned was examined.

    A submission can bring this about, by dying or by a tree that leaves nothing to look at. It
    cannot empty our plan.
    """
    if not of.planned:
        return _Outcome(Verdict.BROKEN, "the plan holds no case for this check")
    few = f"only {len(of.every)} of {float(of.planned):g} cases could be examined"
    if died:
        return _Outcome(Verdict.BLOCKED, f"{few}, because `{died}` fails", died)
    return _Outcome(Verdict.FAIL, f"{few}: the others gave this check nothing to look at")


def _passed(of: Tally) -> str:
    """Say where a check held: the names of a few cases, the number of many."""
    names = [one.case for one in of.passed if one.shown]
    if not names:
        return "in cases that are not shown"
    many = f"in {len(names)} case{'s' if len(names) > 1 else ''}"
    return f"{many}: {', '.join(names)}" if 1 < len(names) <= _NAMED_CASES else many


def _told(of: Tally) -> str:
    """`2 of 524,287 wrong, first in `cube`: node 5: box is ..., but ...`.

    Cases that are not shown are not counted here either: a submission that chooses how much of
    one is wrong would read in the numbers what it computed there.
    """
    failed = [one for one in of.failed if one.shown]
    if not failed:
        return "wrong in a case that is not shown"
    wrong = sum(one.evidence.wrong for one in failed)
    examined = sum(one.evidence.examined for one in (*of.passed, *failed) if one.shown)
    counted = f"{wrong:,} of {examined:,} wrong" if wrong else "not shown to be right"
    where = f"{counted}, first in `{failed[0].case}`"
    examples = failed[0].evidence.examples
    return f"{where}: {examples[0].message}" if examples else where


def _examples(failed: Iterable[Finding]) -> Iterable[Example]:
    for finding in failed:
        if finding.shown:
            yield from finding.evidence.examples


def _died(part: str, tallies: Mapping[str, Tally]) -> str | None:
    """The check that says that workers of this part died; None if none did."""
    survival = SURVIVAL.get(part, "")
    return survival if survival in tallies and tallies[survival].failed else None


def _idle(scores: Sequence[CheckScore], started: Collection[str]) -> tuple[CheckScore, ...]:
    """Nothing is earned, and nothing is blamed, in a part that is not started."""
    return tuple(
        score
        if score.part == BOTH or score.part in started
        else _worthless(score, "not started: it still does what the given code does", None)
        for score in scores
    )


def _behind_gates(
    scores: Sequence[CheckScore], criteria: Iterable[Criterion], tallies: Mapping[str, Tally]
) -> tuple[CheckScore, ...]:
    closed: dict[str, tuple[str, str]] = {}
    for gate in (one for one in criteria if one.gate and one.check in tallies):
        of = tallies[gate.check]
        if (of.planned or of.failed or of.blocked) and not of.opens:
            where = "nearly everywhere" if of.passed else "everywhere"
            closed.setdefault(gate.part, (gate.check, where))
    return tuple(_behind(score, closed.get(BOTH) or closed.get(score.part)) for score in scores)


def _behind(score: CheckScore, gate: tuple[str, str] | None) -> CheckScore:
    """Take the points behind a closed gate: its check, and where that fails."""
    if gate is None or score.check == gate[0]:
        return score
    check, where = gate
    return _worthless(score, f"earns nothing because `{check}` fails {where}", check)


def _worthless(score: CheckScore, message: str, gate: str | None) -> CheckScore:
    """Take the points; a fault of ours stays visible, and so does a failure behind a gate."""
    broken = any(verdict is Verdict.BROKEN for _, verdict in score.cases)
    if broken or (gate is not None and score.verdict is Verdict.FAIL):
        return replace(score, score=0.0)
    return replace(score, verdict=Verdict.BLOCKED, score=0.0, message=message, blocked_by=gate)
