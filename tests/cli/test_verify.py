"""`bvhgrade verify` says whether a result still holds, or which part of it does not."""

import json
from dataclasses import replace
from pathlib import Path

from grader.cli.verify import differences
from grader.report.as_json import to_json, to_text
from tests.cli.calls import Pipeline, call
from tests.report import samples


def test_a_result_is_reproduced(pipeline: Pipeline, tmp_path: Path) -> None:
    """With the seed that it names."""
    stored = tmp_path / "result.json"
    seven = replace(samples.perfect().provenance, seed=7)
    pipeline.answer = lambda: replace(samples.perfect(), provenance=seven)
    stored.write_text(to_text(pipeline.answer()))
    ended = call("verify", str(stored), "src/exercise03.cpp")
    assert (ended.exit_code, ended.output) == (0, "reproduced: 50 of 50\n")
    assert pipeline.asked[0][1].seed == 7


def test_what_differs_is_named(pipeline: Pipeline, tmp_path: Path) -> None:
    """The points, the check, and the part of the provenance that may be why."""
    stored = tmp_path / "result.json"
    older = replace(samples.perfect().provenance, compiler="g++ 9.4.0")
    stored.write_text(to_text(replace(samples.perfect(), provenance=older)))
    pipeline.answer = samples.failing
    ended = call("verify", str(stored), "src/exercise03.cpp")
    assert ended.exit_code == 1
    assert "provenance, compiler: g++ 9.4.0 -> " in ended.output
    assert "points, 50 of 50 -> " in ended.output
    assert "check, bvh.boxes-are-tight: pass 12 of 12 -> fail " in ended.output


def test_another_file_is_noticed() -> None:
    """Equal points of two files prove nothing."""
    stored = to_json(samples.perfect())
    other = json.loads(json.dumps(stored))
    other["submission"]["sha256"] = "0" * 64
    assert differences(stored, other) == ["the submission is not the file that was graded"]


def test_a_file_that_is_no_result_is_refused(pipeline: Pipeline, tmp_path: Path) -> None:
    """With a sentence."""
    (tmp_path / "x.json").write_text("{}")
    ended = call("verify", str(tmp_path / "x.json"), "src/exercise03.cpp")
    assert ended.exit_code == 2
    assert "Traceback" not in ended.output
