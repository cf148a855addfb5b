"""Colours of hits and costs, and what counts as another hit."""

import numpy as np
import pytest

from grader.model.mesh import Mesh
from grader.report.colours import HEAT
from grader.view.camera import frame_of, orbit_around
from grader.view.shades import BACKGROUND, brightness, coloured, differing, heat, light_of, tint
from grader.view.thinned import FEW, thinned
from tests.verify.builder import soup

FRAME = frame_of(orbit_around(-np.ones(3), np.ones(3)))
INF = np.inf


@pytest.mark.parametrize(
    ("one", "other", "differs"),
    [
        (1.0, 1.0, False),
        (1.0, 1.00001, False),
        (1.0, 1.01, True),
        (INF, 1.0, True),
        (1.0, INF, True),
        (INF, INF, False),
        (np.nan, INF, False),
        (np.nan, 1.0, True),
        (-INF, INF, True),
        (3e38, -3e38, True),
    ],
)
def test_a_lost_hit_differs(one: float, other: float, differs: bool) -> None:
    """As does a false one, and one somewhere else; a t that is none is a miss."""
    pair = np.array([[one], [other]], np.float32)
    assert differing(pair[0], pair[1])[0] == differs


def test_faces_are_darker_the_more_they_turn_away() -> None:
    """From both sides alike; a miss has the background's colour, and nonsense is dark."""
    light = light_of(FRAME)
    across = np.cross(light, FRAME.up)
    hits = np.zeros((5, 7), np.float32)
    hits[:, 3] = 1.0
    hits[0, 4:], hits[1, 4:], hits[2, 4:] = light, -light, across
    hits[3, 3] = INF
    hits[4, 4:] = np.nan
    bright = brightness(hits, FRAME)
    assert bright[0] == bright[1] == 255
    assert bright[2] <= 2
    assert bright[3] == 0
    assert bright[4] == 1
    colours = coloured(bright, (0.5, 0.5, 0.5))
    assert tuple(colours[3]) == BACKGROUND
    assert colours[0] == pytest.approx(tint((0.5, 0.5, 0.5)), abs=1)


def test_costs_beyond_the_scale_are_brightest() -> None:
    """From the dark end of the scale to the bright one."""
    tests = np.array([[0, 5, 10, 4_000_000_000]], np.uint32)
    colours = heat(tests, 10, HEAT)
    assert (colours[0, 0] == HEAT[0]).all()
    assert (colours[0, 1] == HEAT[127]).all()
    assert (colours[0, 2] == HEAT[255]).all()
    assert (colours[0, 3] == HEAT[255]).all()


def test_a_small_mesh_is_moved_as_it_is() -> None:
    """Only a large one is thinned, to fewer faces in the same place."""
    small, large = soup(50), soup(FEW + 1, scale=0.05)
    assert thinned(small) is small
    few = thinned(large)
    assert 0 < len(few.faces) <= len(large.faces)
    assert few.faces.max() < len(few.vertices)


@pytest.mark.parametrize("far", [0.0, 300.0])
def test_a_mesh_whose_faces_are_smaller_than_a_cell_is_seen_all_the_same(far: float) -> None:
    """Loose faces, or all in one cell because another one is far away: some of them stay."""
    large = soup(FEW + 1)
    corners = large.vertices[large.faces]
    middle = corners.mean(axis=1, keepdims=True)
    loose = (middle + 1e-5 * (corners - middle)).reshape(-1, 3).astype(np.float32)
    loose[:3] += np.float32(far)
    faces = np.arange(len(loose), dtype=np.uint32).reshape(-1, 3)
    few = thinned(Mesh(loose, faces))
    assert FEW // 3 < len(few.faces) <= FEW
    assert few.faces.max() < len(loose)
