"""What a run left behind becomes pictures and models, and our own fault costs no grade."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from grader.build.reference import reference_library
from grader.gallery import gallery as module
from grader.gallery.gallery import Gallery
from grader.model.cases import ImageCase, TreeCase
from grader.model.grade import Grade
from grader.model.mesh import Bvh, Hits
from grader.model.trials import ConstructTrial
from grader.model.verdict import Verdict
from grader.model.views import Views
from grader.oracle.scenes import load_mesh
from grader.run.session import Engine
from tests.compiled import engine_of
from tests.gallery.seen import case_of
from tests.report import samples
from tests.verify.builder import build

ENOUGH = 60.0
HOLE = 128 * 256 + 128
"""A pixel in the middle of the nested spheres."""


@pytest.fixture(scope="module")
def reference(cache: Path) -> Engine:
    """Trace with the model solution."""
    return engine_of(reference_library())


def with_a_hole(case: ImageCase) -> ImageCase:
    """Miss the surface in one pixel."""
    t = case.hits.t.copy()
    t[HOLE] = np.inf
    return replace(case, hits=Hits(case.hits.point, t, case.hits.normal))


def shown(gallery: Gallery, case: ImageCase, grade: Grade | None = None) -> Views:
    """Show what the gallery kept of the nested spheres."""
    result = gallery.shown(grade or samples.perfect(), [case.trial], ENOUGH)
    assert result.views is not None, result.build
    return result.views


def test_a_right_picture_is_shown_without_a_difference(reference: Engine) -> None:
    """Colours are Mitsuba's but for a few pixels at the edge of a shadow."""
    gallery, case = Gallery(reference), case_of("nested")
    gallery.note(case)
    (picture,) = shown(gallery, case).pictures
    assert picture.drawing is not None
    assert not picture.drawing.without_shadows
    assert not picture.drawing.wrong.any()
    assert (picture.drawing.yours != picture.reference).any(axis=2).sum() < 20
    assert (picture.drawing.tests == 3).all()


def test_a_hole_is_shown_with_the_way_of_its_ray(reference: Engine) -> None:
    """The picture has the hole, and the model the recorded ray of that pixel."""
    gallery, case = Gallery(reference), with_a_hole(case_of("nested"))
    gallery.note(case)
    views = shown(gallery, case)
    (drawing,) = [one.drawing for one in views.pictures]
    assert drawing is not None
    assert np.argwhere(drawing.wrong).tolist() == [[128, 128]]
    assert drawing.difference[128, 128] > 50
    ray = views.models[-1].ray
    assert ray is not None
    assert ray.origin == tuple(map(float, case.trial.rays.origin[HOLE]))
    assert ray.steps[0].node == 0
    assert any(step.node < 0 and step.hit for step in ray.steps)


def test_a_scene_that_was_not_seen_shows_mitsubas_picture_alone(reference: Engine) -> None:
    """As where `intersect` crashes."""
    (picture,) = shown(Gallery(reference), case_of("nested")).pictures
    assert picture.drawing is None
    assert picture.reference.any()


def failed_in_part_a() -> Grade:
    """A grade in which a check of part a failed."""
    grade = samples.perfect()
    checks = tuple(
        replace(one, verdict=Verdict.FAIL) if one.part == "a" else one for one in grade.checks
    )
    return replace(grade, checks=checks)


def built(shrunk: int | None = None) -> TreeCase:
    """Build a tree over the nested spheres, with one box too small or none."""
    mesh = load_mesh("nested")
    tree = build(mesh)
    high = tree.high.copy()
    if shrunk is not None:
        high[shrunk, 1] -= np.float32(0.25)
    tree = Bvh(tree.low, high, tree.begin, tree.end, tree.order, tree.node_count)
    return TreeCase("nested", ConstructTrial("nested", mesh), tree)


def test_a_box_that_is_too_small_is_shown_with_its_faces(reference: Engine) -> None:
    """The node, the box that it should have, and the faces of the coarsened mesh in it."""
    gallery, case = Gallery(reference), case_of("nested")
    gallery.note(built(shrunk=2))
    model = shown(gallery, case, failed_in_part_a()).models[-1]
    right = built().bvh
    assert model.node == 2
    assert model.right_box == (*map(float, right.low[2]), *map(float, right.high[2]))
    assert 0.3 < model.marked.size / len(model.mesh.faces) < 0.7


def test_where_part_a_is_right_no_node_is_looked_for(reference: Engine) -> None:
    """The submission's own boxes are shown, and none of them is called wrong."""
    gallery, case = Gallery(reference), case_of("nested")
    gallery.note(built())
    model = shown(gallery, case).models[-1]
    assert model.node == -1
    assert model.title == "nested spheres"
    assert not np.isnan(model.low[0]).any()


@pytest.mark.usefixtures("forgiving")
def test_our_own_fault_costs_the_pictures_and_nothing_else(
    reference: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The grade comes back as it was, but for a remark."""

    def broken(*_: object) -> None:
        raise RuntimeError("no colours left")

    monkeypatch.setattr(module, "pictures", broken)
    grade = samples.perfect()
    gallery, case = Gallery(reference), case_of("nested")
    gallery.note(case)
    after = gallery.shown(grade, [case.trial], ENOUGH)
    assert after.build is not None
    assert "RuntimeError" in after.build.remarks[-1]
    assert replace(after, build=grade.build) == grade


def test_without_time_nothing_is_drawn(reference: Engine) -> None:
    """A submission that used all of it in every case does not get more by its pictures."""
    gallery, case = Gallery(reference), case_of("nested")
    gallery.note(case)
    after = gallery.shown(samples.perfect(), [case.trial], 1.0)
    assert after.views is None
    assert after.build is not None
    assert "time" in after.build.remarks[-1]
