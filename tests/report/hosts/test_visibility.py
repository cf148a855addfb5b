"""What the rubric hides is shown by no host, and its points still count."""

import base64
import json

import pytest

from grader.report.as_json import Json
from grader.report.formats import FORMATS
from grader.report.hosts import gradescope
from grader.report.hosts.told import NOT_SHOWN, entries
from tests.report import real
from tests.report.hosts import rules

SECRET = "only the hidden check says this"


def result_with_secret() -> Json:
    """Hide a check that fails, with a word in all of its texts, and let others wait for it."""
    result = real.partly_hidden("first-hit-wins")
    for check in result["checks"]:
        if check["id"] == "hits.closest-wins":
            check.update(message=SECRET, expected=SECRET, got=SECRET, hint=SECRET)
            check["examples"] = [{"message": SECRET, "expected": SECRET, "got": SECRET}]
        if check["id"] == "hits.record-is-complete":
            message = "earns nothing because `hits.closest-wins` fails everywhere"
            check.update(verdict="blocked", blocked_by="hits.closest-wins", message=message)
    return result


def everything(result: Json) -> dict[str, str]:
    """Write every file; base64 is read, since a student can do that too."""
    told = {}
    for written in (each for files in FORMATS.values() for each in files):
        text = written.write(result, str)
        if text.startswith("result="):
            text = base64.b64decode(text.partition("=")[2]).decode()
        told[written.path] = text
    return told


@pytest.mark.parametrize("path", everything(real.real("right")))
def test_nothing_of_a_hidden_check_is_told(path: str) -> None:
    """Neither its name nor its texts, nor that others wait for it; Gradescope hides itself."""
    text = everything(result_with_secret())[path]
    if path == "gradescope/results.json":
        read = rules.gradescope(text)
        text = str([one["output"] + one["name"] for one in read.seen])
        assert not read.total_seen
    plain = text.replace("&#46;", ".").replace("&#45;", "-")
    for word in (SECRET, "closest-wins", "equals-mitsuba"):
        assert word not in plain
    assert "is-readable" in plain


def test_gradescope_is_told_what_to_hide_and_until_when() -> None:
    """It has a word for each of the rubric's."""
    result = result_with_secret()
    read = rules.gradescope(gradescope.to_text(result))
    shown = [one["id"] for one in result["checks"] if one["visibility"] == "visible"]
    assert [one["tags"][0] for one in read.seen] == shown
    told = gradescope.to_text(result)
    assert told.count('"visibility": "hidden"') == 1
    assert told.count('"visibility": "after_due_date"') == 1


@pytest.mark.parametrize("name", ["right", "first-hit-wins"])
def test_gradescope_is_told_no_sum_that_gives_hidden_points_away(name: str) -> None:
    """It hides the total, but never the text above the checks."""
    told = json.loads(gradescope.to_text(real.partly_hidden(name)))
    assert told["output"] == ""
    assert told["score"] == real.real(name)["score"]
    assert "50" in json.loads(gradescope.to_text(real.real(name)))["output"]


def test_gradescope_is_told_why_there_is_no_score_though_checks_are_hidden() -> None:
    """Ours or the student's fault: neither is a sum."""
    broken = real.withheld()
    broken["checks"][0]["visibility"] = "hidden"
    (said,) = json.loads(gradescope.to_text(broken))["output"].split("\n")
    assert said.startswith("The score is withheld")
    refused = real.real("uncompiled")
    refused["checks"][0]["visibility"] = "after_due_date"
    said = json.loads(gradescope.to_text(refused))["output"]
    assert said.startswith("The file does not compile")


@pytest.mark.parametrize(("name", "verdict"), [("right", "pass"), ("first-hit-wins", "fail")])
def test_what_is_not_shown_is_one_row_with_its_points(name: str, verdict: str) -> None:
    """Which of them failed cannot be told from it."""
    result = real.partly_hidden(name)
    hidden = [one for one in result["checks"] if one["visibility"] != "visible"]
    (entry,) = (each for each in entries(result) if each.id == NOT_SHOWN)
    assert entry.score == sum(one["score"] for one in hidden)
    assert entry.max_score == sum(one["max_score"] for one in hidden) == 10
    assert (entry.verdict, entry.text) == (verdict, "")


def test_a_hidden_check_that_broke_withholds_the_row() -> None:
    """And says that this costs nothing."""
    result = real.withheld()
    for check in result["checks"]:
        if check["verdict"] == "broken":
            check["visibility"] = "hidden"
    (entry,) = (each for each in entries(result) if each.id == NOT_SHOWN)
    assert (entry.verdict, entry.score) == ("broken", None)
    assert "costs no points" in entry.text


@pytest.mark.parametrize("path", everything(real.real("right")))
def test_no_traceback_of_ours_is_told(path: str) -> None:
    """It is for a maintainer, and names files of a machine."""
    text = everything(real.withheld())[path]
    assert "Traceback" not in text
    assert "/opt/grader" not in text


@pytest.mark.parametrize("path", everything(real.real("right")))
def test_no_sum_of_a_part_gives_hidden_points_away(path: str) -> None:
    """Beside the visible rows it would say what the hidden ones of that part earn.

    Autolab knows nothing but such sums, and Gradescope's output is empty then.
    """
    whole, partly = real.real("first-hit-wins"), real.partly_hidden("first-hit-wins")
    title = next(part["title"] for part in whole["parts"])
    told = f"{title}: 25 of 25"
    with_sums = [name for name, text in everything(whole).items() if told in text]
    assert "prairielearn/results.json" in with_sums
    assert told not in everything(partly)[path]


def test_the_seed_is_told_only_where_nothing_is_hidden() -> None:
    """Whoever has the grader draws with it what hidden checks look at."""
    name = 'name="seed"'
    assert name in everything(real.real("right"))["junit.xml"]
    assert name not in everything(real.partly_hidden("right"))["junit.xml"]
