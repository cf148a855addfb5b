"""Every host arrives at the points of the result, or at none; nothing never becomes 0."""

import json
from xml.etree import ElementTree

import pytest

from grader.report.as_json import Json
from grader.report.hosts import (
    autolab,
    github,
    github_summary,
    gradescope,
    junit,
    prairielearn,
)
from tests.report import real
from tests.report.hosts import rules

RESULTS = real.every_result()
KNOWN = {name: result for name, result in RESULTS.items() if result["score"] is not None}


def titles(result: Json) -> list[str]:
    """Name the problems as a teacher defines them in Autolab."""
    return [part["title"] for part in result["parts"]]


@pytest.mark.parametrize("name", KNOWN)
def test_gradescope_arrives_at_the_score(name: str) -> None:
    """So does the sum of its tests, which is what a student adds up."""
    result = KNOWN[name]
    read = rules.gradescope(gradescope.to_text(result))
    assert (read.failed, read.total, read.cut) == ("", result["score"], [])
    written = json.loads(gradescope.to_text(result))["tests"]
    assert sum(one["score"] for one in written) == result["score"]
    assert sum(one["max_score"] for one in written) == result["max_score"]


@pytest.mark.parametrize("name", KNOWN)
def test_gradescope_marks_each_test_as_the_check_ended(name: str) -> None:
    """Also gates, whose 0 of 0 points would count as passed."""
    result = KNOWN[name]
    read = rules.gradescope(gradescope.to_text(result))
    wanted = [
        "passed" if one["verdict"] == "pass" else "failed"
        for one in result["checks"]
        if one["visibility"] == "visible"
    ]
    assert [rules.gradescope_status(one) for one in read.seen] == wanted


@pytest.mark.parametrize("name", KNOWN)
def test_prairielearn_arrives_at_the_score(name: str) -> None:
    """And shows points, since every test has both numbers."""
    result = KNOWN[name]
    read = rules.prairielearn(prairielearn.to_text(result).encode())
    assert read.share is not None
    assert read.share * result["max_score"] == pytest.approx(result["score"])
    assert 0 <= read.share <= 1
    assert read.points_shown
    assert sum(one["points"] for one in read.tests) == result["score"]
    assert sum(one["max_points"] for one in read.tests) == result["max_score"]


@pytest.mark.parametrize("name", KNOWN)
def test_autolab_stores_the_points_of_each_part(name: str) -> None:
    """Under the names of the rubric's parts."""
    result = KNOWN[name]
    read = rules.autolab(autolab.to_text(result), titles(result))
    assert not read.error
    assert read.scores == {part["title"]: part["score"] for part in result["parts"]}


@pytest.mark.parametrize("name", KNOWN)
def test_classroom_is_sent_the_score(name: str) -> None:
    """The reporter adds up the tests; the job fails unless every check holds."""
    result = KNOWN[name]
    read = rules.classroom(github.output(result))
    assert read.sent == (result["score"], result["max_score"])
    assert read.failed == any(one["verdict"] != "pass" for one in result["checks"])


@pytest.mark.parametrize("name", RESULTS)
def test_junit_counts_what_it_holds(name: str) -> None:
    """GitLab drops a name that it has seen, so none is dropped here."""
    result = RESULTS[name]
    root = ElementTree.fromstring(junit.to_text(result).encode())  # noqa: S314 - our own output
    cases = list(root.iter("testcase"))
    names = {(case.get("classname"), case.get("name")) for case in cases}
    assert len(names) == len(cases) == int(root.get("tests", "0"))
    for group in (root, *root.iter("testsuite")):
        for count, tag in (
            ("failures", "failure"),
            ("errors", "error"),
            ("skipped", "skipped"),
        ):
            assert len(list(group.iter(tag))) == int(group.get(count, "-1"))
    points = [
        float(one.get("value", "nan"))
        for case in cases
        for one in case.iter("property")
        if one.get("name") == "points"
    ]
    if result["score"] is not None:
        assert sum(points) == result["score"]


@pytest.mark.parametrize(
    ("stop", "kind"),
    [
        ("finished", "Wrong"),
        ("crashed", "Crash"),
        ("timed_out", "Timeout"),
        ("out_of_memory", "OutOfMemory"),
        ("forbidden", "Forbidden"),
        ("failed_to_start", "FailedToStart"),
    ],
)
def test_junit_says_how_a_submission_ended(stop: str, kind: str) -> None:
    """A crash of a student's code is a failure, and no error, which is ours."""
    result = real.real("crash-on-a-miss")
    for check in result["checks"]:
        check["stop"] = stop if check["stop"] == "crashed" else check["stop"]
    root = ElementTree.fromstring(junit.to_text(result).encode())  # noqa: S314 - our own output
    assert kind in {failure.get("type") for failure in root.iter("failure")}
    assert not list(root.iter("error"))


@pytest.mark.parametrize("name", ["withheld", real.OVERLOADED])
def test_a_withheld_score_is_no_number_anywhere(name: str) -> None:
    """Each host gets what it leaves without a score, and a sentence that says why."""
    result = RESULTS[name]
    known = gradescope.to_text(result)
    assert rules.gradescope(known).failed
    assert {rules.gradescope_status(one) for one in rules.gradescope(known).seen} == {
        "informational"
    }
    learn = rules.prairielearn(prairielearn.to_text(result).encode())
    assert (learn.graded, learn.share) == (False, None)
    assert "withheld" in learn.errors[0]
    lab = rules.autolab(autolab.to_text(result), titles(result))
    assert not lab.error
    assert lab.scores == {part["title"]: None for part in result["parts"]}
    assert "withheld" in autolab.to_text(result).splitlines()[0]
    room = rules.classroom(github.output(result))
    assert (room.sent, room.failed) == (None, True)
    ((kind, _, message),) = rules.runner(github.log(result)).annotations
    assert kind == "error"
    assert "withheld" in message
    root = ElementTree.fromstring(junit.to_text(result).encode())  # noqa: S314 - our own output
    broken = sum(one["verdict"] == "broken" for one in result["checks"])
    assert len(list(root.iter("error"))) == broken > 0
    assert not [one for one in root.iter("property") if one.get("name") == "score"]
    assert "withheld" in github_summary.to_text(result).splitlines()[0]


def test_autolab_leaves_all_problems_open_if_no_part_is_doubtful() -> None:
    """An empty list of scores would give 0 for everything."""
    result = dict(RESULTS["right"], score=None, needs_review=True)
    read = rules.autolab(autolab.to_text(result), titles(result))
    assert not read.error
    assert list(read.scores.values()) == [None, None]


@pytest.mark.parametrize("title", ["Part a: BVH", "a::b", 'say "x":', "back\\n: slash", "é:1"])
def test_autolab_reads_a_title_with_a_colon(title: str) -> None:
    """It would put quotes around the word before it, in the middle of the text."""
    result = real.real("right")
    result["parts"][0]["title"] = title
    read = rules.autolab(autolab.to_text(result), titles(result))
    assert not read.error
    assert read.scores[title] == 25


def test_the_stand_in_for_autolab_falls_into_its_trap() -> None:
    """Otherwise the test above would be worth nothing."""
    semantic = '{"_presentation":"semantic","stages":[]}\n'
    assert rules.autolab(semantic + '{"scores":{"Part a: x":1}}', ["Part a: x"]).error
    assert rules.autolab(semantic + '{"scores":{}}', ["a"]).scores == {"a": 0}
    assert not rules.autolab(semantic + '{"scores":{"a":1}}', ["a"]).error
    with pytest.raises(TypeError):
        rules.autolab(semantic + '{"scores":{"a":null}}', ["a"])


def test_two_parts_of_one_title_keep_their_points_in_autolab() -> None:
    """They get the names a and b."""
    result = real.real("first-hit-wins")
    for part in result["parts"]:
        part["title"] = "Exercise"
    scores = [part["score"] for part in result["parts"]]
    read = rules.autolab(autolab.to_text(result), ["a", "b"])
    assert list(read.scores.values()) == scores


def test_a_rubric_without_points_is_no_division_by_zero() -> None:
    """PrairieLearn wants a share of nothing."""
    result = dict(real.real("right"), score=0, max_score=0)
    assert rules.prairielearn(prairielearn.to_text(result).encode()).share == 0
