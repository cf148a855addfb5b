"""Shading what was found gives Mitsuba's picture, light, shadow and all."""

from dataclasses import replace

import numpy as np
import pytest

from grader.gallery.shading import displayed, shaded, shadow_rays
from grader.model.mesh import Hits, Mask
from grader.model.scene import NO_FACE, Scene
from grader.oracle.brute import answers
from tests.gallery.seen import case_of, scene_and_reference


def lit_pixels(name: str) -> Mask:
    """Ask the rule of closest hits which pixels see the light."""
    case, (scene, _) = case_of(name), scene_and_reference(name)
    pixels, rays = shadow_rays(case, scene)
    found = answers(case.trial.mesh, rays, case.trial.tree)
    lit = np.zeros(case.hits.t.size, np.bool_)
    lit[pixels] = np.isinf(found.limit)
    return lit


@pytest.mark.parametrize("name", ["grid", "nested"])
def test_a_right_submission_gets_mitsubas_colours(name: str) -> None:
    """All but one pixel in a thousand differ by rounding at most: two of 255 levels."""
    scene, picture = scene_and_reference(name)
    ours = shaded(case_of(name), scene, lit_pixels(name)).astype(np.int64)
    theirs = displayed(picture.shaded, picture.face != NO_FACE).astype(np.int64)
    apart = np.abs(ours - theirs).max(axis=1) > 2
    assert apart.mean() < 1e-3
    assert (picture.face != NO_FACE).mean() > 0.2


@pytest.mark.parametrize("name", ["grid", "nested"])
def test_there_are_shadows_to_get_right(name: str) -> None:
    """Some surface turned towards the light does not see it."""
    case, (scene, _) = case_of(name), scene_and_reference(name)
    pixels, _ = shadow_rays(case, scene)
    assert 0.001 < 1 - lit_pixels(name)[pixels].mean() < 0.9


def test_a_surface_turned_away_gets_no_shadow_ray() -> None:
    """It is dark whatever is between it and the light."""
    scene, case = scene_of_light((0.0, 0.0, -1.0)), case_of("nested")
    pixels, _ = shadow_rays(case, scene)
    seen = (case.hits.normal * case.trial.rays.direction).sum(axis=1)
    side = seen * (case.hits.normal @ np.array([0.0, 0.0, -1.0]))
    assert (side[pixels] > 0).all()
    assert 0 < pixels.size < np.isfinite(case.hits.t).sum()


def scene_of_light(light: tuple[float, float, float]) -> Scene:
    """Turn the light of a scene."""
    scene, _ = scene_and_reference("nested")
    return replace(scene, light=light)


@pytest.mark.parametrize("rubbish", [np.nan, np.inf, -np.inf, 1e38, -1.0])
def test_whatever_a_submission_returns_can_be_drawn(rubbish: float) -> None:
    """Not a number, infinities and huge values become some colour, without a warning."""
    scene, case = scene_of_light((1.0, 1.0, 1.0)), case_of("nested")
    spoilt = np.full(case.hits.t.size, rubbish, np.float32)
    vectors = np.full((case.hits.t.size, 3), rubbish, np.float32)
    case = replace(case, hits=Hits(vectors, spoilt, vectors))
    pixels, rays = shadow_rays(case, scene)
    assert len(rays.t_min) == pixels.size
    picture = shaded(case, scene, np.ones(spoilt.size, np.bool_))
    assert picture.dtype == np.uint8
    assert picture.shape == (spoilt.size, 3)


def test_a_pixel_without_a_hit_shows_the_background() -> None:
    """Background and black surface are told apart."""
    both = displayed(np.zeros((2, 3)), np.array([True, False]))
    assert (both[0] == 0).all()
    assert (both[1] > 20).all()
