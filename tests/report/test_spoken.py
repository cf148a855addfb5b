"""A result is told in German before a format is made of it, and stays as it was itself."""

import copy

import pytest

from grader.report.as_json import to_json
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
    assert "aber Fläche" in check["examples"][0]["message"]
    assert check["expected"].startswith("ein Treffer auf Fläche")
    same = ("id", "title", "score", "verdict", "location", "counterexample")
    for one, other in zip(told["checks"], before["checks"], strict=True):
        assert [one[name] for name in same] == [other[name] for name in same]


def test_english_is_the_result_itself() -> None:
    """Nothing is translated into the language that it is in."""
    result = to_json(samples.failing())
    assert in_language(result, "en") == result


@pytest.mark.parametrize("name", real.every_result())
def test_every_kind_of_result_can_be_told(name: str) -> None:
    """One that did not compile, or was refused, too."""
    assert in_language(real.every_result()[name], "de")["checks"]
