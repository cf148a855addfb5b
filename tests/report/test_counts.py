"""Large counts are German in German, and nothing else that has digits and commas changes."""

import copy
import io
from dataclasses import replace

import pytest
from rich.console import Console

from grader.language import translator
from grader.model.grade import Cause
from grader.phrases import counted, regrouped, teller
from grader.report.as_json import to_json
from grader.report.hints import likely_cause
from grader.report.hosts import github, github_summary
from grader.report.html.submission import to_html
from grader.report.nodes import node_table
from grader.report.sheet import Sheet
from grader.report.spoken import in_language
from tests.report import samples
from tests.report.goldens import OCCASION, Screen, printed
from tests.report.html.pages import Reader
from tests.report.small_inputs import small_trace

GERMAN = teller("de")
ENGLISH = "4,480 of 15,043 wrong, first in `scene-1,000`: node 3: the box is (1, 2, 345)"


@pytest.mark.parametrize(
    ("english", "german"),
    [
        ("4,480 of 15,043 wrong", "4.480 von 15.043 falsch"),
        ("1,234,567 faces, 1 ray", "1.234.567 Dreiecke, 1 Strahl"),
        ("at most 4,194,304 nodes", "höchstens 4.194.304 Knoten"),
        ("1,000 entries", "1.000 Einträge"),
        ("999 entries", "999 Einträge"),
        ("ended by 0,123", "beendet durch 0,123"),
        ("ended by 12,34", "beendet durch 12,34"),
    ],
)
def test_a_count_is_told_in_german(english: str, german: str) -> None:
    """Groups of three digits, of which the first does not begin with a zero."""
    assert GERMAN(english) == german
    assert teller("en")(english) == english


@pytest.mark.parametrize(
    ("english", "german"),
    [
        ("threw an exception: 1,000 of 2,000", "warf eine Ausnahme: 1,000 of 2,000"),
        ("threw an exception: 1,000", "warf eine Ausnahme: 1,000"),
        ("1 of 2 wrong, first in `1,000`", "1 von 2 falsch, zuerst in `1,000`"),
        ("face 1 at t = 2: t is (1,000)", "Dreieck 1 bei t = 2: t ist (1,000)"),
        ("1,000: the file is empty; was it saved before it was handed in?", "1,000: die"),
        ("3 of 4,000 things that nobody knows", "3 of 4,000 things that nobody knows"),
    ],
)
def test_what_is_no_count_of_ours_stays(english: str, german: str) -> None:
    """Names, coordinates, a stranger's words, and sentences that are not translated."""
    assert GERMAN(english).startswith(german)


def test_counts_are_written_in_both_languages() -> None:
    """The sign between the groups is the catalogue's."""
    assert (counted(14811), counted(14811, translator("de"))) == ("14,811", "14.811")
    assert regrouped("1,000,000", translator("de")) == "1.000.000"


def test_the_terminal_counts_in_german() -> None:
    """Message, cause and the lines that were left out."""
    grade = samples.changed(c7=replace(samples.first_hit_wins(), message=ENGLISH))
    told = printed(grade, Screen(width=120), replace(OCCASION, language="de")).decode()
    assert "4.480 von 15.043 falsch, zuerst in `scene-1,000`" in told
    assert "4,480 of 15,043" in printed(grade, Screen(width=120)).decode()
    many = replace(samples.first_hit_wins(), cause=Cause("a", "A.", 1234, 56789))
    assert "1.234 von 56.789" in likely_cause(many, translator("de"))
    assert "1,234 of 56,789" in likely_cause(many)
    sheet = Sheet(Console(width=80), translator("de"))
    assert "[... 1.490 Zeilen ...]" in sheet.wrapped("x\n" * 1500, 80)


def test_the_page_counts_in_german() -> None:
    """What was found, its cause, and the sign that the script puts."""
    result = to_json(samples.failing())
    failed = next(one for one in result["checks"] if one["verdict"] == "fail")
    failed |= {"message": ENGLISH, "hint": "A. This explains 1,000 of 2,000 places."}
    shown = to_html(result, None, "de")
    told = Reader(shown).text
    assert "4.480 von 15.043 falsch, zuerst in scene-1,000" in told
    assert "A. Das erklärt 1.000 von 2.000 Stellen." in told
    assert '"group":"."' in shown
    assert '"group":","' in to_html(result, None, "en")
    assert "4,480 of 15,043 wrong" in Reader(to_html(result, None, "en")).text


def test_github_counts_in_german() -> None:
    """The log, the summary and what Classroom is told."""
    result = to_json(samples.failing())
    failed = next(one for one in result["checks"] if one["verdict"] == "fail")
    failed |= {"message": ENGLISH, "hint": "A. This explains 1,000 of 2,000 places."}
    words, told = translator("de"), in_language(copy.deepcopy(result), "de")
    for text in (github.log(told, words), github_summary.to_text(told, words)):
        assert "4.480 von 15.043 falsch" in text
        assert "1.000 von 2.000 Stellen" in text
        assert "scene-1,000" in text
    tests = github.classroom(told, words)["tests"]
    assert any("4.480 von 15.043 falsch" in one["message"] for one in tests)
    assert not any("points" in one["message"] or "gate" in one["message"] for one in tests)
    assert "4,480 of 15,043 wrong" in github.log(result)


def test_the_cells_of_a_tree_are_told() -> None:
    """A ray hits a box or misses it, in German too."""
    stream = io.StringIO()
    console = Console(file=stream, width=120, color_system=None)
    sheet = Sheet(console, translator("de"), GERMAN)
    table = small_trace().table
    assert table is not None
    node_table(sheet, table)
    sheet.show()
    assert "getroffen" in stream.getvalue()
    assert "hit" not in stream.getvalue()
