"""Every input that fails a check opens, and shows at once what it is about."""

from pathlib import Path

import numpy as np
import pytest

from grader.errors import UsageError
from grader.language import translator
from grader.model.trials import (
    ConstructTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.phrases import teller
from grader.view.desk import Desk
from grader.view.panes import pixel_at
from grader.view.screenshot import wait
from grader.view.study import Study
from grader.view.subject import of_file, of_trial, told_of
from grader.view.walking import outcome_of
from tests.view import sources
from tests.view.found import MESH, MESSAGE, OPTIONS, REMARK, aimed, middle, stored, trials
from tests.view.shown import confetti, until


def told_rightly(study: Study, judged: bool) -> None:
    """Hold what is said of a ray against which ones the submission loses."""
    lost = np.flatnonzero(aimed(MESH).direction[:, 1] > middle())
    assert study.walk is not None
    assert study.walk.came_back
    assert study.walk.of.title == f"ray {lost[0] if judged else 0}"
    assert study.walk.wrong is (True if judged else None)
    assert (study.walk.expected is not None) == judged


@pytest.mark.parametrize("trial", trials(), ids=lambda one: one.name)
def test_every_kind_opens_from_its_file(trial: Trial, file: Path, tmp_path: Path) -> None:
    """What is stored is shown: a mesh, a tree, a ray if there is one, and the check's words.

    Nothing else is said to be right or wrong that is not seen to be so.
    """
    if isinstance(trial, ConstructTrial) and not len(trial.mesh.faces):
        subject = of_trial("bvh.survives-every-mesh", trial)
    else:
        subject = stored(trial, tmp_path)
    with Desk(file, OPTIONS, lambda: subject) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        wait(desk, study)
        assert desk.stage is not None
        assert desk.stage.tree is not None
        assert not desk.stage.trouble
        assert study.remark == (REMARK if subject.told else "")
        assert not study.is_busy
        if subject.rays is not None:
            told_rightly(study, judged=not isinstance(trial, WorkTrial))
        elif len(subject.mesh.faces):
            assert study.facts is not None
            assert study.facts.node == 0
            assert "faces, but it is not split" in study.facts.faults[-1]
        study.close()


@pytest.mark.parametrize("kind", [TraceTrial, WorkTrial, RepeatTrial, ConstructTrial])
def test_where_nothing_is_wrong_any_more_that_is_not_taken_for_news(
    kind: type, file: Path, tmp_path: Path
) -> None:
    """The first ray or the root is shown with the check's words; who asks is told the rest."""
    file.write_text(sources.reference())
    subject = stored(next(one for one in trials() if isinstance(one, kind)), tmp_path)
    with Desk(file, OPTIONS, lambda: subject) as desk:
        study = Study(desk)
        desk.resize(8, 8)
        wait(desk, study)
        assert study.remark == REMARK
        if subject.rays is None:
            assert study.facts is not None
            assert study.facts.node == 0
            study.next_node()
            assert study.remark == "no node is wrong"
        else:
            assert study.walk is not None
            assert study.walk.of.title == "ray 0"
            study.next_ray()
            until(lambda: not study.is_busy, lambda: desk.advance() | study.advance())
            judged = kind is not WorkTrial
            assert study.remark == ("no further ray is wrong" if judged else "")
            assert study.walk.of.title == ("ray 0" if judged else "ray 1")
        study.close()


def test_a_build_with_sanitizers_is_not_this_one() -> None:
    """So what was found there may not be seen here, and that is said."""
    trial = ConstructTrial("small", MESH, sanitized=True)
    told = told_of(
        of_trial("bvh.depth-is-limited", trial, "the deepest node is on level 9"), str
    )
    assert "level 9" in told
    assert "sanitizers" in told
    subject = of_trial("bvh.depth-is-limited", trial, "pixel (3, 4): no hit, but a is closer")
    german = told_of(subject, translator("de"), teller("de"))
    assert "Pixel (3, 4): kein Treffer, aber a ist näher" in german


def test_a_ray_that_ends_the_process_is_named_and_drawn(file: Path) -> None:
    """Not a pixel, and without steps; the next build follows the same ray."""
    trial = next(one for one in trials() if isinstance(one, TraceTrial))
    file.write_text(sources.tracing(f"if (ray.origin.x == -6.0f) {{ {sources.CRASH} }}"))
    subject = of_trial("hits.survives-every-ray", trial, MESSAGE)
    with Desk(file, OPTIONS, lambda: subject) as desk:
        study = Study(desk)
        wait(desk, study)
        assert desk.stage is not None
        assert desk.stage.trouble.startswith("intersect, ray 0: ")
        assert study.walk is not None
        assert study.walk.of.title == "ray 0"
        assert outcome_of(study.walk, str) == "no answer"
        assert study.strokes()
        assert "when this was found" in study.remark
        file.write_text(sources.reference())
        until(
            lambda: study.walk is not None and study.walk.came_back,
            lambda: desk.advance() | study.advance(),
        )
        assert study.walk.of.title == "ray 0"
        assert study.walk.wrong is False
        study.close()


def test_a_pane_may_have_more_pixels_than_are_traced(file: Path) -> None:
    """The desk has fewer, and the mouse is over one of them; smaller ones have their own."""
    with Desk(file, OPTIONS, confetti) as desk:
        desk.resize(4000, 2000)
        assert desk.size == (1448, 724)
        assert pixel_at((3000.0, 1994.5), (4000, 2000), desk.size) == (1086, 722)
        assert pixel_at((3000.0, 1994.5), (4000, 2000), (4000, 2000)) == (3000, 1994)
        desk.resize(24, 20)
        assert desk.size == (24, 20)


def test_the_first_wrong_ray_is_followed(file: Path, tmp_path: Path) -> None:
    """Rays that are right are passed over; what was lost, and where, is told."""
    trial = next(one for one in trials() if isinstance(one, TraceTrial))
    lost = np.flatnonzero(trial.rays.direction[:, 1] > middle())
    first = next(ray for ray in lost.tolist() if np.isfinite(trial.answers.limit[ray]))
    with Desk(file, OPTIONS, lambda: of_trial("hits.closest-wins", trial)) as desk:
        study = Study(desk)
        wait(desk, study)
        assert study.walk is not None
        assert study.walk.of.title == f"ray {first}"
        assert study.walk.found == np.inf
        assert study.walk.expected == pytest.approx(1.0, abs=0.5)
        assert study.walk.sentence
        assert study.strokes()
        study.close()


def test_a_file_of_another_kind_is_refused(tmp_path: Path) -> None:
    """With a sentence that says what was expected."""
    other = tmp_path / "notes.txt"
    other.write_text("nothing")
    with pytest.raises(UsageError, match="was expected"):
        of_file(other)
