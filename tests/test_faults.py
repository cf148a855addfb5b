"""A traceback of ours goes into a file for a maintainer, and into no report."""

from collections.abc import Callable
from dataclasses import replace
from typing import NoReturn

import pytest

from grader.cli.progress import silent
from grader.errors import failed_here
from grader.kept import kept
from grader.model.cases import BuildCase
from grader.model.grade import Grade
from grader.options import Options
from grader.report.as_json import to_json, to_text
from grader.report.html.submission import to_html
from grader.selection import select
from grader.summary import Summary
from tests.report import samples
from tests.report.goldens import Screen, printed

BROKEN = "The grader itself failed here (KeyError); it costs no points."


def breaks(_: object) -> NoReturn:
    """Fail for our own reason.

    Raises:
        KeyError: Always.
    """
    raise KeyError("/opt/grader/secret")


def broken_grade() -> Grade:
    """Grade with a check that fails in two cases for our own reason."""
    selection = select(None, ())
    checks = tuple(
        replace(each, decide=breaks) if each.id == "build.compiles" else each
        for each in selection.checks
    )
    options = Options(41, None, (), silent)
    summary = Summary(replace(selection, checks=checks), options, "none")
    summary.examine([BuildCase("first", ()), BuildCase("second", ())])
    return summary.grade(samples.SUBMISSION, None, ())


@pytest.mark.parametrize(
    "written",
    [
        to_text,
        lambda grade: to_html(to_json(grade), None, "en"),
        lambda grade: printed(grade, Screen()).decode(),
    ],
    ids=["result.json", "report.html", "terminal"],
)
def test_no_report_holds_a_traceback(written: Callable[[Grade], str]) -> None:
    """A sentence says that it was us, and what kind of fault it was."""
    text = " ".join(written(broken_grade()).replace("│", " ").split())
    assert BROKEN in text
    for secret in ("Traceback", "secret", "test_faults", "engine.py"):
        assert secret not in text


def test_a_page_tells_it_in_german() -> None:
    """With the kind of fault as it is."""
    text = to_html(to_json(broken_grade()), None, "de")
    assert "Hier ist die Bewertung selbst gescheitert (KeyError)" in text


def test_a_grade_brings_the_traceback_along() -> None:
    """Of each check that broke once, with where that was; `kept` hands it on."""
    grade = broken_grade()
    assert grade.traceback.count("Traceback") == 1
    assert grade.traceback.startswith("build.compiles in first:\n")
    assert "secret" in grade.traceback
    assert "test_faults.py" in grade.traceback
    assert kept(grade).traceback == grade.traceback


def test_other_grades_have_none() -> None:
    """Nor has one that we withhold for a reason that we know."""
    assert kept(samples.broken()).traceback == ""


def test_a_fault_is_worded_by_its_kind() -> None:
    """What an exception says may name a file of ours."""
    assert failed_here(KeyError("/opt/grader/secret")) == BROKEN
