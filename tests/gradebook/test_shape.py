"""The small reader of our schema refuses what the full one refuses."""

import copy
import json
import math
from collections.abc import Callable
from typing import Any

import jsonschema
import pytest

from grader.gradebook.shape import KEYWORDS, ONLY_WORDS, fault_in
from grader.report.as_json import Json, schema_text
from tests.report import real

SCHEMA: Json = json.loads(schema_text())
FULL = jsonschema.Draft202012Validator(SCHEMA)


@pytest.mark.parametrize("name", real.every_result())
def test_what_the_grader_writes_is_accepted(name: str) -> None:
    """Whatever the ending."""
    assert fault_in(real.every_result()[name], SCHEMA) == ""


def keywords(schema: Json) -> set[str]:
    """Collect the keywords of a schema, not its names of properties."""
    found = set(schema)
    for word in ("properties", "$defs"):
        for below in schema.get(word, {}).values():
            found |= keywords(below)
    below = [schema.get("items"), schema.get("additionalProperties"), *schema.get("oneOf", [])]
    for one in below:
        found |= keywords(one) if isinstance(one, dict) else set()
    return found


def test_every_keyword_is_known() -> None:
    """One that is added to the schema has to be read here too."""
    assert keywords(SCHEMA) <= set(KEYWORDS) | ONLY_WORDS


def set_at(*path: Any) -> Callable[[Json], None]:  # noqa: ANN401 - keys, and last the value
    """Make a change: all but the last say where, the last what."""

    def change(result: Json) -> None:
        place: Any = result
        for key in path[:-2]:
            place = place[key]
        place[path[-2]] = path[-1]

    return change


CHANGES = {
    "score is a string": (set_at("score", "50"), "score is '50'"),
    "score is true": (set_at("score", True), "score is True"),
    "score below zero": (set_at("score", -1), "score is -1, but at least 0"),
    "maximum is null": (set_at("max_score", None), "max_score is None"),
    "another version": (set_at("schema", 2), "schema is 2, but 1"),
    "parts is an object": (set_at("parts", {}), "parts is an object, but array"),
    "an unknown verdict": (set_at("checks", 0, "verdict", "good"), "verdict is 'good'"),
    "an id with markup": (set_at("checks", 2, "id", "<b>"), r"checks\[2\].id"),
    "a part without a title": (set_at("parts", 0, {"id": "a"}), "title is missing"),
    "an unknown key": (set_at("more", 1), "more is there, but nothing"),
    "an unknown key deep": (set_at("timing", "x", 1), "timing.x is there"),
    "another file": (
        set_at("checks", 0, "location", {"file": "/etc/passwd", "line": 1, "function": ""}),
        "location",
    ),
    "a time that is none": (set_at("timing", "stages", "run", "long"), "timing.stages.run"),
    "seconds of a check": (set_at("checks", 0, "seconds", 1), "seconds is 1, but null"),
    "four examples": (
        set_at("checks", 0, "examples", [{"message": "", "expected": "", "got": ""}] * 4),
        "4 entries, but at most 3",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_what_the_schema_forbids_is_named(name: str) -> None:
    """With its place; the full reader of schemas refuses it as well."""
    change, said = CHANGES[name]
    result = copy.deepcopy(real.real("right"))
    change(result)
    with pytest.raises(jsonschema.ValidationError):
        FULL.validate(result)
    with pytest.raises(AssertionError, match=said):
        assert not fault_in(result, SCHEMA), fault_in(result, SCHEMA)


def test_an_id_ends_where_it_ends() -> None:
    """Python's `$` matches before a newline at the end as well; JSON Schema's does not."""
    result = real.real("right")
    result["checks"][2]["id"] += "\n"
    assert "checks[2].id" in fault_in(result, SCHEMA)


@pytest.mark.parametrize("value", [math.inf, math.nan, 1.5])
def test_a_number_that_is_none_is_refused(value: float) -> None:
    """JSON's 1e999 becomes infinite; and nobody examined one and a half things."""
    result = real.real("right")
    result["checks"][0]["examined"] = value
    assert fault_in(result, SCHEMA)


def test_not_an_object_at_all() -> None:
    """The whole may be anything."""
    assert fault_in([], SCHEMA) == "the whole is a list, but object is expected"
