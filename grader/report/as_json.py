"""How does a grade become `result.json`, the file that every other format is made from?

Two gradings of one submission with one seed may differ only inside `timing` and in
`provenance.cpu`. Measured seconds therefore stand in `timing` alone; `seconds` of a check and
of the build belong to the shape and are always null.
"""

import math
from importlib.resources import files
from typing import Any

from grader.errors import OutputFault
from grader.model.grade import CheckScore, Grade, Timing
from grader.model.stages import SOURCE_PATH, Build, Diagnostic, Rejected, Submission
from grader.model.verdict import Example
from grader.plain import one_line
from grader.report.escape import for_json
from grader.report.facts import counterexample_file, place, withheld
from grader.report.hints import likely_cause

Json = dict[str, Any]

SCHEMA_VERSION = 1

MOST_MESSAGES = 40
"""Messages of the compiler that are kept; more are counted."""

MOST_EXAMPLES = 3


def schema_text() -> str:
    """Read the JSON Schema that every result fulfils."""
    return files("grader.report").joinpath("result.schema.json").read_text(encoding="utf-8")


def to_text(grade: Grade) -> str:
    """Write a grade as the text of `result.json`."""
    return for_json(to_json(grade)) + "\n"


def to_json(grade: Grade) -> Json:
    """Turn a grade into the values of `result.json`, keys in the contract's order.

    Its texts are still a stranger's: every format that is made from it escapes them.
    """
    unknown = withheld(grade)
    review = grade.needs_review or grade.score is None or bool(unknown)
    unsure = {score.part for score in grade.checks if score.check in unknown}
    return {
        "schema": SCHEMA_VERSION,
        "submission": submission(grade.submission),
        "score": None if review or grade.score is None else number(grade.score),
        "max_score": number(grade.max_score),
        "needs_review": review,
        "parts": [
            {
                "id": part.part,
                "title": one_line(part.title),
                "score": None if part.part in unsure else number(part.score),
                "max_score": number(part.max_score),
            }
            for part in grade.parts
        ],
        "checks": [one_check(grade, score, score.check in unknown) for score in grade.checks],
        "build": build(grade),
        "timing": timing(grade.timing, grade.checks),
        "provenance": provenance(grade),
    }


def submission(given: Submission | Rejected) -> Json:
    """Say whose file it was; a rejected one has no file."""
    if isinstance(given, Rejected):
        return {"name": one_line(given.student), "sha256": None, "path": None}
    name, path = one_line(given.student), one_line(given.path)
    return {"name": name, "sha256": given.sha256, "path": path}


def one_check(grade: Grade, score: CheckScore, unknown: bool) -> Json:
    """Write one check."""
    return {
        "id": score.check,
        "part": score.part,
        "title": one_line(score.title),
        "verdict": score.verdict.value,
        "score": None if unknown else number(score.score),
        "max_score": number(score.max_score),
        "visibility": score.visibility,
        "examined": score.examined,
        "wrong": score.wrong,
        "message": score.message,
        "expected": score.expected,
        "got": score.got,
        "hint": likely_cause(score),
        "examples": [example(one) for one in score.examples[:MOST_EXAMPLES]],
        "blocked_by": score.blocked_by,
        "stop": score.stop.value,
        "location": location(grade, score),
        "counterexample": counterexample(score),
        "seconds": None,
    }


def example(given: Example) -> Json:
    """Write one wrong place."""
    return {
        "message": given.message,
        "expected": given.expected,
        "got": given.got,
    }


def location(grade: Grade, score: CheckScore) -> Json | None:
    """Say where to look, or null."""
    found = place(grade, score)
    if found is None:
        return None
    return {"file": SOURCE_PATH, "line": found.line, "function": found.function}


def counterexample(score: CheckScore) -> Json | None:
    """Say how small the reduced case is, what is wrong there and where it lies, or null."""
    found = score.counterexample
    if found is None:
        return None
    return {
        "faces": found.faces,
        "rays": found.rays,
        "file": counterexample_file(score.check),
        "message": found.message,
        "expected": found.expected,
        "got": found.got,
        "explanation": found.explanation,
    }


def build(grade: Grade) -> Json:
    """Say whether it compiled and what the compiler said, or why nothing was compiled."""
    made = grade.build
    if isinstance(grade.submission, Rejected):
        said = [diagnostic(Diagnostic(0, 0, "error", grade.submission.reason))]
        return {"ok": False, "diagnostics": said, "seconds": None}
    given = () if made is None else made.diagnostics
    remarks = [] if made is None else list(made.remarks)
    if len(given) > MOST_MESSAGES:
        remarks.append(f"{len(given) - MOST_MESSAGES:,} more messages of the compiler")
    notes = [Diagnostic(line=0, column=0, severity="note", text=text) for text in remarks]
    said = [diagnostic(one) for one in (*given[:MOST_MESSAGES], *notes)]
    return {"ok": compiled(made), "diagnostics": said, "seconds": None}


def compiled(made: Build | None) -> bool:
    """There is a library to run."""
    return made is not None and made.library is not None


def diagnostic(given: Diagnostic) -> Json:
    """Write one message of the compiler."""
    return {
        "line": given.line,
        "column": given.column,
        "severity": given.severity,
        "text": given.text,
    }


def timing(given: Timing, checks: tuple[CheckScore, ...]) -> Json:
    """Write every measured time; nothing outside of this object is a time."""
    return {
        "compile": seconds(given.compile),
        "submission": seconds(given.submission),
        "grader": seconds(given.grader),
        "total": seconds(given.total),
        "stages": {name: seconds(spent) for name, spent in given.stages},
        "checks": {score.check: seconds(score.seconds) for score in checks},
    }


def provenance(grade: Grade) -> Json:
    """Write everything that makes two results comparable."""
    given = grade.provenance
    return {
        "grader": given.grader,
        "rubric_sha256": given.rubric_sha256,
        "scenes_sha256": given.scenes_sha256,
        "seed": given.seed,
        "compiler": one_line(given.compiler),
        "flags": [one_line(flag) for flag in given.flags],
        "isolation": given.isolation,
        "cpu": one_line(given.cpu),
    }


def number(value: float) -> int | float:
    """Write a whole number without a fraction.

    Raises:
        OutputFault: The value is not finite, so our own arithmetic went wrong.
    """
    if not math.isfinite(value):
        raise OutputFault(f"A result holds the number {value}, which JSON cannot carry.")
    return int(value) if value == int(value) else value


def seconds(value: float) -> int | float:
    """Round a time to milliseconds."""
    return number(round(value, 3))
