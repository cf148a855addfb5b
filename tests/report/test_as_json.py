"""result.json has the contract's shape, whatever the grade says."""

import json
from dataclasses import replace
from typing import Any

import jsonschema
import pytest

from grader.errors import OutputFault
from grader.model.grade import Grade
from grader.model.verdict import Verdict
from grader.report.as_json import schema_text, to_json, to_text
from tests.report import samples

SCHEMA = json.loads(schema_text())


def validate(result: object) -> None:
    """Check a result against the schema."""
    jsonschema.Draft202012Validator(SCHEMA).validate(result)


def no_constant(name: str) -> float:
    """Refuse what strict JSON does not have."""
    raise AssertionError(name)


def comparable(grade: Grade) -> Any:  # noqa: ANN401 - parsed JSON
    """Drop what may differ between two gradings of one submission."""
    result = json.loads(to_text(grade))
    del result["timing"], result["provenance"]["cpu"]
    return result


def test_the_schema_is_one() -> None:
    """It is itself valid, and strict at every object."""
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert_described(SCHEMA)


def assert_described(schema: Any) -> None:  # noqa: ANN401 - parsed JSON
    """Every property has a description, and no object takes unknown keys."""
    if isinstance(schema, list):
        for entry in schema:
            assert_described(entry)
    if not isinstance(schema, dict):
        return
    if schema.get("type") == "object":
        assert "additionalProperties" in schema
        assert schema["additionalProperties"] is not True
    for name, property_ in schema.get("properties", {}).items():
        assert "description" in property_, name
    for entry in schema.values():
        assert_described(entry)


@pytest.mark.parametrize("name", samples.EVERY)
def test_every_ending_fulfils_the_schema(name: str) -> None:
    """Withheld, rejected, not compiled, not started: all have the same shape."""
    validate(json.loads(to_text(samples.EVERY[name]()), parse_constant=no_constant))


@pytest.mark.parametrize("key", ["score", "checks", "timing", "provenance"])
def test_a_missing_or_unknown_key_is_refused(key: str) -> None:
    """The schema is strict, so the tests above are worth something."""
    result = to_json(samples.perfect())
    with pytest.raises(jsonschema.ValidationError):
        validate({**result, "more": 1})
    del result[key]
    with pytest.raises(jsonschema.ValidationError):
        validate(result)


def test_the_shape_is_the_contract() -> None:
    """Keys, their order and the values of one failed check."""
    result = to_json(samples.failing())
    assert list(result) == [
        "schema",
        "submission",
        "score",
        "max_score",
        "needs_review",
        "parts",
        "checks",
        "build",
        "timing",
        "provenance",
    ]
    boxes = next(one for one in result["checks"] if one["id"] == "bvh.boxes-are-tight")
    assert boxes == {
        "id": "bvh.boxes-are-tight",
        "part": "a",
        "title": "Every node's box is exactly the one of its triangles",
        "verdict": "fail",
        "score": 4.5,
        "max_score": 12,
        "visibility": "visible",
        "examined": 524287,
        "wrong": 2,
        "message": "node 1 of 3 triangles: one of them reaches out",
        "expected": "node 1 box.max = (1.25, 1, 0)",
        "got": "node 1 box.max = (0.75, 1, 0)",
        "hint": "A child gets the box of its parent. This explains 60 of 61 places.",
        "examples": [
            {
                "message": "strip-x of 9 faces, node 1: box.max is too small",
                "expected": "node 1 box.max = (1.25, 1, 0)",
                "got": "node 1 box.max = (0.75, 1, 0)",
            }
        ],
        "blocked_by": None,
        "stop": "finished",
        "location": {"file": "src/exercise03.cpp", "line": 7, "function": "boxOf"},
        "counterexample": {
            "faces": 5,
            "rays": 0,
            "file": "counterexamples/bvh.boxes-are-tight.json",
            "message": "node 1: box is too small",
            "expected": "node 1 box.max = (0.5, 1, 0)",
            "got": "node 1 box.max = (0.25, 1, 0)",
            "explanation": "",
        },
        "seconds": None,
    }


def test_only_timing_and_processor_may_differ() -> None:
    """Two runs that took different times on different machines compare equal."""
    grade = samples.failing()
    assert grade.build is not None
    slower = replace(
        grade,
        build=replace(grade.build, seconds=99.0),
        checks=tuple(replace(score, seconds=98.0) for score in grade.checks),
        timing=replace(samples.TIMING, compile=99.0, total=200.0, stages=(("run", 9.0),)),
        provenance=replace(samples.PROVENANCE, cpu="Another processor"),
    )
    assert comparable(slower) == comparable(grade)
    assert to_json(slower)["timing"]["checks"]["bvh.boxes-are-tight"] == 98
    assert to_json(slower)["timing"]["compile"] == 99


def test_a_score_nobody_knows_is_null_and_never_zero() -> None:
    """Our fault withholds the check, what waits for it, its part and the sum."""
    result = to_json(samples.broken())
    known = {one["id"]: one["score"] for one in result["checks"]}
    assert result["score"] is None
    assert result["needs_review"] is True
    assert [part["score"] for part in result["parts"]] == [25, None]
    assert known["work.uses-the-tree"] is None
    assert known["hits.closest-wins"] is None
    assert known["hits.survives-every-ray"] == 3


def test_a_broken_check_withholds_the_score_even_if_a_sum_was_made() -> None:
    """The report does not trust whoever set the number."""
    result = to_json(replace(samples.broken(), score=27, needs_review=False))
    assert result["score"] is None
    assert result["needs_review"] is True


def test_a_rejected_submission_has_no_file_but_a_reason() -> None:
    """What cannot be known is null, and the reason stands where errors stand."""
    result = to_json(samples.rejected())
    assert result["submission"] == {"name": "s0428", "sha256": None, "path": None}
    assert "two exercise03.cpp" in result["build"]["diagnostics"][0]["text"]


def test_a_whole_function_is_named_if_no_line_is_known() -> None:
    """The function's first line comes from the compiler's view of the file."""
    result = to_json(samples.failing())
    closest = next(one for one in result["checks"] if one["id"] == "hits.closest-wins")
    assert closest["location"] == {
        "file": "src/exercise03.cpp",
        "line": 15,
        "function": "intersect",
    }


def test_a_check_that_passed_points_nowhere() -> None:
    """There is nothing to look at."""
    assert all(one["location"] is None for one in to_json(samples.perfect())["checks"])


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf")])
def test_a_number_that_json_lacks_is_our_fault(value: float) -> None:
    """It is raised, never written."""
    with pytest.raises(OutputFault):
        to_text(replace(samples.perfect(), score=value))


def test_the_same_grade_gives_the_same_text() -> None:
    """Nothing depends on order or time."""
    assert to_text(samples.failing()) == to_text(samples.failing())


def test_verdicts_are_the_contract_s_words() -> None:
    """The enumeration and the schema agree."""
    allowed = SCHEMA["$defs"]["check"]["properties"]["verdict"]["enum"]
    assert allowed == [verdict.value for verdict in Verdict]


def test_a_remark_on_the_run_is_a_note() -> None:
    """What a submission did while running, and what costs nothing, stands with the build."""
    grade = samples.perfect()
    assert grade.build is not None
    told = to_json(replace(grade, build=replace(grade.build, remarks=("it prints a lot",))))
    assert told["build"]["diagnostics"][-1] == {
        "line": 0,
        "column": 0,
        "severity": "note",
        "text": "it prints a lot",
    }
