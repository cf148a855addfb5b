"""`bvhgrade verify` says whether a result still holds, or which part of it does not."""

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch.records import Student
from grader.batch.settings import Settings, Wish
from grader.batch.store import opened_store
from grader.cli.verify import differences
from grader.model.grade import Grade
from grader.model.stages import Rejected, Submission
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
    stored = tmp_path / "students" / "ada" / "result.json"
    stored.parent.mkdir(parents=True)
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


def test_where_only_the_provenance_differs_points_are_said_to_be_the_same(
    pipeline: Pipeline, tmp_path: Path
) -> None:
    """Something differs, so it is not reproduced; but nobody has to fear for points."""
    stored = tmp_path / "result.json"
    older = replace(samples.perfect().provenance, compiler="g++ 9.4.0")
    stored.write_text(to_text(replace(samples.perfect(), provenance=older)))
    ended = call("verify", str(stored), "src/exercise03.cpp")
    first, second = ended.output.splitlines()
    assert ended.exit_code == 1
    assert first.startswith("provenance, compiler: g++ 9.4.0 -> ")
    assert second == "points: the same, 50 of 50"


def in_a_class(folder: Path, written: Settings, grade: Grade) -> Path:
    """Keep a grade as a class does whose settings are these, or were."""
    source = b"int x;"
    sha256 = hashlib.sha256(source).hexdigest()
    ada = Student("a", "ada", "Ada", "", "", "plain", "x.cpp", sha256, "", "", written.digest)
    with opened_store(folder) as store:
        store.know(CLASS)
        store.put(ada, source)
    stored = folder / "students" / "ada" / "result.json"
    stored.parent.mkdir(parents=True)
    own = Submission("Ada", "x.cpp", source, sha256)
    stored.write_text(to_text(replace(grade, submission=own)))
    return stored


CLASS = Settings("0.1.0 (1234, g++ 12)", "1" * 64, "2" * 64, 41, "A", 300.0)


@pytest.fixture
def now(monkeypatch: pytest.MonkeyPatch) -> list[Wish]:
    """Settle whatever is wished with another grader; gives the wishes."""
    wishes: list[Wish] = []

    def settled(wish: Wish) -> Settings:
        wishes.append(wish)
        return replace(CLASS, grader="0.1.0 (5678, g++ 12)", time_limit=wish.time_limit)

    monkeypatch.setattr("grader.batch.settings.settled", settled)
    return wishes


def test_a_class_knows_its_grader_and_its_time_limit(
    pipeline: Pipeline, tmp_path: Path, now: list[Wish]
) -> None:
    """One version has many states, and the limit is in no result; both are in the store."""
    stored = in_a_class(tmp_path, CLASS, samples.perfect())
    own = json.loads(stored.read_text())["submission"]
    given = Submission(own["name"], own["path"], b"int x;", own["sha256"])
    pipeline.answer = lambda: replace(samples.perfect(), submission=given)
    ended = call("verify", str(stored))
    assert ended.output.splitlines() == [
        "settings, grader: 0.1.0 (1234, g++ 12) -> 0.1.0 (5678, g++ 12)",
        "points: the same, 50 of 50",
    ]
    assert ended.exit_code == 1
    assert pipeline.asked[0][1].time_limit == now[0].time_limit == 300
    ended = call("verify", str(stored), "--time-limit", "60")
    assert "settings, time limit: 300.0 -> 60.0" in ended.output
    assert pipeline.asked[1][1].time_limit == 60


def test_a_result_of_earlier_settings_is_not_compared_with_later_ones(
    pipeline: Pipeline, tmp_path: Path, now: list[Wish]
) -> None:
    """A regrade that ended early leaves such results."""
    stored = in_a_class(tmp_path, replace(CLASS, seed=7), samples.perfect())
    call("verify", str(stored))
    assert not now
    assert pipeline.asked[0][1].time_limit is None


def test_another_reason_for_refusing_is_told(pipeline: Pipeline, tmp_path: Path) -> None:
    """There is no file on both sides, which is no agreement."""
    stored = tmp_path / "result.json"
    stored.write_text(to_text(samples.rejected()))
    pipeline.answer = lambda: replace(
        samples.rejected(), submission=Rejected("s0428", "the file is empty")
    )
    ended = call("verify", str(stored), "src/exercise03.cpp")
    assert ended.exit_code == 1
    assert "two exercise03.cpp" in ended.output
    assert "-> no file (the file is empty)" in ended.output
    pipeline.answer = samples.rejected
    assert call("verify", str(stored), "src/exercise03.cpp").output == "reproduced: 0 of 50\n"


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
