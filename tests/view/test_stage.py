"""Whatever a submission does, the stage stays and says what happened."""

import re
from itertools import count
from typing import Any

import numpy as np
import pytest

from grader.model.mesh import Mesh
from grader.oracle.meshes import mesh_named
from grader.run.session import Engine
from grader.view import stage as stage_module
from grader.view import traced as traced_module
from grader.view.camera import rays_of
from grader.view.levels import levels_of
from grader.view.shades import differing, is_hit
from grader.view.stage import MOST_PIXELS, MOST_RAYS, State, fitting
from grader.view.subject import Subject
from tests.verify.builder import build
from tests.view import sources
from tests.view.conftest import Compiled, Staged
from tests.view.shown import confetti, finished, of_mesh, until

SIDE = 48


def test_a_picture_is_traced_from_coarse_to_fine(right: Engine, staged: Staged) -> None:
    """Every pixel has its own ray in the end; the tree is there, and costs are counted."""
    subject = confetti()
    stage = staged(subject, right)
    stage.show(subject.home, SIDE, SIDE)
    seen: list[int] = []

    def look() -> None:
        stage.advance()
        seen.append(stage.traced.block)

    until(lambda: stage.traced.is_done, look)
    traced = stage.traced
    assert seen == sorted(seen, reverse=True)
    assert traced.seen.all()
    assert traced.fine.all()
    assert is_hit(traced.t).any()
    assert traced.tests[is_hit(traced.t)].min() > 0
    assert traced.box_tests > 0
    assert stage.tree is not None
    assert (stage.tree.end == build(subject.mesh).end[: len(stage.tree.end)]).all()


@pytest.mark.parametrize("size", [(1, 1), (17, 3), (33, 65)])
def test_every_pixel_is_painted(right: Engine, staged: Staged, size: tuple[int, int]) -> None:
    """Also where a picture ends within a block."""
    subject = confetti()
    stage = staged(subject, right)
    stage.show(subject.home, *size)
    finished(stage)
    assert stage.traced.t.shape == (size[1], size[0])
    assert stage.traced.fine.all()
    assert levels_of(*size)[-1].rows == size[1]


@pytest.mark.parametrize(
    "size", [(2160, 3840), (1100, 1100), (30_000, 40), (1024, 1024), (9, 3)]
)
def test_a_size_is_shrunk_to_what_there_is_room_for(size: tuple[int, int]) -> None:
    """All levels fit, the shape stays, and what fits is left alone."""
    width, height = fitting(*size)
    assert levels_of(width, height)[-1].past <= MOST_RAYS
    assert abs(width / height / (size[0] / size[1]) - 1) < 0.03
    assert ((width, height) == size) == (size[0] * size[1] <= MOST_PIXELS)


def test_a_picture_that_is_too_large_is_traced_in_fewer_pixels(
    right: Engine, staged: Staged, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its rays never leave the memory that was set aside for them."""
    monkeypatch.setattr(stage_module, "MOST_PIXELS", 256)
    monkeypatch.setattr(stage_module, "MOST_RAYS", 288)
    subject = confetti()
    stage = staged(subject, right)
    stage.show(subject.home, 64, 16)
    finished(stage)
    assert stage.traced.t.shape == (8, 32)
    assert stage.traced.fine.all()


def test_another_view_takes_the_place_of_the_first(right: Engine, staged: Staged) -> None:
    """The picture is the one of the last camera, as if there had been no other."""
    subject = confetti()
    stage, fresh = staged(subject, right), staged(subject, right)
    for turn in range(5):
        stage.show(subject.home.turned(0.1 * turn, 0), SIDE, SIDE)
        stage.advance()
    last = subject.home.turned(0.4, 0)
    fresh.show(last, SIDE, SIDE)
    finished(stage)
    finished(fresh)
    assert stage.traced.orbit == last
    assert not differing(stage.traced.t, fresh.traced.t).any()


@pytest.mark.parametrize(
    ("source", "told"),
    [
        (sources.CRASHES_AT_THE_RIGHT, "SIGSEGV"),
        (sources.LEAVES, "ended itself"),
    ],
    ids=["crash", "exit"],
)
def test_the_end_of_a_process_names_its_pixel(
    compiled: Compiled, staged: Staged, source: str, told: str
) -> None:
    """The pixel that is named is one whose ray ends the process; those before are kept."""
    subject = confetti()
    stage = staged(subject, compiled(source))
    stage.show(subject.home, SIDE, SIDE)
    finished(stage)
    assert stage.state is State.ENDED
    assert told in stage.trouble
    named = re.match(r"intersect, pixel \((\d+), (\d+)\): ", stage.trouble)
    assert named is not None
    column, row = map(int, named.groups())
    assert fatal(subject, row * SIDE + column).all()
    # Of the coarsest blocks those before it are painted; the third ray is the first fatal one.
    seen = stage.traced.seen
    assert seen[8, [8, 24]].all()
    assert not seen[8, 40]
    assert not stage.advance()


def fatal(subject: Subject, pixels: Any) -> np.ndarray:  # noqa: ANN401 - one or several
    """Tell of pixels whether their rays are those that end the process."""
    rays = rays_of(subject.home, SIDE, SIDE, np.atleast_1d(pixels))
    return np.asarray(rays[:, 3] > np.float32(sources.BORDER))


def steep() -> np.ndarray:
    """Make a ray that no picture has."""
    return np.array([0, 0, -9, 0, 7, 0, 0, np.inf], np.float32)


@pytest.mark.parametrize("first", ["picture", "ray"])
def test_the_end_in_a_ray_that_is_followed_names_it(
    compiled: Compiled, staged: Staged, first: str
) -> None:
    """No pixel is blamed, whether the picture is done or still to come."""
    subject = confetti()
    stage = staged(subject, compiled(sources.CRASHES_AT_STEEP_RAYS))
    if first == "picture":
        stage.show(subject.home, SIDE, SIDE)
        finished(stage)
        assert stage.state is State.TRACING
    until(lambda: stage.state is State.TRACING, stage.advance)
    stage.record(rays_of(subject.home, SIDE, SIDE, np.array([3]))[0], "harmless")
    stage.record(steep(), "ray 7")
    stage.record(steep(), "too late")
    until(lambda: stage.state is State.ENDED, stage.advance)
    assert stage.trouble.startswith("intersect, ray 7: ")
    assert "SIGSEGV" in stage.trouble


def test_a_hang_in_a_ray_that_is_followed_names_it(
    compiled: Compiled, staged: Staged, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is stopped like any other."""
    monkeypatch.setattr(traced_module, "PATIENCE", 0.5)
    subject = confetti()
    stage = staged(subject, compiled(sources.HANGS_AT_STEEP_RAYS))
    until(lambda: stage.state is State.TRACING, stage.advance)
    stage.record(steep(), "ray 7")
    until(lambda: stage.state is State.ENDED, stage.advance)
    assert stage.trouble == "intersect, ray 7: did not come back and was stopped"


def test_a_counter_that_flips_ends_nothing(
    right: Engine, staged: Staged, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever changes how far it says it is gets another picture, and no exception."""
    subject = confetti()
    stage = staged(subject, right)
    assert stage.traced.now() == (0, 0)
    counted, asked = stage.live.result.number, count()
    monkeypatch.setattr(
        stage.live.result,
        "number",
        lambda at: (0, 2**62, counted(at))[next(asked) % 3] if at == 16 else counted(at),
    )
    for turn in range(60):
        if turn % 5 == 0:
            stage.show(subject.home.turned(0.1 * turn, 0), SIDE, SIDE)
        stage.advance()
        assert min(stage.traced.now()) >= 0
    stage.show(subject.home, SIDE, SIDE)
    finished(stage)
    assert stage.state is State.TRACING


def test_an_exception_is_told(compiled: Compiled, staged: Staged) -> None:
    """It ends the picture, and names itself as far as it can."""
    subject = confetti()
    stage = staged(subject, compiled(sources.THROWS))
    stage.show(subject.home, SIDE, SIDE)
    finished(stage)
    assert "threw an exception" in stage.trouble


def test_a_hang_is_stopped(
    compiled: Compiled, staged: Staged, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The process is ended, and the pixel is named."""
    monkeypatch.setattr(traced_module, "PATIENCE", 0.5)
    subject = confetti()
    stage = staged(subject, compiled(sources.HANGS_AT_THE_RIGHT))
    stage.show(subject.home, SIDE, SIDE)
    finished(stage)
    assert "did not come back" in stage.trouble
    assert stage.trouble.startswith("intersect, pixel (")
    assert not stage.live.is_running


def test_a_crash_in_construct_is_told(compiled: Compiled, staged: Staged) -> None:
    """There is no tree then."""
    stage = staged(confetti(), compiled(sources.CRASHES_IN_CONSTRUCT))
    until(lambda: stage.state is State.ENDED, stage.advance)
    assert stage.in_construct
    assert stage.tree is None
    assert stage.trouble.startswith("construct: ")


def test_the_smallest_mesh_is_hit(right: Engine, staged: Staged) -> None:
    """Its faces are nearer to the camera than where the exercise's rays begin."""
    subject = of_mesh(mesh_named(41, "scaled-tiny"))
    stage = staged(subject, right)
    stage.show(subject.home, SIDE, SIDE)
    finished(stage)
    assert is_hit(stage.traced.t).any()
    assert not is_hit(stage.traced.t).all()


def test_an_empty_mesh_is_no_picture_and_no_fault(right: Engine, staged: Staged) -> None:
    """Nothing is hit."""
    empty = Mesh(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
    subject = of_mesh(empty)
    stage = staged(subject, right)
    stage.show(subject.home, 8, 8)
    finished(stage)
    assert not stage.trouble
    assert not is_hit(stage.traced.t).any()
