"""What one looks at stays the same after a save, and wrong rays are found by themselves."""

from pathlib import Path

import pytest

from grader.model.trials import ConstructTrial, TraceTrial
from grader.view.desk import Desk, Mode
from grader.view.picture import next_wrong, shown
from grader.view.screenshot import wait
from grader.view.status import status
from grader.view.study import Study
from grader.view.subject import Subject, of_trial
from tests.view import sources
from tests.view.found import MESH, OPTIONS, trials
from tests.view.shown import confetti, until


def test_the_submission_is_built_anew_when_it_is_saved(file: Path) -> None:
    """One save makes one new build, also after a file that does not compile."""
    with Desk(file, OPTIONS, lambda: of_trial("x", trials()[3])) as desk:
        study = Study(desk)
        wait(desk, study)
        before = desk.stage
        file.write_text("oops")
        until(lambda: desk.product is not None and desk.product.engine is None, desk.advance)
        assert desk.product is not None
        assert desk.product.diagnostics
        assert desk.stage is before
        assert desk.stage is not None
        assert desk.stage.tree is not None
        assert "the last build that did" in status(desk, str)
        file.write_text(sources.reference())
        until(
            lambda: desk.product is not None and desk.product.engine is not None, desk.advance
        )
        until(lambda: desk.stage is not None and desk.stage.traced.is_done, desk.advance)
        study.close()


def test_the_model_solution_rests_while_nobody_compares(file: Path) -> None:
    """It is shown no view that nobody wants to see, and the present one when it is wanted."""
    file.write_text(sources.reference())
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        desk.compare(Mode.DIFFERENCE)
        until(lambda: desk.rival is not None and desk.rival.traced.is_done, desk.advance)
        rival, before = desk.rival, desk.orbit
        assert rival is not None
        assert before is not None
        desk.compare(Mode.SHADED)
        desk.look(before.turned(0.3, 0))
        wait(desk, study)
        assert rival.traced.orbit == before
        assert rival.traced.is_done
        for mode in (Mode.REFERENCE, Mode.DIFFERENCE):
            desk.compare(mode)
            wait(desk, study)
            assert desk.rival is rival
            assert rival.traced.orbit == desk.orbit
        study.close()


def test_after_a_save_one_looks_at_the_same(file: Path) -> None:
    """The same node and the same ray, whatever was compiled in between."""
    file.write_text(sources.reference())
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        wait(desk, study)
        study.select(2)
        study.follow((12, 11))
        until(lambda: study.walk is not None, lambda: desk.advance() | study.advance())
        assert study.walk is not None
        old, ray = desk.stage, study.walk.ray
        file.write_text(f"{sources.reference()}// saved again\n")
        until(
            lambda: desk.stage is not old and study.walk is not None and not study.is_busy,
            lambda: desk.advance() | study.advance(),
        )
        assert study.walk.of.title == "pixel (12, 11)"
        assert (study.walk.ray == ray).all()
        assert study.pixel == (12, 11)
        assert study.facts is not None
        assert study.facts.node == 2
        desk.choose(lambda: confetti(30))
        until(lambda: desk.subjects == 2, lambda: desk.advance() | study.advance())
        study.advance()
        assert not any((study.walk, study.facts))
        assert study.pixel == (-1, -1)
        study.close()


def test_a_ray_on_the_way_to_a_wrong_one_is_not_looked_at(file: Path) -> None:
    """After a restart it is the ray that was shown, not the one that was just asked for."""
    trial = next(one for one in trials() if isinstance(one, TraceTrial))
    with Desk(file, OPTIONS, lambda: of_trial("hits.closest-wins", trial)) as desk:
        study = Study(desk)
        wait(desk, study)
        assert study.walk is not None
        title = study.walk.of.title
        study.next_ray()
        desk.run_again()
        until(
            lambda: study.walk is not None and not study.is_busy,
            lambda: desk.advance() | study.advance(),
        )
        assert study.walk is not None
        assert study.walk.of.title == title
        study.next_ray()
        until(lambda: not study.is_busy, lambda: desk.advance() | study.advance())
        assert study.walk.of.title != title
        study.close()


def test_the_picture_before_a_move_names_no_pixel(file: Path) -> None:
    """It was seen from elsewhere; what differs there says nothing of what is seen now."""
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        desk.compare(Mode.DIFFERENCE)
        wait(desk, study)
        assert next_wrong(desk, (-1, -1)) is not None
        assert desk.orbit is not None
        desk.orbit = desk.orbit.turned(0.1, 0.0)
        assert next_wrong(desk, (-1, -1)) is None
        study.close()


def test_the_next_failing_ray_comes_by_itself(file: Path) -> None:
    """Also if nothing was compared before; it is told where the model solution hits."""
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        wait(desk, study)
        study.next_ray()
        assert "looking" in study.remark
        until(lambda: not study.is_busy, lambda: desk.advance() | study.advance())
        assert desk.mode is Mode.DIFFERENCE
        assert not study.remark
        assert study.walk is not None
        assert study.walk.expected is not None
        assert study.walk.wrong
        study.close()


@pytest.mark.parametrize("turns", [False, True], ids=["right", "turned"])
def test_wrong_normals_differ(file: Path, turns: bool) -> None:
    """A picture of right distances is right only if its shades are, too."""
    source = sources.given()
    if turns:
        source = source.replace(
            sources.END, f"    closest.normal = {{1, 0, 0}};\n{sources.END}"
        )
    file.write_text(source)
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        wait(desk, study)
        study.next_ray()
        until(lambda: not study.is_busy, lambda: desk.advance() | study.advance())
        if turns:
            assert study.walk is not None
            assert study.walk.wrong is False
            assert "normal" in study.walk.sentence
        else:
            assert study.remark == "no pixel differs"
        wait(desk, study)
        seen = shown(desk)
        assert seen is not None
        assert (seen.wrong > 0) == turns
        study.close()


def test_where_construct_crashes_ours_takes_its_place(file: Path) -> None:
    """The rays are traced all the same, and what happened is still told."""
    file.write_text(sources.CRASHES_IN_CONSTRUCT)
    mesh = of_trial("x", ConstructTrial("x", MESH))
    scene = Subject("few", "few", mesh.mesh, mesh.home)
    with Desk(file, OPTIONS, lambda: scene) as desk:
        wait(desk, Study(desk))
        assert desk.stage is not None
        assert desk.stage.trouble.startswith("construct: ")
        assert desk.stage.tree is not None
        assert desk.stage.traced.is_done
