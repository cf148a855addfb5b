"""How did one check fare over all its cases?

A case is examined if it was decided (PASS, FAIL) or blocked by a check that failed there. A
case whose worker died is not here at all, nor is one that gave the check nothing to look at.
What our own fault kept from being decided is `undecided`.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from grader.model.verdict import Finding, Verdict

_STEPS = 4
"""Points come in quarters."""

_MOST = Fraction(3, 4)
"""Of the cases of a gate: who bypasses it in so many has not passed it in the others."""

Placed = Mapping[tuple[str, str], Finding]
"""Findings by check id and case name."""


@dataclass(frozen=True, slots=True)
class Tally:
    """The findings of one check, sorted by what they count as."""

    passed: tuple[Finding, ...]
    failed: tuple[Finding, ...]
    blocked: tuple[tuple[Finding, str], ...]
    """Blocked by a failure, and the id of the check that failed."""

    undecided: tuple[Finding, ...]
    """BROKEN, or blocked by something that did not fail: our own fault."""

    planned: Fraction | int
    """Weight of the cases that there would be if every worker had survived."""

    @property
    def every(self) -> tuple[Finding, ...]:
        """All cases that count."""
        return (*self.passed, *self.failed, *(one for one, _ in self.blocked), *self.undecided)

    @property
    def suffices(self) -> bool:
        """Whether at least half of what was planned could be examined."""
        return 2 * _weight(self.every) >= self.planned

    @property
    def opens(self) -> bool:
        """Whether a gate is open: it passes somewhere, and is not bypassed in most cases."""
        bypassed = _weight(one for one in self.failed if one.evidence.bypassed)
        is_passed = bool(self.passed) and bypassed < _MOST * _weight(self.every)
        return is_passed or bool(self.undecided)

    @property
    def share(self) -> Fraction:
        """What is earned, from 0 to 1; the undecided cases count in favour."""
        if any(one.evidence.forfeits for one in self.failed):
            return Fraction(0)
        of = max(_weight(self.every), Fraction(self.planned) / 2)
        return _weight((*self.passed, *self.undecided)) / of if of else Fraction(0)


def tally(own: Iterable[Finding], placed: Placed, planned: Fraction | int) -> Tally:
    """Sort the findings of one check.

    Args:
        own: Its findings.
        placed: Those of all checks, to see what happened to the blockers.
        planned: Weight of the cases that the plan holds for it.
    """
    groups: dict[Verdict, list[Finding]] = {verdict: [] for verdict in Verdict}
    blocked: list[tuple[Finding, str]] = []
    for finding in own:
        if finding.verdict is Verdict.BLOCKED and (cause := _cause(finding, placed)):
            blocked.append((finding, cause))
        elif finding.verdict is not Verdict.PASS or finding.evidence.examined > 0:
            groups[finding.verdict].append(finding)
    return Tally(
        passed=tuple(groups[Verdict.PASS]),
        failed=tuple(groups[Verdict.FAIL]),
        blocked=tuple(blocked),
        undecided=(*groups[Verdict.BROKEN], *groups[Verdict.BLOCKED]),
        planned=planned,
    )


def by_place(findings: Iterable[Finding]) -> Placed:
    """Index findings by check and case."""
    return {(one.check, one.case): one for one in findings}


def points(possible: float, share: Fraction) -> float:
    """Round a share of the points down to quarters; the whole of them is never rounded."""
    if share >= 1:
        return possible
    return int(Fraction(possible) * share * _STEPS) / _STEPS


def _weight(findings: Iterable[Finding]) -> Fraction:
    """Add up how many ordinary cases some count for."""
    return sum((Fraction(str(one.weight)) for one in findings), Fraction(0))


def _cause(finding: Finding, placed: Placed) -> str | None:
    """The check that failed on this case and so blocked this one; None if none failed."""
    seen: set[str] = set()
    here: Finding | None = finding
    while here is not None and here.verdict is Verdict.BLOCKED and here.check not in seen:
        seen.add(here.check)
        here = placed.get((here.reason, here.case))
    return here.check if here is not None and here.verdict is Verdict.FAIL else None
