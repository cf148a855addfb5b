"""The page of a class says what its rows say, counts right, and runs nothing of theirs."""

import csv
import io
import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from grader.report.as_json import to_json
from grader.report.class_row import (
    Row,
    averages,
    histogram,
    misconceptions,
    most_failed,
    row_of,
)
from grader.report.hints import told
from grader.report.html.classroom import to_class_page, to_csv
from grader.verify import every_check
from tests.report import samples
from tests.report.hostile import HOSTILE

CHECKS = [each.id for each in every_check()]


def row(name: str, score: float | None = 50.0, *failed: str, cause: str = "") -> Row:
    """Make a student who fails some checks."""
    verdicts = tuple((check, "fail" if check in failed else "pass") for check in CHECKS)
    causes = ((cause, CHECKS[3]),) if cause else ()
    return Row(
        name, f"students/{len(name)}/report.html", score, 50.0, 4.5, verdicts, causes, ""
    )


class Reader(HTMLParser):
    """Reads tags, and the cells of the table of students."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.rows: list[list[str]] = []
        self._inside = False
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note a tag."""
        self.tags.append((tag, dict(attrs)))
        if tag == "table":
            self._inside = dict(attrs).get("id") == "class"
        if self._inside and tag == "tr":
            self.rows.append([])
        if self._inside and tag in {"td", "th"}:
            self.rows[-1].append("")

    def handle_data(self, data: str) -> None:
        """Note text of a cell."""
        if self._inside and self.rows and self.rows[-1]:
            self.rows[-1][-1] += data

    def handle_endtag(self, tag: str) -> None:
        """Leave the table."""
        self._inside = self._inside and tag != "table"


def test_a_row_is_taken_from_a_result() -> None:
    """Points, time, a verdict for each check, and the likely cause of a failure."""
    result = to_json(samples.failing())
    made = row_of(result, "students/s0427/report.html")
    assert made.name == "s0427"
    assert made.score == result["score"]
    assert [check for check, _ in made.verdicts] == [one["id"] for one in result["checks"]]
    assert ("bvh.boxes-are-tight", "fail") in made.verdicts
    assert made.note == ""
    assert made.causes == (("A child gets the box of its parent.", "bvh.boxes-are-tight"),)


def test_a_withheld_score_stays_unknown() -> None:
    """It is no 0, and in no average."""
    made = row_of(to_json(samples.broken()), "")
    assert made.score is None
    assert averages([made, row("a", 40.0)]) == (40.0, 40.0)
    assert averages([made]) is None
    page = to_class_page([made, row("a", 40.0)], "", "en")
    cells = Reader(page).rows[1]
    assert cells[1] == "withheld"
    assert "Withheld scores: 1." in page


def test_what_did_not_compile_is_explained() -> None:
    """By the compiler's first error."""
    made = row_of(to_json(samples.uncompiled()), "")
    assert made.note.startswith("line ")
    assert row_of(to_json(samples.rejected()), "").note


def test_bars_count_every_known_score_once() -> None:
    """Full marks have a bar of their own; a score on a border belongs to the bar above it."""
    bars = histogram([row("a", 0.0), row("b", 5.0), row("c", 49.5), row("d"), row("e", None)])
    assert [(bar.begin, bar.students) for bar in bars if bar.students] == [
        (0.0, 1),
        (5.0, 1),
        (45.0, 1),
        (50.0, 1),
    ]
    assert histogram([]) == []


def test_the_most_failed_check_comes_first() -> None:
    """With the number of students who failed it."""
    rows = [row("a", 40, CHECKS[3], CHECKS[5]), row("b", 45, CHECKS[5]), row("c")]
    assert most_failed(rows) == [(CHECKS[5], 2), (CHECKS[3], 1)]


def test_only_a_misconception_of_several_is_one_of_the_class() -> None:
    """With the names of those who have it."""
    rows = [row("a", cause="x"), row("b", cause="y"), row("c", cause="y")]
    assert misconceptions(rows) == [("y", CHECKS[3], ["b", "c"])]


def test_namesakes_are_told_apart() -> None:
    """By their ids, else by their folders; the table calls them as the list does."""
    rows = [
        replace(row("Ada", cause="takes the first hit"), id="u1", link="students/a-u1/x.html"),
        replace(row("Ada", cause="takes the first hit"), link="students/ada/x.html"),
        replace(row("Ada", cause="takes the first hit"), link="students/ada-3f/x.html"),
    ]
    ((_, _, whose),) = misconceptions(rows)
    assert whose == ["Ada (u1)", "Ada (ada)", "Ada (ada-3f)"]
    shown = Reader(to_class_page(rows, "", "en")).rows[1:]
    assert [cells[0] for cells in shown] == whose


def test_one_comment_is_for_all_who_believe_the_same() -> None:
    """The misconception and the question of its check; never what there is to write."""
    rows = [row(name, cause="A child gets the box of its parent.") for name in ("a", "b")]
    page = to_class_page(rows, "", "en")
    question = told()[CHECKS[3]]["question"]
    assert f"<blockquote>A child gets the box of its parent. {question}</blockquote>" in page


def test_the_table_has_a_line_for_each_student() -> None:
    """In their order, with a sign for each verdict."""
    rows = [row("ada", 46.25, CHECKS[2]), row("bob")]
    table = Reader(to_class_page(rows, "", "en")).rows
    assert table[0][:3] == ["Student", "Points", "Time (s)"]
    assert [name.strip() for name in table[0][3:]] == CHECKS
    assert [line[0] for line in table[1:]] == ["ada", "bob"]
    assert table[1][1:3] == ["46.25", "4.5"]
    assert [sign.strip() for sign in table[1][3:6]] == ["✓", "✓", "✗"]


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_bring_no_tag_and_no_script(name: str) -> None:
    """The page has the same tags as with a harmless name."""
    harmless = Reader(
        to_class_page([row("harmless", 40.0, cause="c"), row("b", cause="c")], "", "en")
    )
    spoilt = replace(row(HOSTILE[name], 40.0, cause="c"), link="students/8/report.html")
    other = Reader(to_class_page([spoilt, row("b", cause="c")], "", "en"))
    assert [tag for tag, _ in other.tags] == [tag for tag, _ in harmless.tags]
    assert not any(key.startswith("on") for _, attributes in other.tags for key in attributes)


def test_the_policy_allows_our_script_and_our_style_alone() -> None:
    """Hashes stand for both; nothing is loaded from anywhere."""
    page = to_class_page([row("a")], "", "en")
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', page)
    assert policy.startswith("default-src &#39;none&#39;")
    assert len(re.findall(r"sha256-", policy)) == 2
    assert "unsafe" not in policy
    assert "http" not in policy


def test_the_saved_table_is_the_one_that_python_writes() -> None:
    """What the script puts together is `to_csv`, which no spreadsheet computes."""
    rows = [row("=1+1", 40.0, CHECKS[0]), row('a"b,c', None)]
    page = to_class_page(rows, "", "en")
    (text,) = re.findall(r'id="csv">(.*?)</script>', page, re.DOTALL)
    parts = json.loads(text)
    signs = {"pass": "p", "fail": "f"}
    lines = [parts["head"]]
    for one, first in zip(rows, parts["first"], strict=True):
        lines.append(",".join([first, *(parts["words"][signs[v]] for _, v in one.verdicts)]))
    assert "\r\n".join([*lines, ""]) == to_csv(rows)
    table = list(csv.reader(io.StringIO(to_csv(rows))))
    assert table[0][:4] == ["student", "score", "max_score", "seconds"]
    assert table[1][0] == "'=1+1"
    assert table[1][4] == "fail"
    assert table[2][:2] == ['a"b,c', ""]


def test_a_class_of_300_takes_200_kilobytes() -> None:
    """And one of none is a page, too."""
    rows = [
        row(f"s{number:04} Ødegård-Müller", 41.5, CHECKS[number % 20]) for number in range(300)
    ]
    assert len(to_class_page(rows, "", "en").encode()) < 200_000
    assert "0 submissions" in to_class_page([], "", "en")


def test_the_page_speaks_german() -> None:
    """Every text of ours; ids of checks stay."""
    page = to_class_page([row("a", 40.0, CHECKS[3])], "", "de")
    assert '<html lang="de">' in page
    assert "Abgaben, Mittelwert" in page
    assert "Submissions" not in page


def test_why_nothing_was_graded_is_told_in_german() -> None:
    """Our own words are; a compiler's stay, whatever they say."""
    rows = [
        replace(row("a"), note="no file is called exercise03.cpp"),
        replace(row("b"), note="line 7: no hit"),
    ]
    page = to_class_page(rows, "", "de")
    assert "<small>keine Datei heißt exercise03.cpp</small>" in page
    assert "<small>Zeile 7: no hit</small>" in page
    assert "<small>line 7: no hit</small>" in to_class_page(rows, "", "en")
