"""Every input that fails a check opens, and shows at once what it is about."""

from pathlib import Path

import numpy as np
import pytest

from grader.cli.progress import silent
from grader.counterexample.written import to_text
from grader.errors import UsageError
from grader.model.counterexample import Counterexample
from grader.model.mesh import Mesh, Rays
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.options import Options
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers
from grader.oracle.meshes import mesh_named
from grader.run.transfer import ray_table
from grader.view.desk import Desk, Mode
from grader.view.panes import pixel_at
from grader.view.picture import shown
from grader.view.screenshot import wait
from grader.view.status import status
from grader.view.study import Study
from grader.view.subject import Subject, of_file, of_trial, told_of
from grader.view.walking import Followed, expected_of, is_wrong, outcome_of
from tests.verify.builder import build, soup
from tests.view import sources
from tests.view.shown import confetti, until

OPTIONS = Options(41, None, (), silent, isolated=False)
MESSAGE = "what the check said \x1b of it"
REMARK = "hits.closest-wins, when this was found: what the check said \\x1b of it"
MESH, OTHER = soup(30), soup(12, seed=5)


def aimed(mesh: Mesh) -> Rays:
    """Aim at the middles of some faces, from afar."""
    target = mesh.vertices[mesh.faces[:6]].mean(axis=1)
    origin = np.tile(np.array([[-6.0, 0.3, 0.2]], np.float32), (len(target), 1))
    count = len(target)
    return Rays(
        origin,
        (target - origin).astype(np.float32),
        np.zeros(count, np.float32),
        np.full(count, np.inf, np.float32),
    )


def middle() -> float:
    """Divide the rays into those that are lost and the others."""
    return float(np.median(aimed(MESH).direction[:, 1]))


def trials() -> list[Trial]:
    """Make one of each kind."""
    tree, rays = build(MESH), aimed(MESH)
    found = answers(MESH, rays, balanced_tree(MESH))
    others = answers(OTHER, rays, balanced_tree(OTHER))
    count = len(rays.t_min)
    none = np.zeros(count, np.bool_)
    families = ("aimed",), np.zeros(count, np.int64)
    return [
        ConstructTrial("construct", MESH),
        ConstructTrial("empty", soup(0)),
        ConstructTrial("tiny", mesh_named(41, "scaled-tiny")),
        ConstructTrial("huge", mesh_named(41, "scaled-huge")),
        RebuildTrial("rebuild", MESH, OTHER),
        TraceTrial("trace", MESH, tree, rays, found, *families, special=False),
        AlteredTrial("altered", MESH, tree, rays, found, none, "nothing"),
        WorkTrial("work", MESH, tree, rays, 1.0, 1.0),
        RepeatTrial("repeat", MESH, tree, OTHER, build(OTHER), rays, found, others),
        ImageTrial("image", MESH, tree, count, 1, rays, found, found.limit.astype(np.float32)),
    ]


def stored(trial: Trial, folder: Path) -> Subject:
    """Write a counterexample as the grader does, and open the file."""
    rays = 0 if isinstance(trial, ConstructTrial | RebuildTrial) else len(trial.rays.t_min)
    found = Counterexample("hits.closest-wins", trial, 30, rays, trial.name, MESSAGE, "", "")
    file = folder / "found.json"
    file.write_text(to_text(found))
    return of_file(file)


@pytest.fixture
def file(cache: Path, tmp_path: Path) -> Path:
    """Give a submission that loses half of the rays."""
    path = tmp_path / "exercise03.cpp"
    path.write_text(sources.tracing(f"if (ray.direction.y > {middle()}) {{ return {{}}; }}"))
    return path


def told_rightly(study: Study, judged: bool) -> None:
    """Hold what is said of a ray against which ones the submission loses."""
    lost = np.flatnonzero(aimed(MESH).direction[:, 1] > middle())
    assert study.walk is not None
    assert study.walk.came_back
    assert study.walk.title == f"ray {lost[0] if judged else 0}"
    assert is_wrong(study.walk) == judged
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
            assert study.walk.title == "ray 0"
            study.next_ray()
            until(lambda: not study.is_busy, lambda: desk.advance() | study.advance())
            judged = kind is not WorkTrial
            assert study.remark == ("no further ray is wrong" if judged else "")
            assert study.walk.title == ("ray 0" if judged else "ray 1")
        study.close()


def test_a_build_with_sanitizers_is_not_this_one() -> None:
    """So what was found there may not be seen here, and that is said."""
    trial = ConstructTrial("small", MESH, sanitized=True)
    told = told_of(
        of_trial("bvh.depth-is-limited", trial, "the deepest node is on level 9"), str
    )
    assert "level 9" in told
    assert "sanitizers" in told


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
        assert study.walk.title == "ray 0"
        assert outcome_of(study.walk, str) == "no answer"
        assert study.strokes()
        assert "when this was found" in study.remark
        file.write_text(sources.reference())
        until(
            lambda: study.walk is not None and study.walk.came_back,
            lambda: desk.advance() | study.advance(),
        )
        assert study.walk.title == "ray 0"
        assert not is_wrong(study.walk)
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
    table = ray_table(trial.rays)
    known = [expected_of(Followed(table[ray], "", trial, ray)) for ray in lost.tolist()]
    first = next(
        ray for ray, t in zip(lost.tolist(), known, strict=True) if t is not None and t < np.inf
    )
    with Desk(file, OPTIONS, lambda: of_trial("hits.closest-wins", trial)) as desk:
        study = Study(desk)
        wait(desk, study)
        assert study.walk is not None
        assert study.walk.title == f"ray {first}"
        assert study.walk.found == np.inf
        assert study.walk.expected == pytest.approx(1.0, abs=0.5)
        assert study.walk.sentence
        assert study.strokes()
        study.close()


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


def test_after_a_save_one_looks_at_the_same(file: Path) -> None:
    """The same node and the same ray, whatever was compiled in between."""
    with Desk(file, OPTIONS, confetti) as desk:
        study = Study(desk)
        desk.resize(24, 24)
        wait(desk, study)
        study.select(0)
        study.follow((12, 11))
        until(lambda: study.walk is not None, lambda: desk.advance() | study.advance())
        assert study.walk is not None
        old, ray = desk.stage, study.walk.ray
        file.write_text(sources.reference())
        until(
            lambda: desk.stage is not old and study.walk is not None and not study.is_busy,
            lambda: desk.advance() | study.advance(),
        )
        assert study.walk.title == "pixel (12, 11)"
        assert (study.walk.ray == ray).all()
        assert study.pixel == (12, 11)
        assert study.facts is not None
        desk.choose(lambda: confetti(30))
        until(lambda: desk.subjects == 2, lambda: desk.advance() | study.advance())
        study.advance()
        assert not any((study.walk, study.facts))
        assert study.pixel == (-1, -1)
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
        assert is_wrong(study.walk)
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
            assert not is_wrong(study.walk)
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


def test_a_file_of_another_kind_is_refused(tmp_path: Path) -> None:
    """With a sentence that says what was expected."""
    other = tmp_path / "notes.txt"
    other.write_text("nothing")
    with pytest.raises(UsageError, match="was expected"):
        of_file(other)
