"""What differs from Mitsuba's picture is found again in the picture of differences."""

import numpy as np
import pytest

from grader.gallery.hung import reference_picture
from grader.gallery.pictures import flip
from grader.model.mesh import Bytes
from grader.oracle.scenes import scene_named
from tests.gallery.seen import place_of


@pytest.fixture(scope="module")
def reference() -> Bytes:
    """Mitsuba's picture of the nested spheres."""
    return reference_picture(place_of("nested"))


def test_a_reference_is_as_large_as_its_scene_says(reference: Bytes) -> None:
    """Rows first, then columns, three colours; there is something in it."""
    scene = scene_named("nested")
    assert reference.shape == (scene.height, scene.width, 3)
    assert len(np.unique(reference)) > 50


def test_equal_pictures_do_not_differ(reference: Bytes) -> None:
    """No error anywhere."""
    error, mean = flip(reference, reference)
    assert not error.any()
    assert mean == 0


def test_a_hole_of_one_pixel_is_seen_where_it_is(reference: Bytes) -> None:
    """The error is largest there and none far away."""
    spoilt = reference.copy()
    spoilt[100, 140] = 255 - spoilt[100, 140]
    error, mean = flip(reference, spoilt)
    assert error.argmax() == 100 * error.shape[1] + 140
    assert error[100, 140] > 0.2
    assert mean > 0
    assert not error[:20].any()


def test_only_the_surroundings_are_looked_at_and_that_changes_nothing(
    reference: Bytes,
) -> None:
    """The error of a spoilt block is the error that FLIP finds in the whole picture."""
    import flip_evaluator

    spoilt = reference.copy()
    spoilt[90:110, 120:150] = 0
    pair = [one.astype(np.float32) / np.float32(255) for one in (reference, spoilt)]
    whole, mean_of_all, _ = flip_evaluator.evaluate(*pair, "LDR", applyMagma=False)
    error, mean = flip(reference, spoilt)
    assert np.abs(error - whole[..., 0]).max() < 1e-3
    assert mean == pytest.approx(mean_of_all, rel=1e-3)
