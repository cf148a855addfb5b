"""Hostile text in a result is only text in every file that is made of it."""

import json
import re
from typing import Any
from xml.etree import ElementTree

import pytest

from grader.language import translator
from grader.plain import one_line
from grader.report.as_json import Json, to_text
from grader.report.formats import FORMATS
from grader.report.hosts import (
    autolab,
    github,
    github_summary,
    gradescope,
    junit,
    prairielearn,
)
from tests.report import readers, real
from tests.report.everywhere import everywhere
from tests.report.hostile import HOSTILE
from tests.report.hosts import rules

TAGS = {"p", "h2", "h3", "pre", "code", "table", "thead", "tbody", "tr", "th", "td", "strong"}
FLOODS = ["x", "\x1b", '"', "\u6f22", "word ", "\n", "<", "&", ":", "::error::x\n", "a:"]


def hostile_results(text: str) -> list[Json]:
    """Put a text wherever a stranger can, and into a rubric's titles too."""
    results = [json.loads(to_text(grade)) for grade in everywhere(text)]
    for result in results:
        for number, part in enumerate(result["parts"]):
            part["title"] = one_line(f"{number} {text}", 200)
        result["checks"][1].update(hint=text, message=text)
    return results


def assert_harmless(result: Json) -> None:
    """Every host reads its file, finds the score, and acts on nothing else."""
    read = rules.gradescope(gradescope.to_text(result))
    assert (read.total, read.cut) == (result["score"], [])
    learn = rules.prairielearn(prairielearn.to_text(result).encode())
    assert learn.points_shown
    titles = [part["title"] for part in result["parts"]]
    lab = rules.autolab(autolab.to_text(result), titles)
    assert (lab.error, len(lab.scores)) == ("", len(titles))
    log = github.log(result)
    assert {kind for kind, _, _ in rules.runner(log).annotations} <= {"error", "warning"}
    room = rules.classroom(github.output(result))
    assert room.sent == (result["score"], result["max_score"])
    assert not readers.commands(room.log)
    ElementTree.fromstring(junit.to_text(result).encode())  # noqa: S314 - our own output
    tags = set(
        re.findall(r"</?(\w+)[ />]?", readers.GFM.render(github_summary.to_text(result)))
    )
    assert tags <= TAGS


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_changes_no_host_s_mind(name: str) -> None:
    """Graded, not compiled, refused."""
    for result in hostile_results(HOSTILE[name]):
        assert_harmless(result)


@pytest.mark.parametrize("flood", FLOODS)
def test_a_flood_fits_into_every_host(flood: str) -> None:
    """PrairieLearn takes 1 MiB and Gradescope 100,000 characters a field."""
    for result in hostile_results(flood * (20_000 // len(flood))):
        result["checks"] = [
            {**one, "id": f"{one['id']}-{n}", "score": 0, "max_score": 0}
            for n in range(5)
            for one in result["checks"]
        ]
        result["score"] = 0
        assert_harmless(result)


@pytest.mark.parametrize("name", real.every_result())
def test_the_same_result_gives_the_same_bytes(name: str) -> None:
    """Also after it was stored and read again, and nothing is changed in it."""
    result = real.every_result()[name]
    again: Any = json.loads(json.dumps(result))
    for written in (each for files in FORMATS.values() for each in files):
        first = written.write(result, str)
        assert first == written.write(again, str)
    assert result == again


def test_a_student_who_reads_german_is_told_in_german() -> None:
    """Our own words are translated; names of problems, which a site knows, are not."""
    result = real.real("first-hit-wins")
    words = translator("de")
    for written in (each for files in FORMATS.values() for each in files):
        if written.path != "github/output.txt":
            told = written.write(result, words)
            assert "38.25 von 50" in told.replace("&#46;", "."), written.path
    titles = [part["title"] for part in result["parts"]]
    assert not rules.autolab(autolab.to_text(result, words), titles).error
