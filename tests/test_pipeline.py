"""One path becomes one grade: the same one every time, and never a traceback."""

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from grader import pipeline
from grader.build.compile import compile_submission
from grader.build.compiling import Compilation
from grader.certify.corpus import corpus_folder
from grader.errors import UsageError
from grader.model.grade import Grade, Limits
from grader.model.stages import Build, Stop, Submission
from grader.model.verdict import Verdict
from grader.options import Options
from grader.oracle.plan import deeper_trials, make_plan
from grader.pipeline import engines_for, grade_one, grade_with
from grader.report.as_json import schema_text, to_json
from grader.resources import reference_source, stub_folder
from grader.rounds import budget_of
from grader.run.trials import Budget, Engines
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.selftest import proved_isolation
from grader.score.rubric import SHIPPED
from grader.selection import select
from grader.solution import Solution
from grader.verify import every_check
from grader.verify.planned import planned_cases
from tests.verify.trials import construct, trace

LEVELS = {"B": "landlock+seccomp", "none": "none"}


def graded(
    path: Path, *only: str, rubric: Path | None = None, for_student: bool = False
) -> Grade:
    """Grade a path with the default seed."""
    options = Options(41, rubric, only, lambda *_: None, for_student=for_student)
    return grade_one(path, options)


@cache
def reference() -> Grade:
    """Grade the reference once for all tests of this file."""
    return graded(reference_source())


def comparable(grade: Grade) -> dict[str, Any]:
    """Leave out of a result what the contract lets differ between two runs."""
    result = to_json(grade)
    del result["timing"]
    del result["provenance"]["cpu"]
    return result


def test_the_reference_earns_everything() -> None:
    """50 of 50, nothing withheld, and the result says how it was isolated."""
    grade = reference()
    assert [part.score for part in grade.parts] == [25, 25]
    assert grade.score == grade.max_score == 50
    assert not grade.needs_review
    assert grade.provenance.isolation == "bubblewrap+landlock+seccomp"


def test_two_runs_give_the_same_result(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only timing and the processor's name may differ; and the result fits the schema.

    The second run is one with two seeds: each has a grade of its own, from one build.
    """
    builds: list[Build] = []

    def counted(submission: Submission, order: Compilation) -> Build:
        builds.append(compile_submission(submission, order))
        return builds[-1]

    monkeypatch.setattr(pipeline, "compile_submission", counted)
    options = Options(0, None, (), lambda *_: None)
    again, other = grade_with(reference_source(), options, (41, 42))
    assert len(builds) == 1
    assert comparable(again) == comparable(reference())
    assert (other.score, other.provenance.seed) == (50, 42)
    jsonschema.validate(to_json(reference()), json.loads(schema_text()))


@pytest.mark.parametrize("level", ["B", "none"])
def test_an_honest_submission_scores_the_same_at_every_level(
    monkeypatch: pytest.MonkeyPatch, level: str
) -> None:
    """Nothing but the name of the level differs."""
    monkeypatch.setenv("BVHGRADE_ISOLATION", level.replace("none", ""))
    proved_isolation.cache_clear()
    options = Options(41, None, (), lambda *_: None, isolated=level != "none")
    try:
        grade = grade_one(reference_source(), options)
    finally:
        proved_isolation.cache_clear()
    result, other = comparable(reference()), comparable(grade)
    assert other["provenance"].pop("isolation") == LEVELS[level]
    result["provenance"].pop("isolation")
    assert other == result


SLEEPS = """#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <unistd.h>
void BVH::construct(const Mesh&) { for (;;) ::sleep(1000); }
Intersection intersect(const Mesh&, const IntersectionRay&) { for (;;) ::sleep(1000); }
"""


def test_a_submission_that_takes_all_of_the_time_still_gets_a_grade(tmp_path: Path) -> None:
    """What did not run any more is named, costs its own points, and nothing is withheld."""
    path = tmp_path / "sleeps.cpp"
    path.write_text(SLEEPS)
    # Else most of the time goes to the plan, which is nobody's fault.
    Solution().plan(41)
    grade = grade_one(path, Options(41, None, (), lambda *_: None, time_limit=24.0))
    survival = {one.check: one for one in grade.checks if ".survives-" in one.check}
    assert {one.verdict for one in survival.values()} == {Verdict.FAIL}
    assert {one.stop for one in survival.values()} == {Stop.TIMED_OUT}
    said = " ".join(example.message for one in survival.values() for example in one.examples)
    assert "the time for the whole submission was used up" in said
    assert (grade.score, grade.needs_review) == (0, False)
    jsonschema.validate(to_json(grade), json.loads(schema_text()))


def test_what_compiling_took_is_known_where_time_is_blamed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The submission's own seconds, of every compiler, and not the wall time."""
    told: list[tuple[float, float]] = []

    def noted(limits: Limits, options: Options, elapsed: float, compiling: float) -> Budget:
        told.append((elapsed, compiling))
        return budget_of(limits, options, elapsed, compiling)

    monkeypatch.setattr(pipeline, "budget_of", noted)
    monkeypatch.setattr("grader.build.compiling.recalled", lambda _: None)
    graded(reference_source(), "bvh.is-readable")
    ((elapsed, compiling),) = told
    assert 0.0 < compiling < 2 * elapsed


def test_the_reference_is_examined_in_every_planned_case() -> None:
    """What the plan promises is what a right submission gives each check to look at."""
    # The reference's own trees reach level 20, so it has to cope with such trees.
    trials = [*make_plan(41, Solution().trees).trials, *deeper_trials(41)]
    planned = planned_cases(every_check(), trials)
    seen = {score.check: len(score.cases) for score in reference().checks}
    assert seen == planned
    assert all(score.examined > 0 for score in reference().checks)


def test_every_need_and_every_criterion_is_a_check() -> None:
    """A misspelt id would silently take a guard away."""
    checks = every_check()
    ids = {each.id for each in checks}
    assert len(ids) == len(checks)
    assert {need for each in checks for need in each.needs} <= ids
    assert {one.check for one in select(None, ()).rubric.criteria} == ids


def test_the_starter_scores_nothing_and_is_not_blamed() -> None:
    """Both parts are not started; no check fails but the one that shows it."""
    grade = graded(stub_folder() / "src" / "exercise03.cpp")
    assert grade.score == 0
    assert [part.started for part in grade.parts] == [False, False]
    assert all(score.verdict is not Verdict.BROKEN for score in grade.checks)


def test_a_file_that_does_not_compile_blocks_the_rest() -> None:
    """build.compiles fails with the student's line; everything else waits for it."""
    grade = graded(corpus_folder() / "wrong" / "missing-semicolon.cpp")
    (first, *rest) = grade.checks
    assert (first.check, first.verdict) == ("build.compiles", Verdict.FAIL)
    assert first.message.startswith("1 of 1 wrong, first in `build`: line ")
    assert {score.verdict for score in rest} == {Verdict.BLOCKED}
    assert (grade.score, grade.needs_review) == (0, False)


@pytest.mark.parametrize("name", ["nothing.cpp", "utf16.cpp"])
def test_what_is_no_source_is_rejected(tmp_path: Path, name: str) -> None:
    """An empty file and UTF-16 earn 0 points and a sentence, not a traceback."""
    content = b"" if name == "nothing.cpp" else "int x;".encode("utf-16")
    (tmp_path / name).write_bytes(content)
    grade = graded(tmp_path / name)
    assert (grade.score, grade.build, grade.needs_review) == (0, None, False)
    jsonschema.validate(to_json(grade), json.loads(schema_text()))


def test_only_the_asked_checks_are_scored() -> None:
    """`--only` leaves the other criteria out, and runs what the asked one needs."""
    grade = graded(reference_source(), "bvh.boxes-are-tight")
    scored = {score.check: score.verdict for score in grade.checks if score.max_score}
    assert scored == {"bvh.boxes-are-tight": Verdict.PASS}
    assert grade.max_score == 4
    assert grade.build
    # Trees at the depth limit come from the build with the small one.
    assert (grade.build.sanitized is not None, grade.build.deep) == (True, None)
    assert grade.build.calls, "reports name the lines of functions"


LEVEL_20 = (2 << 20) - 1
"""Nodes of a tree of that level."""


def test_a_check_alone_is_asked_on_deep_trees_too(tmp_path: Path) -> None:
    """The trees of part a tell that they reach level 20, though no check looks at them."""
    head = "Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {\n"
    dies = f"if (mesh.getBVH().getNodes().size() == {LEVEL_20}) __builtin_trap();\n"
    source = reference_source().read_text()
    assert head in source
    path = tmp_path / "exercise03.cpp"
    path.write_text(source.replace(head, head + dies))
    grade = graded(path, "hits.survives-every-ray")
    verdicts = {score.check: score.verdict for score in grade.checks if score.max_score}
    assert verdicts == {"hits.survives-every-ray": Verdict.FAIL}
    assert grade.build
    assert (grade.build.sanitized is not None, grade.build.deep) == (True, None)


@pytest.mark.parametrize(
    ("sanitized", "part", "made"),
    [(False, "a", None), (True, "a", "sanitized"), (False, "b", None), (True, "b", "deep")],
)
def test_one_trial_needs_one_build(
    tmp_path: Path, sanitized: bool, part: str, made: str | None
) -> None:
    """What shows a counterexample again compiles nothing else."""
    trial = construct(9, sanitized) if part == "a" else trace(False, sanitized)
    options = Options(41, None, (), lambda *_: None)
    with scratch_folder() as folder, Nursery() as nursery:
        engines = engines_for(reference_source(), folder, nursery, options, trial)
    assert isinstance(engines, Engines)
    further = {"sanitized": engines.sanitized, "deep": engines.deep}
    assert [name for name, engine in further.items() if engine] == ([made] if made else [])
    assert engines.of(trial)


def test_an_unknown_check_names_its_neighbours() -> None:
    """The sentence says what was asked and what there is instead."""
    with pytest.raises(UsageError, match=r"bvh\.boxes-are-tite.*bvh\.boxes-are-tight"):
        graded(reference_source(), "bvh.boxes-are-tite")


def test_the_reading_full_levels_accepts_leaves_of_nine(tmp_path: Path) -> None:
    """A tree that stops at the last full level is right under the other reading only."""
    rubric = tmp_path / "rubric.toml"
    shipped = Path(__file__).parents[1] / "grader" / "score" / "rubric.toml"
    text = shipped.read_text()
    assert 'leaf_rule = "sheet"' in text
    rubric.write_text(text.replace('leaf_rule = "sheet"', 'leaf_rule = "full-levels"'))
    grade = graded(corpus_folder() / "wrong" / "stops-at-last-full-level.cpp", rubric=rubric)
    assert grade.parts[0].score == 25, [one for one in grade.checks if one.message]


def test_a_hidden_check_leaves_no_trace_in_a_student_s_result(tmp_path: Path) -> None:
    """Two submissions that only a hidden check tells apart come to the same result."""
    check = 'check = "bvh.boxes-are-tight"\n'
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(SHIPPED.read_text().replace(check, f'{check}visibility = "hidden"\n'))
    only = ("bvh.leaves-hold-at-most-four", "bvh.depth-is-limited")
    results = []
    for path in (
        corpus_folder() / "wrong" / "leaves-without-boxes.cpp",
        reference_source(),
    ):
        result = comparable(graded(path, *only, rubric=rubric, for_student=True))
        del result["submission"]
        results.append(result)
    assert results[0] == results[1]
    assert results[0]["score"] == results[0]["max_score"]
    text = json.dumps(results[0])
    assert text.count("bvh.boxes-are-tight") == 1, "only the note says that it was not run"
