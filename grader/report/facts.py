"""What does every format say about a grade? Decided once: what is withheld, where to look."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from grader.model.grade import CheckScore, Grade, PartScore
from grader.model.stages import Rejected
from grader.model.verdict import Verdict
from grader.plain import as_name

if TYPE_CHECKING:
    from grader.model.counterexample import Counterexample

FOLDER = "counterexamples"
"""Where the files of counterexamples lie, beside `result.json`."""

NOT_STARTED = "Part {part} is not started: {function} still does what the given code does."

BEGIN = "Begin at the TODO in src/exercise03.cpp."

FUNCTIONS = {"a": "BVH::construct", "b": "intersect"}
"""The function that each part asks for."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where in the student's file a failed check points."""

    line: int | None
    """1-based; None if not even the function's first line is known."""

    function: str
    """A student's name, made printable; empty if unknown."""

    exact: bool
    """True if it is the statement's line, False if only the function's first."""


def withheld(grade: Grade) -> frozenset[str]:
    """Name the checks whose points nobody knows: BROKEN, or blocked by one that is withheld."""
    names = {score.check for score in grade.checks if score.verdict is Verdict.BROKEN}
    blocked = [score for score in grade.checks if score.verdict is Verdict.BLOCKED]
    for _ in blocked:
        names |= {score.check for score in blocked if score.blocked_by in names}
    return frozenset(names)


def remarked(grade: Grade, remark: str) -> Grade:
    """Say what is worth knowing of a grade and costs nothing."""
    if grade.build is None:
        return grade
    return replace(grade, build=replace(grade.build, remarks=(*grade.build.remarks, remark)))


def not_started(part: PartScore) -> str:
    """Say that a part still does what the given code does."""
    function = FUNCTIONS.get(part.part, "the function")
    return NOT_STARTED.format(part=part.part, function=function)


def counterexample_file(check: str) -> str:
    """Name the file of a check's counterexample, relative to `result.json`."""
    return f"{FOLDER}/{check}.json"


def size_of(found: "Counterexample") -> str:
    """Word how large a counterexample is: `5 faces, 1 ray`."""
    faces = f"{found.faces:,} face{'' if found.faces == 1 else 's'}"
    rays = f", {found.rays:,} ray{'' if found.rays == 1 else 's'}" if found.rays else ""
    return faces + rays


def unstarted(grade: Grade) -> dict[str, str]:
    """Map each part that was not started to the sentence that says so."""
    if isinstance(grade.submission, Rejected) or grade.build is None:
        return {}
    if grade.build.library is None:
        return {}
    return {part.part: not_started(part) for part in grade.parts if not part.started}


def place(grade: Grade, score: CheckScore) -> Place | None:
    """Find where a failed check points, or None if there is nothing to look at."""
    if score.verdict is not Verdict.FAIL or grade.build is None:
        return None
    wanted = FUNCTIONS.get(score.part)
    known = [] if grade.build.calls is None else list(grade.build.calls.lines)
    named = sorted((line, plain_name(mangled)) for mangled, line in known)
    if score.line > 0:
        around = [name for line, name in named if line <= score.line and name]
        return Place(score.line, as_name(around[-1]) if around else (wanted or ""), exact=True)
    if wanted is None:
        return None
    starts = [line for line, name in named if name == wanted]
    return Place(starts[0] if starts else None, wanted, exact=False)


def plain_name(mangled: str) -> str:
    """Read `BVH::construct` out of a mangled name; empty if it is of a rarer form.

    Source: Itanium C++ ABI, 5.1 (nested names and identifiers with their length before them).
    """
    if found := re.match(r"_ZN[KVr]*", mangled):
        return "::".join(identifiers(mangled, found.end()))
    if found := re.match(r"_ZL?", mangled):
        return "::".join(identifiers(mangled, found.end())[:1])
    return ""


def identifiers(mangled: str, start: int) -> list[str]:
    """Read identifiers with their length before them until something else comes."""
    names: list[str] = []
    while found := re.compile(r"L?(\d{1,3})").match(mangled, start):
        start = found.end() + int(found[1])
        names.append(mangled[found.end() : start])
    return [name for name in names if not name.startswith("_GLOBAL__N")]


def worst(grade: Grade) -> CheckScore | None:
    """Choose the failure that costs most; None if nothing failed."""
    idle = unstarted(grade)
    cost = costs(
        (score.check, score.blocked_by, score.max_score - score.score) for score in grade.checks
    )
    failed = [
        score
        for score in grade.checks
        if score.verdict is Verdict.FAIL and score.part not in idle
    ]
    return max(failed, key=lambda score: cost[score.check], default=None)


def costs(checks: Iterable[tuple[str, str | None, float]]) -> dict[str, float]:
    """Add up what each check costs, with all that waits for it, over several steps.

    Args:
        checks: Of each check its id, what it waits for, and the points that it lost.
    """
    given = list(checks)
    blocker = {check: before for check, before, _ in given}
    cost = dict.fromkeys(blocker, 0.0)
    for check, _, lost in given:
        cost[root(check, blocker)] += lost
    return cost


def root(check: str, blocker: Mapping[str, str | None]) -> str:
    """Follow what a check waits for to what does not wait."""
    for _ in blocker:
        before = blocker.get(check)
        if before is None or before not in blocker:
            break
        check = before
    return check
