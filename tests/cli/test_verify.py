"""`bvhgrade verify` says whether a result still holds, or which part of it does not."""

import hashlib
import json
from dataclasses import replace
from pathlib import Path

from grader.batch.records import Student
from grader.batch.store import opened_store
from grader.cli.verify import differences
from grader.model.grade import Grade
from grader.model.stages import Submission
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


def test_a_class_holds_what_was_graded(pipeline: Pipeline, tmp_path: Path) -> None:
    """Its result needs no second name, unless it is of another class."""
    source = b"int x;"
    sha256 = hashlib.sha256(source).hexdigest()
    with opened_store(tmp_path) as store:
        ada = Student("a", "ada", "Ada", "", "", "plain", "x.cpp", sha256, "", "", "")
        store.put(ada, source)
    own = Submission("Ada", "x.cpp", source, sha256)
    grade = replace(samples.perfect(), submission=own)
    read: list[bytes] = []

    def answer() -> Grade:
        read.append(pipeline.asked[-1][0].read_bytes())
        return grade

    pipeline.answer = answer
    stored = tmp_path / "ada" / "result.json"
    stored.parent.mkdir()
    stored.write_text(to_text(grade))
    ended = call("verify", str(stored))
    assert (ended.exit_code, ended.output) == (0, "reproduced: 50 of 50\n")
    assert read == [source]
    stored.write_text(to_text(samples.perfect()))
    ended = call("verify", str(stored))
    assert ended.exit_code == 2
    assert "no submission with that content" in ended.output


def test_a_result_alone_needs_its_file(pipeline: Pipeline, tmp_path: Path) -> None:
    """And says how to name it."""
    stored = tmp_path / "result.json"
    stored.write_text(to_text(samples.perfect()))
    ended = call("verify", str(stored))
    assert ended.exit_code == 2
    assert "bvhgrade verify RESULT SUBMISSION" in ended.output
    assert not pipeline.asked


def test_a_result_without_a_file_says_so(pipeline: Pipeline, tmp_path: Path) -> None:
    """Nothing was handed in that could be graded, so no store holds it either."""
    with opened_store(tmp_path):
        pass
    stored = tmp_path / "result.json"
    stored.write_text(to_text(samples.rejected()))
    ended = call("verify", str(stored))
    assert ended.exit_code == 2
    assert "tells of no file: none was found in what was handed in" in ended.output
    assert "bvhgrade verify RESULT SUBMISSION" in ended.output
    assert not pipeline.asked


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
