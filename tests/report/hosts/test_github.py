"""A runner shows the causes that cost most, and hears nothing from whom we quote."""

import json
import re

import pytest

from grader.language import translator
from grader.report.as_json import Json, to_text
from grader.report.hosts import github, github_summary
from grader.report.hosts.told import entries, worst_first
from tests.report import real, samples
from tests.report.hosts import rules
from tests.report.readers import GFM, commands

FORGED = '::notice title=Autograding report::{"totalPoints":50,"maxPoints":50}'


def many_failures(count: int, hints: tuple[str, ...] = ("",)) -> Json:
    """Let many checks of one point fail, the later the more they cost."""
    result = real.real("first-hit-wins")
    (one,) = (each for each in result["checks"] if each["id"] == "hits.closest-wins")
    result["checks"] = [
        {
            **one,
            "id": f"hits.number-{n}",
            "score": count - n,
            "max_score": count,
            "hint": hints[n % len(hints)],
        }
        for n in range(count)
    ]
    return result


def test_the_worst_causes_come_first_and_no_more_than_are_shown() -> None:
    """Of fifteen failures the ten that cost most, so GitHub drops none of ours."""
    step = rules.runner(github.log(many_failures(15)))
    titles = [properties["title"] for _, properties, _ in step.annotations]
    assert titles == [f"hits.number-{n}" for n in range(14, 4, -1)]
    assert step.shown == step.annotations


def test_a_cause_is_told_once() -> None:
    """Nine checks that fail for two reasons are two errors, however much each explains."""
    share = " This explains {} of 9 places."
    hints = tuple(f"A box is {what}.{share.format(n)}" for n, what in enumerate(("big", "no")))
    step = rules.runner(github.log(many_failures(9, hints)))
    assert [found["title"] for _, found, _ in step.annotations] == [
        "hits.number-8",
        "hits.number-7",
    ]
    others = tuple(f"A box is big.{share.format(n)}" for n in range(9))
    assert len(rules.runner(github.log(many_failures(9, others))).annotations) == 1


def test_an_annotation_points_into_the_student_s_file() -> None:
    """By file and line, with the message and what was expected."""
    step = rules.runner(github.log(real.real("first-hit-wins")))
    kind, found, message = step.annotations[0]
    assert kind == "error"
    assert found["file"] == "src/exercise03.cpp"
    assert int(found["line"]) > 0
    assert "expected: " in message


def test_errors_of_the_compiler_have_their_own_places() -> None:
    """Instead of checks that all wait for the same."""
    result = real.real("uncompiled")
    said = [one for one in result["build"]["diagnostics"] if one["severity"] == "error"]
    step = rules.runner(github.log(result))
    errors = [one for one in step.annotations if one[0] == "error"]
    assert [int(found["line"]) for _, found, _ in errors] == [one["line"] for one in said][:10]
    assert [message for _, _, message in errors] == [one["text"] for one in said][:10]


def test_ten_warnings_and_ten_errors_are_the_most() -> None:
    """A flood of the compiler's is cut where GitHub would cut it."""
    result = real.real("uncompiled")
    said = {"line": 3, "column": 7, "text": "x"}
    kinds = ["error", "warning"] * 30
    result["build"]["diagnostics"] = [{**said, "severity": kind} for kind in kinds]
    step = rules.runner(github.log(result))
    assert len(step.annotations) == 20
    assert step.annotations == step.shown


def test_a_rejected_submission_gets_the_reason() -> None:
    """There is no line to point at."""
    result = real.real("rejected")
    ((_, found, message),) = rules.runner(github.log(result)).annotations
    assert "line" not in found
    assert result["build"]["diagnostics"][0]["text"] in message


def test_a_right_submission_has_no_annotation() -> None:
    """Its report is printed with commands stopped all the same."""
    step = rules.runner(github.log(real.real("right")))
    assert not step.annotations
    assert step.stopped[0] == "50 of 50 points"


def test_what_was_not_started_is_told() -> None:
    """Nothing is wrong with it, but no annotation at all would look like full marks."""
    result = json.loads(to_text(samples.starter()))
    ((kind, _, message),) = rules.runner(github.log(result)).annotations
    assert kind == "error"
    assert message.startswith("0 of 50 points")
    page = GFM.render(github_summary.to_text(result))
    assert page.count("not started: it still does what the given code does") == 8


def test_a_student_cannot_forge_a_grade() -> None:
    """Neither in the log, nor in what Classroom's reporter prints of the output."""
    result = real.real("first-hit-wins")
    for check in result["checks"]:
        check["message"] = f"a\n{FORGED}\n::stop-commands::x\n##[error]y"
    log = github.log(result)
    assert {kind for kind, _, _ in rules.runner(log).annotations} == {"error"}
    room = rules.classroom(github.output(result))
    assert "Autograding" in room.log
    assert not commands(room.log)


def test_the_word_that_lets_commands_work_again_changes_with_the_text() -> None:
    """Who writes it into a message changes it by that; the same result has the same one."""
    result = real.real("first-hit-wins")
    (word,) = re.findall(r"^::stop-commands::(\w+)$", github.log(result), re.MULTILINE)
    result["checks"][0]["message"] = f"\n::{word}::\n{FORGED}"
    log = github.log(result)
    assert f"::stop-commands::{word}" not in log
    assert {kind for kind, _, _ in rules.runner(log).annotations} == {"error"}


def test_the_summary_lists_every_check_and_explains_each_failure() -> None:
    """In a table that a renderer takes for one, then worst first."""
    result = real.real("first-hit-wins")
    shown = entries(result)
    page = GFM.render(github_summary.to_text(result))
    assert page.count("<tr>") == 1 + len(result["parts"]) + len(shown)
    assert "<h2>38.25 of 50 points</h2>" in page
    explained = re.findall(r"<h3>fail <code>([^<]*)</code></h3>\n<pre>", page)
    assert explained == [row.id for row in worst_first(shown)]


@pytest.mark.parametrize("flood", ["|", "\u6f22", '"', "x\n"])
def test_a_summary_fits_into_what_github_takes(flood: str) -> None:
    """One byte more than 1 MiB, and all of it is lost."""
    result = many_failures(60)
    for check in result["checks"]:
        texts = ("message", "expected", "got", "hint")
        check.update(dict.fromkeys(texts, flood * (4000 // len(flood))))
    written = github_summary.to_text(result)
    assert len(written.encode()) <= 1_048_576
    assert all(f"number&#45;{n}</code>" in written for n in range(60))


def test_a_check_that_has_nothing_to_say_tells_its_points_in_german() -> None:
    """Also the words around them."""
    told = github.classroom(real.real("right"), translator("de"))
    messages = [test["message"] for test in told["tests"]]
    assert any(message.endswith("(7 von 7)") for message in messages)
    assert not any(" of " in message for message in messages)


def test_what_classroom_s_reporter_is_started_with_fits_into_its_environment() -> None:
    """However long the texts are that a submission has a hand in."""
    result = real.real("first-hit-wins")
    for check in result["checks"]:
        check["verdict"], check["message"] = "fail", "\U0001f4a5 |@" * 5_000
    line = github.output(result)
    assert len(line) < 131_000
    room = rules.classroom(line)
    assert room.failed
    assert room.sent == (result["score"], result["max_score"])


@pytest.mark.parametrize(
    ("path", "file"),
    [
        ("student_stub/src/exercise03.cpp", "student_stub/src/exercise03.cpp"),
        ("exercise03.cpp", "src/exercise03.cpp"),
        (None, "src/exercise03.cpp"),
    ],
)
def test_an_annotation_stands_at_the_file_of_the_repository(
    path: str | None, file: str
) -> None:
    """Where the submission was a file alone, at its usual place."""
    result = real.real("first-hit-wins")
    result["submission"]["path"] = path
    annotations = rules.runner(github.log(result)).annotations
    assert annotations
    assert {properties["file"] for _, properties, _ in annotations} == {file}
