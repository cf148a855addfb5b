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
from grader.view.desk import Desk
from grader.view.panes import pixel_at
from grader.view.screenshot import wait
from grader.view.study import Study
from grader.view.subject import Subject, of_file, of_trial
from grader.view.walking import expected_of
from tests.verify.builder import build, soup
from tests.view import sources
from tests.view.shown import confetti, until

OPTIONS = Options(41, None, (), silent, isolated=False)
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
    found = Counterexample("hits.closest-wins", trial, 30, rays, trial.name, "", "", "")
    file = folder / "found.json"
    file.write_text(to_text(found))
    return of_file(file)


@pytest.fixture
def file(cache: Path, tmp_path: Path) -> Path:
    """Give a submission that loses half of the rays."""
    path = tmp_path / "exercise03.cpp"
    path.write_text(sources.tracing(f"if (ray.direction.y > {middle()}) {{ return {{}}; }}"))
    return path


@pytest.mark.parametrize("trial", trials(), ids=lambda one: one.name)
def test_every_kind_opens_from_its_file(trial: Trial, file: Path, tmp_path: Path) -> None:
    """What is stored is shown: a mesh, a tree, and a ray if there is one."""
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
        if subject.rays is not None:
            assert study.walk is not None
        elif len(subject.mesh.faces):
            assert study.facts is not None
            assert study.facts.node == 0
            assert study.facts.faults
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
    first = next(ray for ray in lost.tolist() if expected_of(trial, ray) < np.inf)
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
        file.write_text("oops")
        until(lambda: desk.product is not None and desk.product.engine is None, desk.advance)
        assert desk.product is not None
        assert desk.product.diagnostics
        file.write_text(sources.reference())
        until(
            lambda: desk.product is not None and desk.product.engine is not None, desk.advance
        )
        until(lambda: desk.stage is not None and desk.stage.traced.is_done, desk.advance)
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
