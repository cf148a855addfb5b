"""Reads every report of a grade as its readers would, and looks for what could act on them."""

import io
import json
import unicodedata
from collections.abc import Generator
from functools import cache
from typing import Any

import jsonschema
from rich.console import Console

from grader.model.grade import Grade
from grader.report.as_json import schema_text, to_text
from grader.report.failure import Occasion
from grader.report.terminal import print_grade

_DIRECTION = set("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")


def checked_reports(grade: Grade) -> str:
    """Everything that a reader could see, in which nothing acts on a terminal or a runner."""
    result = to_text(grade)
    validator().validate(json.loads(result))
    shown = io.StringIO()
    console = Console(file=shown, width=100, color_system=None, legacy_windows=False)
    print_grade(console, grade, Occasion("bvhgrade grade exercise03.cpp"))
    for line in shown.getvalue().split("\n"):
        assert not line.lstrip().startswith(("::", "##[")), line
    for text in (shown.getvalue(), *texts(json.loads(result))):
        active = {one for one in text if unicodedata.category(one) == "Cc"} - {"\n", "\t"}
        assert not active | (_DIRECTION & {*text}), text
    return shown.getvalue() + result + "".join(texts(json.loads(result)))


@cache
def validator() -> Any:  # noqa: ANN401 - what the library gives
    """What holds a result against its schema; to make one takes longer than to use it."""
    schema = json.loads(schema_text())
    return jsonschema.validators.validator_for(schema)(schema)


def texts(value: Any) -> Generator[str]:  # noqa: ANN401 - any JSON
    """Every text in a JSON value."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield key
            yield from texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from texts(inner)
