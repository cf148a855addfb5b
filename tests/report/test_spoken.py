"""A result is told in German before a format is made of it, and stays as it was itself."""

import copy
from dataclasses import replace

import pytest

from grader.model.stages import Rejected
from grader.report.as_json import to_json
from grader.report.hosts import gradescope
from grader.report.html.submission import to_html
from grader.report.spoken import in_language
from tests.report import real, samples


def test_messages_are_told_and_nothing_else_changes() -> None:
    """Ids, points and titles are what they were; the given result, too."""
    result = real.real("first-hit-wins")
    before = copy.deepcopy(result)
    told = in_language(result, "de")
    assert result == before
    check = next(one for one in told["checks"] if one["id"] == "hits.closest-wins")
    assert "falsch, zuerst in" in check["message"]
    assert "aber Dreieck" in check["examples"][0]["message"]
    assert check["expected"].startswith("ein Treffer auf Dreieck")
    same = ("id", "title", "score", "verdict", "location", "counterexample")
    for one, other in zip(told["checks"], before["checks"], strict=True):
        assert [one[name] for name in same] == [other[name] for name in same]


def test_why_a_file_was_refused_is_told() -> None:
    """In the place of what a compiler says."""
    result = to_json(
        replace(
            samples.rejected(), submission=Rejected("ada", "no file is called exercise03.cpp")
        )
    )
    (said,) = in_language(result, "de")["build"]["diagnostics"]
    assert said["text"] == "keine Datei heißt exercise03.cpp"
    assert "keine Datei heißt" in gradescope.to_text(in_language(result, "de"))
    assert "keine Datei heißt exercise03.cpp" in to_html(result, None, "de")


def test_remarks_are_told_and_a_compiler_s_words_are_not() -> None:
    """Whatever they say, and wherever they stand."""
    result = to_json(samples.uncompiled())
    text = "it prints more than 64 KiB in one run; the rest was dropped"
    note = {"line": 0, "column": 0, "severity": "note", "text": text}
    error = note | {"severity": "error", "text": "no hit"}
    build = result["build"] | {"diagnostics": [error, note | {"line": 3}, note]}
    first, second, third = in_language(result | {"build": build}, "de")["build"]["diagnostics"]
    assert (first["text"], second["text"]) == ("no hit", text)
    assert third["text"].startswith("sie gibt in einem Lauf mehr als 64 KiB aus")


def test_english_is_the_result_itself() -> None:
    """Nothing is translated into the language that it is in."""
    result = to_json(samples.failing())
    assert in_language(result, "en") == result


@pytest.mark.parametrize("name", real.every_result())
def test_every_kind_of_result_can_be_told(name: str) -> None:
    """One that did not compile, or was refused, too."""
    assert in_language(real.every_result()[name], "de")["checks"]
