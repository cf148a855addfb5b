"""How does GitHub read a result? Log lines, a step's summary, and an output for Classroom.

Log: GitHub shows at most 10 errors and 10 warnings of a step, so each cause gets one, the worst
first. Everything else is printed while commands are stopped. The word that lets commands work
again is a hash of the result, which nobody whom the result quotes could foresee.

Summary: Markdown of at most 1 MiB; a larger one is lost as a whole.

Classroom: `result=` and base64, as autograding-command-grader writes it for `GITHUB_OUTPUT`.
The reporter (autograding-grading-reporter) prints names and messages as they are, so they are
without commands here. It sends the sum of the tests' scores, unless `max_score` is 0. That is
what a withheld score makes it: nothing is sent then, and the job fails as an error.

Source: github/docs, workflow-commands.md; actions/toolkit; the two named actions.
"""

import base64
import hashlib
from collections.abc import Iterator

from grader.language import Words
from grader.model.stages import SOURCE_PATH
from grader.report.as_json import Json
from grader.report.escape import (
    for_json,
    for_terminal,
    for_workflow,
    for_workflow_property,
    line_for_terminal,
)
from grader.report.hosts.told import (
    Entry,
    entries,
    summary,
    unbuilt,
    withheld,
    worst_first,
    worth,
)

MOST_ANNOTATIONS = 10
"""Of each kind in a step; GitHub drops the rest without a word."""

LONGEST = 300
"""Characters of a name and of a message for Classroom. Its reporter is started with all of them
in one variable of its environment: of 131,071 bytes at most (Linux, MAX_ARG_STRLEN)."""

STATUS = {"pass": "pass", "fail": "fail", "blocked": "fail", "broken": "error"}


def log(result: Json, words: Words = str) -> str:
    """Write what a step prints: annotations, then the report with commands stopped."""
    resume = hashlib.sha256(for_json(result).encode()).hexdigest()
    shown = entries(result, words)
    report = [for_terminal(summary(result, words)), ""]
    for entry in shown:
        line = f"{words(entry.verdict)}: {entry.id}: {entry.title} ({worth(entry, words)})"
        report.append(line_for_terminal(line))
        report += [f"    {line}" for line in for_terminal(entry.text).split("\n") if line]
    annotations = [*errors(result, shown, words), *warnings(result)]
    return "\n".join([*annotations, f"::stop-commands::{resume}", *report, f"::{resume}::", ""])


def errors(result: Json, shown: list[Entry], words: Words) -> list[str]:
    """Write an error for each cause, the worst first."""
    if result["score"] is None:
        return [annotation(result, "error", "bvhgrade", withheld(words))]
    if not result["build"]["ok"]:
        return [*broken_build(result, words)][:MOST_ANNOTATIONS]
    causes: dict[str, Entry] = {}
    for entry in worst_first(shown):
        causes.setdefault(entry.cause or entry.id, entry)
    told = [
        annotation(
            result, "error", entry.id, f"{entry.title}\n{entry.text}".strip(), (entry.line, 0)
        )
        for entry in causes.values()
    ]
    if not told and result["score"] < result["max_score"]:
        # Nothing is wrong with what was not started; without a word it would look right.
        told.append(annotation(result, "error", "bvhgrade", summary(result, words)))
    return told[:MOST_ANNOTATIONS]


def broken_build(result: Json, words: Words) -> Iterator[str]:
    """Write an error for each error of the compiler, in its order; else the reason."""
    said = [one for one in result["build"]["diagnostics"] if one["severity"] == "error"]
    if not any(one["line"] for one in said):
        yield annotation(result, "error", "build.compiles", unbuilt(result, words))
        return
    for one in said:
        yield annotation(
            result, "error", "build.compiles", one["text"], (one["line"], one["column"])
        )


def warnings(result: Json) -> list[str]:
    """Write a warning for each warning of the compiler that has a line; none is graded."""
    said = [
        annotation(result, "warning", "g++", one["text"], (one["line"], one["column"]))
        for one in result["build"]["diagnostics"]
        if one["severity"] == "warning" and one["line"]
    ]
    return said[:MOST_ANNOTATIONS]


def annotation(
    result: Json, kind: str, title: str, text: str, place: tuple[int, int] = (0, 0)
) -> str:
    """Write one annotation, at the file's place in the repository as far as it is known."""
    line, column = place
    path = str(result["submission"]["path"] or SOURCE_PATH)
    file = path if "/" in path else SOURCE_PATH
    told = [f"file={for_workflow_property(file)}"]
    told += [f"line={line}"] if line else []
    told += [f"col={column}"] if line and column else []
    told.append(f"title={for_workflow_property(title)}")
    return f"::{kind} {','.join(told)}::{for_workflow(text)}"


def output(result: Json, words: Words = str) -> str:
    """Write the line for `GITHUB_OUTPUT` that the reporter of Classroom reads."""
    told = for_json(classroom(result, words)).encode()
    return f"result={base64.b64encode(told).decode('ascii')}\n"


def classroom(result: Json, words: Words) -> Json:
    """Say what Classroom is told."""
    if result["score"] is None:
        message = line_for_terminal(withheld(words))
        test = {"name": "bvhgrade", "status": "error", "message": message}
        return {"version": 1, "status": "error", "max_score": 0, "tests": [test]}
    shown = entries(result, words)
    # By the checks and not by the points: a rubric may be worth nothing.
    status = "pass" if all(entry.verdict == "pass" for entry in shown) else "fail"
    return {
        "version": 1,
        "status": status,
        "max_score": result["max_score"],
        "tests": [classroom_test(entry, words) for entry in shown],
    }


def classroom_test(entry: Entry, words: Words) -> Json:
    """Write one check; the reporter prints its name and message into the log."""
    return {
        "name": short(f"{entry.id} {entry.title}"),
        "status": STATUS[entry.verdict],
        "score": entry.score,
        "message": short(entry.text or headline_of(entry, words)),
        "test_code": f"bvhgrade check --only {entry.id}",
        "filename": SOURCE_PATH,
        "line_no": entry.line,
        "duration": 0,
    }


def headline_of(entry: Entry, words: Words) -> str:
    """Word a check that has nothing to say; without it the reporter says it did not run."""
    return f"{entry.title} ({worth(entry, words)})"


def short(text: str) -> str:
    """Cut a text for the reporter, which gets all of them in one environment variable."""
    line = line_for_terminal(text)
    return line if len(line) <= LONGEST else line[: LONGEST - 4] + " ..."
