"""A course's own scenes are graded: a rubric names their folder, and mistakes in them cost."""

from fractions import Fraction
from pathlib import Path

import pytest

from grader.certify.corpus import corpus_folder
from grader.errors import UsageError
from grader.model.grade import CheckScore, Grade
from grader.model.verdict import Verdict
from grader.options import Options
from grader.oracle.album import render_scenes
from grader.oracle.scenes import scenes, scenes_sha256
from grader.oracle.variant import Variant
from grader.pipeline import grade_one
from grader.resources import reference_source
from grader.score.rubric import SHIPPED
from tests.oracle.own import own_folder

IMAGE = "image.equals-mitsuba"
OURS = {"our-few", "our-made"}


@pytest.fixture
def rubric(tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write the shipped rubric with a folder of two own scenes, of which one is hidden."""
    assert cache.is_dir()
    scalar = Variant("scalar_rgb", None, "always works")
    monkeypatch.setattr("grader.oracle.variant.working_variant", lambda: scalar)
    render_scenes((), lambda _: None, own_folder(tmp_path))
    path = tmp_path / "rubric.toml"
    path.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    return path


def graded(path: Path, rubric: Path, for_student: bool = False) -> Grade:
    """Grade pictures only."""
    options = Options(41, rubric, (IMAGE,), lambda *_: None, for_student=for_student)
    return grade_one(path, options)


def of_pictures(grade: Grade) -> CheckScore:
    """Return what the check of pictures says."""
    return next(score for score in grade.checks if score.check == IMAGE)


def test_own_scenes_are_graded_beside_the_others(rubric: Path) -> None:
    """The reference passes in all of them, and the result says which scenes they were."""
    grade = graded(reference_source(), rubric)
    score = of_pictures(grade)
    assert {case for case, _ in score.cases} == {scene.name for scene in scenes()} | OURS
    assert score.score == 3
    assert grade.provenance.scenes_sha256 == scenes_sha256(rubric.parent / "ours")
    assert grade.provenance.scenes_sha256 != scenes_sha256()


def test_scenes_count_by_their_weight(rubric: Path) -> None:
    """Every 997th ray is lost, of which small pictures have none; one counts 2.5 times."""
    score = of_pictures(
        graded(corpus_folder() / "wrong" / "every-997th-ray-is-lost.cpp", rubric)
    )
    passed = {case for case, verdict in score.cases if verdict is Verdict.PASS}
    assert passed == OURS
    whole = len(score.cases) - 1 + Fraction(5, 2)
    assert score.score == int(3 * 4 * Fraction(7, 2) / whole) / 4 == 0.75


def test_a_student_does_not_run_a_hidden_scene(rubric: Path) -> None:
    """It is not there, neither as a case nor as a word."""
    grade = graded(reference_source(), rubric, for_student=True)
    names = {case for score in grade.checks for case, _ in score.cases}
    assert names & OURS == {"our-made"}
    assert of_pictures(grade).score == 3


def test_a_wrong_line_is_the_callers_mistake(rubric: Path) -> None:
    """It is told before anybody gets a grade."""
    toml = rubric.parent / "ours" / "scenes.toml"
    toml.write_text(toml.read_text().replace("fov = 30", "fov = 300"))
    with pytest.raises(UsageError, match=r"scenes\.toml: .* fov is 300"):
        graded(reference_source(), rubric)
