"""What a check concludes."""

from dataclasses import dataclass
from enum import Enum

from grader.model.stages import Stop


class Verdict(Enum):
    """Only PASS and FAIL move points; BROKEN is always our own fault."""

    PASS = "pass"
    FAIL = "fail"
    BLOCKED = "blocked"
    BROKEN = "broken"


@dataclass(frozen=True, slots=True)
class Example:
    """One place where a submission is wrong: where, what is there, what was expected."""

    message: str
    """`node 5: box is ..., but its triangles span ...`; numbers by `{:.9g}`."""

    expected: str = ""
    got: str = ""


@dataclass(frozen=True, slots=True)
class Evidence:
    """What a check counted in one case; `examined == 0` can never be a pass."""

    examined: int
    wrong: int
    examples: tuple[Example, ...] = ()
    """At most three."""

    stop: Stop = Stop.FINISHED
    line: int = 0
    """Line of the student's file that the evidence points at; 0 if none."""

    hidden_by: str = ""
    """Of `examined == 0`: the check whose failure here keeps this one from telling."""

    forfeits: bool = False
    """Of a failure: whether it costs all points of its check, whatever other cases show."""

    bypassed: bool = False
    """Of a failure: whether what is examined was gone around, and so did not matter at all."""

    too_small: bool = False
    """Of `examined == 0`: whether the case is wrong, but too small to tell in what way."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One check's verdict on one case."""

    check: str
    case: str
    verdict: Verdict
    evidence: Evidence
    reason: str = ""
    """Of BLOCKED the blocking check, of BROKEN what went wrong on our side, in a sentence."""

    traceback: str = ""
    """Of BROKEN by an exception: what a maintainer needs, and nobody else reads."""

    weight: float = 1.0
    """How many ordinary cases this one counts for."""

    shown: bool = True
    """Whether students may be told where it was; hidden scenes are not named."""
