"""What is there to fix, and in which order? Read from the values of a result."""

import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from grader.language import Words
from grader.model.stages import SOURCE_PATH
from grader.output import OUTPUT
from grader.phrases import counted
from grader.report.facts import costs, root
from grader.report.hints import cause_in, told

Json = Mapping[str, Any]

_COUNTED = re.compile(r"(?s)([\d,]+ of [\d,]+ wrong[^:]*): (.*)")
"""How a check words what it counted, and then its first example."""


Fact = tuple[str, str, str]
"""Label, text and class."""


@dataclass(frozen=True, slots=True)
class Smallest:
    """The smallest input that fails, which is another one than the failure's own."""

    size: str
    message: str
    facts: tuple[Fact, ...]
    """What was expected of it, what it got, and where in the tree that was lost."""


@dataclass(frozen=True, slots=True)
class Failure:
    """One failed check, as a person reads it."""

    check: str
    title: str
    points: str
    happened: str
    """How much is wrong, and in which case first."""

    where: str
    """The first wrong place; empty if that says all."""

    facts: tuple[Fact, ...]
    """What was expected, what was there, and where."""

    smallest: Smallest | None

    cause: str
    hints: tuple[tuple[str, str], ...]
    """Label and text, each told only to those who ask."""

    commands: tuple[tuple[str, str], ...]
    """Label and command."""

    waiting: tuple[str, ...]
    """Checks that cannot be decided before it passes."""

    model: int | None
    """Which model of the 3D view shows it."""

    table: Json | None
    """The tree of its smallest input, node by node."""


def failures(result: Json, views: Json, words: Words) -> list[Failure]:
    """Explain every failed check, the one first that costs most."""
    return [_failure(one, result, views, words) for one in worst_first(result)]


def spoken(one: Failure, told: Words) -> Failure:
    """Tell in a language what the check found."""
    return replace(
        one,
        happened=told(one.happened),
        where=told(one.where),
        facts=_spoken(one.facts, told),
        smallest=one.smallest
        and replace(
            one.smallest,
            message=told(one.smallest.message),
            facts=_spoken(one.smallest.facts, told),
        ),
        table=None if one.table is None else _table(one.table, told),
    )


def _table(given: Json, told: Words) -> Json:
    """Tell what stands in the cells of a tree, where it is words."""
    columns = [[node, told(wanted), told(got)] for node, wanted, got in given["columns"]]
    return {**given, "columns": columns}


def _spoken(facts: tuple[Fact, ...], told: Words) -> tuple[Fact, ...]:
    return tuple(
        (label, "\n".join(map(told, text.split("\n"))), kind) for label, text, kind in facts
    )


def worst_first(result: Json) -> list[Json]:
    """Sort failed checks by what they cost, with what waits for them."""
    cost = costs((one["id"], one["blocked_by"], lost(one)) for one in result["checks"])
    failed = [one for one in result["checks"] if one["verdict"] == "fail"]
    return sorted(failed, key=lambda one: -cost[one["id"]])


def lost(check: Json) -> float:
    """Say how many points a check costs; a withheld one costs nothing yet."""
    return 0.0 if check["score"] is None else float(check["max_score"] - check["score"])


def points(score: float | None, possible: float, words: Words) -> str:
    """Write points: `4 of 5`, `gate`, `withheld`."""
    if score is None:
        return words("withheld")
    if not possible:
        return words("gate")
    return words("{score} of {possible}").format(score=f"{score:g}", possible=f"{possible:g}")


def idle_parts(result: Json) -> list[str]:
    """Name the parts that were not started: all their checks wait for nothing."""
    checks = {one["id"]: one for one in result["checks"]}
    return [part["id"] for part in result["parts"] if _is_idle(part["id"], checks)]


def _is_idle(part: str, checks: Mapping[str, Json]) -> bool:
    blocker = {name: one["blocked_by"] for name, one in checks.items()}
    own = [name for name, one in checks.items() if one["part"] == part]
    return bool(own) and all(
        checks[root(name, blocker)]["verdict"] == "blocked" for name in own
    )


def _failure(check: Json, result: Json, views: Json, words: Words) -> Failure:
    happened, where = _first_place(check["message"])
    shown = [place for place, one in enumerate(views["models"]) if one["check"] == check["id"]]
    tables = [one for one in views.get("tables", ()) if one["check"] == check["id"]]
    return Failure(
        check=check["id"],
        title=words(check["title"]),
        points=points(check["score"], check["max_score"], words),
        happened=happened,
        where=where,
        facts=tuple(_facts(check, words)),
        smallest=_smallest(check["counterexample"], words),
        cause=cause_in(check["hint"], words),
        hints=tuple(_hints(check["id"], words)),
        commands=tuple(_commands(check, result, words)),
        waiting=tuple(
            one["id"] for one in result["checks"] if one["blocked_by"] == check["id"]
        ),
        model=shown[0] if shown else None,
        table=tables[0] if tables else None,
    )


def _first_place(message: str) -> tuple[str, str]:
    """Split how many are wrong from the first of them."""
    found = _COUNTED.fullmatch(message)
    return (found[1], found[2]) if found else (message, "")


def _smallest(found: Json | None, words: Words) -> Smallest | None:
    if found is None:
        return None
    facts = [
        (words("where"), found.get("explanation", ""), ""),
        (words("expected"), found.get("expected", ""), "good"),
        (words("got"), found.get("got", ""), "bad"),
    ]
    given = tuple(fact for fact in facts if fact[1])
    return Smallest(size(found, words), found.get("message", ""), given)


def _facts(check: Json, words: Words) -> list[Fact]:
    facts = [
        (words("expected"), check["expected"], "good"),
        (words("got"), check["got"], "bad"),
        (words("example"), "\n".join(_examples(check)), ""),
        (words("look at"), _place(check["location"], words), ""),
    ]
    return [fact for fact in facts if fact[1]]


def _examples(check: Json) -> list[str]:
    """Choose what the message did not say yet."""
    told_already = check["message"]
    return [one["message"] for one in check["examples"] if one["message"] not in told_already]


def size(found: Json, words: Words) -> str:
    """Word how large a counterexample is."""
    faces, rays = found["faces"], found["rays"]
    many = words("{faces} faces").format(faces=counted(faces, words))
    face = words("1 face") if faces == 1 else many
    if not rays:
        return face
    many = words("{rays} rays").format(rays=counted(rays, words))
    ray = words("1 ray") if rays == 1 else many
    return f"{face}, {ray}"


def _place(location: Json | None, words: Words) -> str:
    if location is None:
        return ""
    line = "" if location["line"] is None else f":{location['line']}"
    function = location["function"] or words("this file")
    return words("{place} in {function}").format(
        place=f"{location['file']}{line}", function=function
    )


def _hints(check: str, words: Words) -> list[tuple[str, str]]:
    known = told().get(check, {})
    labelled = (
        (words("A question that helps"), words(known.get("question", ""))),
        (words("Something to try"), words(known.get("trial", ""))),
    )
    return [hint for hint in labelled if hint[1]]


def _commands(check: Json, result: Json, words: Words) -> list[tuple[str, str]]:
    if check["visibility"] != "visible":
        return []
    again = f"bvhgrade check {SOURCE_PATH} --seed {result['provenance']['seed']}"
    commands = [(words("Run this check again"), f"{again} --only {check['id']}")]
    if check["counterexample"] is not None:
        # From the exercise's folder, as the other names; where the page lies it cannot know.
        file = shlex.quote(f"{OUTPUT}/{check['counterexample']['file']}")
        commands.append((words("Run the smallest example alone"), f"{again} --replay {file}"))
        viewer = f"bvhgrade view {SOURCE_PATH} --check {file}"
        commands.append((words("Look at the smallest example from all sides"), viewer))
    return commands
