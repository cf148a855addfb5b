"""Lines in space become lines on a picture, where the camera sees them."""

import numpy as np
import pytest

from grader.view.camera import frame_of, orbit_around, rays_of
from grader.view.inspector import facts_of, judgement
from grader.view.overlay import Stroke, edges, of_node, outlines, projected
from tests.verify.builder import build, changed, soup

ORBIT = orbit_around(-np.ones(3), np.ones(3))


def test_a_box_has_twelve_edges() -> None:
    """Each is parallel to an axis and as long as the box."""
    lines = edges((0.0, 0.0, 0.0, 1.0, 2.0, 3.0))
    lengths = np.abs(lines[:, 1] - lines[:, 0])
    assert lines.shape == (12, 2, 3)
    assert (np.count_nonzero(lengths, axis=1) == 1).all()
    assert sorted(lengths.max(axis=1)) == [1] * 4 + [2] * 4 + [3] * 4
    assert len(np.unique(lines.reshape(12, 6), axis=0)) == 12


def test_a_point_is_drawn_at_its_pixel() -> None:
    """What lies on the ray of a pixel is drawn in the middle of it."""
    ray = rays_of(ORBIT, 40, 30, np.array([7 * 40 + 11]))[0].astype(np.float64)
    ends = np.stack([ray[0:3] + t * ray[3:6] for t in (1.0, 2.0)])
    flat = projected(Stroke(ends[None], (1, 2, 3), 1.0), ORBIT, 40, 30)
    assert flat.lines[0] == pytest.approx(np.tile([11.5, 7.5], (2, 1)), abs=1e-3)


def test_what_lies_behind_the_camera_is_cut_off() -> None:
    """A line that begins behind the eye ends on the picture; one that stays there is gone."""
    frame = frame_of(ORBIT)
    behind, ahead = frame.eye + frame.back, frame.eye - frame.back
    lines = np.stack([[behind, ahead + 0.1 * frame.up], [behind, behind + frame.up]])
    flat = projected(Stroke(lines, (0, 0, 0), 1.0), ORBIT, 40, 40)
    assert len(flat.lines) == 1
    assert np.isfinite(flat.lines).all()


def test_numbers_that_are_none_are_left_out() -> None:
    """A stranger's box may hold anything."""
    bad = edges((np.nan, 0.0, 0.0, np.inf, 1.0, 1.0))
    assert not len(projected(Stroke(bad, (0, 0, 0), 1.0), ORBIT, 40, 40).lines)


def test_a_wrong_node_is_drawn_with_the_right_box() -> None:
    """Two boxes and the sides of the faces."""
    mesh = soup(12)
    tree = changed(build(mesh), "low", (1, 1), -50.0)
    facts = facts_of(mesh, tree, 1, judgement(mesh, tree))
    strokes = list(of_node(mesh, facts))
    assert [len(one.lines) for one in strokes] == [12, 12, 3 * facts.faces.size]
    assert outlines(mesh, facts.faces).shape == (3 * facts.faces.size, 2, 3)
