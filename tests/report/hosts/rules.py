"""How each host reads a result, written anew from its own source; traps included.

Sources: the harness 0.15.0 of Gradescope; PrairieLearn, docs/externalGrading.md and
pl-external-grader-results; Autolab, assessment_autograde_core.rb; actions/runner,
ActionCommandManager.cs; autograding-grading-reporter, src/.
"""

import base64
import json
import re
from dataclasses import dataclass, field
from typing import Any

from tests.report.readers import commands

Json = dict[str, Any]


@dataclass
class Gradescope:
    """What Gradescope makes of `results.json`."""

    failed: str = ""
    """Why the autograder counts as failed; empty if it does not."""

    total: float | None = None
    cut: list[str] = field(default_factory=list)
    """Names of what lost its middle."""

    seen: list[Json] = field(default_factory=list)
    """Tests that a student sees before the due date."""

    total_seen: bool = True


def gradescope(text: str) -> Gradescope:
    """Read the file as the harness, and then as the site."""
    read = Gradescope()
    try:
        results = json.loads(text.replace("\0", "\ufffd"))
    except ValueError:
        return Gradescope("The autograder failed to execute correctly", total=0)
    tests = results.get("tests", [])
    for one in [results, *tests]:
        if len(one.get("output", "")) > 100_000:
            read.cut.append(one.get("name", "top"))
    scored = [one for one in tests if "score" in one]
    if results.get("score") is None and not scored:
        read.failed = "neither the whole nor any test has a score"
    elif results.get("score") is not None:
        read.total = results["score"]
    else:
        read.total = sum(one["score"] for one in scored)
    read.seen = [one for one in tests if one.get("visibility", "visible") == "visible"]
    read.total_seen = len(read.seen) == len(tests)
    return read


def gradescope_status(test: Json) -> str:
    """Say how the site marks a test: by its status, else by its points; else not at all."""
    if "status" in test:
        return str(test["status"])
    if "score" not in test:
        return "informational"
    return "passed" if test["score"] == test["max_score"] else "failed"


@dataclass
class PrairieLearn:
    """What PrairieLearn makes of `results.json`."""

    graded: bool
    """False: the attempt is not used up, and no points are given or taken."""

    share: float | None = None
    errors: tuple[str, ...] = ()
    points_shown: bool = False
    tests: tuple[Json, ...] = ()


class GradingFailedError(Exception):
    """The host shows an error instead of a result."""


def prairielearn(data: bytes) -> PrairieLearn:
    """Read the file as the host and the element do."""
    if len(data) > 1_048_576:
        raise GradingFailedError("the file is too large")
    results = json.loads(data)
    if not results.get("gradable", True):
        errors = results.get("format_errors", [])
        return PrairieLearn(
            False, errors=tuple([errors] if isinstance(errors, str) else errors)
        )
    if isinstance(results.get("score"), bool) or not isinstance(results["score"], int | float):
        raise GradingFailedError("score is no number")
    tests = results.get("tests", [])
    shown = all(one.get("points") is not None and "max_points" in one for one in tests)
    return PrairieLearn(True, results["score"], (), shown, tuple(tests))


@dataclass
class Autolab:
    """What Autolab stores."""

    scores: dict[str, float | None]
    """By problem; one that is not here was not touched."""

    error: str = ""
    stages: dict[str, Json] = field(default_factory=dict)


def autolab(stdout: str, problems: list[str]) -> Autolab:
    """Read what the job printed; whatever fails gives 0 to each problem without a score."""
    lines = stdout.rstrip().split("\n")
    try:
        quoted = re.sub(r"([a-zA-Z0-9]+):", r'"\1":', lines[-1])
        scores = json.loads(quoted)["scores"]
        if not scores:
            raise ValueError("Empty autoresult string")
        if unknown := [name for name in scores if name not in problems]:
            raise ValueError(f"{unknown} not defined by assessment")
    except (ValueError, KeyError) as fault:
        return Autolab(dict.fromkeys(problems, 0.0), str(fault))
    told = semantic(lines[-2])
    if told is None:
        return Autolab(scores)
    # The page of the formatted feedback adds the scores up, and fails at a null.
    sum(value + 0 for value in scores.values())
    return Autolab(scores, stages={stage: told[stage] for stage in told["stages"]})


def semantic(line: str) -> Json | None:
    """Read the formatted feedback; None if the line is something else."""
    try:
        told: Any = json.loads(line)
    except ValueError:
        return None
    return told if isinstance(told, dict) and told.get("_presentation") == "semantic" else None


@dataclass
class Step:
    """What a runner heard of a step."""

    annotations: list[tuple[str, dict[str, str], str]] = field(default_factory=list)
    shown: list[tuple[str, dict[str, str], str]] = field(default_factory=list)
    """Those that GitHub keeps: ten of a kind."""

    stopped: list[str] = field(default_factory=list)
    """Lines that were printed while commands were stopped."""


def runner(log: str) -> Step:
    """Read a log line by line, as the runner does, and end with commands at work."""
    step = Step()
    stopped_until = ""
    for line in log.split("\n"):
        if stopped_until:
            if line.strip() == f"::{stopped_until}::":
                stopped_until = ""
            else:
                step.stopped.append(line)
            continue
        for name, properties, data in commands(line):
            if name == "stop-commands":
                assert data
                assert data != "pause-logging"
                stopped_until = data
            else:
                step.annotations.append((name, properties, data))
    assert not stopped_until, "no later step would be heard"
    for kind in ("error", "warning", "notice"):
        step.shown += [one for one in step.annotations if one[0] == kind][:10]
    return step


@dataclass
class Classroom:
    """What the reporter does with the output of a grader step."""

    sent: tuple[float, float] | None
    """Points and maximum; None if nothing is sent."""

    failed: bool
    log: str


def classroom(line: str) -> Classroom:
    """Read `GITHUB_OUTPUT`, then what the reporter finds in it."""
    assert line.endswith("\n")
    assert line.count("\n") == 1
    name, _, encoded = line.strip().partition("=")
    assert name == "result"
    results = json.loads(base64.b64decode(encoded, validate=True).decode("utf-8"))
    log = ""
    for test in results["tests"]:
        if test["status"] == "pass":
            log += f"{test['name']}\n"
        else:
            said = test.get("message") or f"Failed to run test '{test['name']}'"
            log += f"{test['name']}\nError: {said}\n"
    sent = None
    if results["max_score"]:
        # As in the reporter, null would count as 0 here, and nothing at all as no number.
        sent = (sum(test["score"] or 0 for test in results["tests"]), results["max_score"])
    return Classroom(sent, results["status"] in ("fail", "error"), log)
