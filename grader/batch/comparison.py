"""Who would have other points, in which checks, and why? Results of the same bytes compared.

Only what decides points is looked at: a time, a wording or an example may differ from run to
run of two versions, and nobody has more or fewer points for it.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from grader.batch.files import Results, standing
from grader.batch.job import Job
from grader.batch.records import Student
from grader.batch.settings import Settings
from grader.batch.store import Store
from grader.plain import one_line

Json = Mapping[str, Any]

LONGEST_REASON = 200


@dataclass(frozen=True, slots=True)
class CheckChange:
    """A check that ends otherwise."""

    check: str
    before: str
    """Verdict and points; empty if there was no such check."""

    after: str
    why: str


@dataclass(frozen=True, slots=True)
class Change:
    """A result that is another one."""

    before: str
    """Points, or that they are withheld."""

    after: str
    checks: tuple[CheckChange, ...]


def compared(before: Json, after: Json) -> Change | None:
    """Compare two values of `result.json`; None if they give the same points for the same."""
    old = {one["id"]: one for one in before["checks"]}
    new = {one["id"]: one for one in after["checks"]}
    names = list(dict.fromkeys([*old, *new]))
    checks = [_check(name, old.get(name), new.get(name)) for name in names]
    changed = tuple(one for one in checks if one.before != one.after)
    first, then = points(before), points(after)
    return Change(first, then, changed) if changed or first != then else None


def changes(store: Store, first: Settings, job: Job) -> Iterator[tuple[Student, Change | None]]:
    """Compare what the first settings and those of a job give everybody who has a result."""
    results = Results(store, job)
    for student in store.students():
        if student.sha256 is not None:
            old, new = (store.result(student.sha256, each) for each in (first, job.settings))
            before = None if old is None else json.loads(old.text)
        elif student.reason:
            before, new = standing(student, job.folder, first), results.of(student)
        else:
            continue
        if new is None:
            continue
        after = json.loads(new.text)
        if before is None:
            yield student, Change("no result", points(after), ())
        else:
            yield student, compared(before, after)


def lines(change: Change) -> list[str]:
    """Word a change: the points, and then a line for each check."""
    told = [f"{change.before} -> {change.after}"]
    for one in change.checks:
        why = f": {one.why}" if one.why else ""
        told.append(f"{one.check}: {one.before or 'none'} -> {one.after or 'none'}{why}")
    return told


def provenance_changes(before: Json, after: Json) -> list[str]:
    """Name each part of two provenances that differs, with both values; processors may."""
    parts = [name for name in dict.fromkeys([*before, *after]) if name != "cpu"]
    return [
        f"{name}: {_shown(before.get(name))} -> {_shown(after.get(name))}"
        for name in parts
        if before.get(name) != after.get(name)
    ]


def _check(name: str, old: Json | None, new: Json | None) -> CheckChange:
    return CheckChange(name, _worded(old), _worded(new), _why(old, new))


def _why(old: Json | None, new: Json | None) -> str:
    if new is None:
        return "the check is gone"
    if old is not None and old["verdict"] == new["verdict"] and _other_worth(old, new):
        return "it is worth something else"
    if new["blocked_by"]:
        return f"it waits for {new['blocked_by']}"
    return one_line(str(new["message"]), LONGEST_REASON)


def _other_worth(old: Json, new: Json) -> bool:
    return bool(old["max_score"] != new["max_score"])


def _worded(check: Json | None) -> str:
    if check is None:
        return ""
    score = "withheld" if check["score"] is None else f"{check['score']:g}"
    return f"{check['verdict']} {score} of {check['max_score']:g}"


def points(result: Json) -> str:
    """Word the points of a result, or that they are withheld."""
    score = "withheld" if result["score"] is None else f"{result['score']:g}"
    return f"{score} of {result['max_score']:g}"


def _shown(value: object) -> str:
    text = " ".join(map(str, value)) if isinstance(value, list) else str(value)
    return one_line(text[:12] if len(text) == 64 else text, LONGEST_REASON)
