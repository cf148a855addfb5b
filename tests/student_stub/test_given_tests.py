"""The given box and triangle tests, reached through a tree of one node.

The reference asks the box test first, so a triangle test happened if and only if the box was
hit.
"""

import ctypes

import numpy as np
import pytest

from tests.student_stub.library import NODE, MeshInLibrary, Trace

INF, NAN = np.inf, np.nan
UNIT = ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))
FLAT = ((0.0, 0.0, 0.5), (1.0, 1.0, 0.5))
EMPTY = ((INF, INF, INF), (-INF, -INF, -INF))
LARGE = ((-1e9, -1e9, -1e9), (1e9, 1e9, 1e9))
TRIANGLE = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))

Box = tuple[tuple[float, ...], tuple[float, ...]]
Corners = tuple[tuple[float, ...], ...]


def shoot(library: ctypes.CDLL, box: Box, corners: Corners, ray: tuple[float, ...]) -> Trace:
    """Trace one ray against one triangle in a tree that consists of one given box."""
    mesh = MeshInLibrary(library, corners, [0, 1, 2])
    mesh.set_tree(np.array([(*box, 0, 1)], NODE), [0])
    return mesh.trace(ray)


@pytest.mark.parametrize(
    ("box", "ray", "hit"),
    [
        (UNIT, (0.5, 0.5, -1, 0, 0, 1, 0, INF), True),
        (UNIT, (0.5, 0.5, 2, 0, 0, 1, 0, INF), False),
        (UNIT, (0.5, 0.5, 2, 0, 0, -1, 0, INF), True),
        (UNIT, (0.5, 0.5, 0.5, 0.3, 0, 1, 0, 1e-3), True),
        (UNIT, (0.5, 0.5, -1, 0, 0, 1, 0, 0.5), False),
        (UNIT, (0.5, 0.5, -1, 0, 0, 1, 0, 1), True),
        (UNIT, (0.5, 0.5, -1, 0, 0, 1, 2.5, INF), False),
        (FLAT, (0.5, 0.5, -1, 0, 0, 1, 0, INF), True),
        (FLAT, (-1, 0.5, 0.5, 1, 0, 0, 0, INF), True),
        (EMPTY, (0.5, 0.5, -1, 0, 0, 1, 0, INF), False),
        (EMPTY, (0, 0, 0, 1, 1, 1, 0, INF), False),
        (EMPTY, (0, 0, 0, -1, 0.0, -0.0, 0, INF), False),
        (UNIT, (0, 0, -1, 0, 0, 1, 0, INF), True),
        (UNIT, (1, 1, -1, 0, 0, 1, 0, INF), True),
        (UNIT, (1, 0, -1, -0.0, -0.0, 1, 0, INF), True),
        (UNIT, (0, 1, 2, -0.0, 0, -1, 0, INF), True),
        (UNIT, (-1, 0.5, -1, 0, 0, 1, 0, INF), False),
        (UNIT, (-1, 0.5, -1, -0.0, 0, 1, 0, INF), False),
        (UNIT, (2, 0.5, -1, 0, 0, 1, 0, INF), False),
        (UNIT, (2, 0.5, -1, -0.0, 0, 1, 0, INF), False),
        (UNIT, (-1, 0.5, 0.5, 0, 0, 0, 0, INF), False),
        (UNIT, (0.5, 0.5, 0.5, 1, 0, 0, 0, NAN), False),
    ],
)
def test_boxes(library: ctypes.CDLL, box: Box, ray: tuple[float, ...], hit: bool) -> None:
    """Touching, starting inside, flat, empty, parallel and signed-zero cases are decided."""
    tests = shoot(library, box, TRIANGLE, ray).tests[0]
    assert tests.tolist() == [1, int(hit)]


def test_rounding_never_loses_a_box(library: ctypes.CDLL) -> None:
    """Rays towards points of a box that has no thickness at all always hit it."""
    rng = np.random.default_rng(20260101)
    points = rng.uniform(0, 1, (20000, 3)).astype(np.float32)
    mesh = MeshInLibrary(library, TRIANGLE, [0, 1, 2])
    for point in points[:40]:
        mesh.set_tree(np.array([(point, point, 0, 1)], NODE), [0])
        rays = np.zeros((500, 8), np.float32)
        direction = rng.normal(size=(500, 3)).astype(np.float32)
        rays[:, 3:6], rays[:, 7] = direction, INF
        rays[:, :3] = point - direction * np.float32(0.25)
        aimed = (point - rays[:, :3]) * np.float32(4)
        rays[:, 3:6] = np.where(np.abs(aimed - direction) < 1e-4, aimed, direction)
        assert mesh.trace(rays).tests[:, 1].all()


@pytest.mark.parametrize(
    ("ray", "t"),
    [
        ((0.25, 0.25, 1, 0, 0, -1, 0, INF), 1),
        ((0.25, 0.25, -1, 0, 0, 1, 0, INF), 1),
        ((0.25, 0.25, 1, 0, 0, -4, 0, INF), 0.25),
        ((0.25, 0.25, 1, 0, 0, -1, 1, INF), INF),
        ((0.25, 0.25, 1, 0, 0, -1, 0, 1), INF),
        ((0.25, 0.25, 1, 0, 0, -1, 0.5, 1.5), 1),
        ((0.25, 0.25, 1, 0, 0, 1, 0, INF), INF),
        ((0.25, 0.25, 1, 0, 0, 1, -2, INF), -1),
        ((0.75, 0.75, 1, 0, 0, -1, 0, INF), INF),
        ((0.5, 0.5, 1, 0, 0, -1, 0, INF), 1),
        ((0, 0, 1, 0, 0, -1, 0, INF), 1),
        ((-1, 0.25, 0, 1, 0, 0, 0, INF), INF),
        ((0.25, 0.25, 1, 0, 0, 0, 0, INF), INF),
        ((0.25, 0.25, NAN, 0, 0, -1, 0, INF), INF),
    ],
)
def test_triangles(library: ctypes.CDLL, ray: tuple[float, ...], t: float) -> None:
    """Both sides, borders, limits of t, and rays in the plane are decided."""
    hit = shoot(library, LARGE, TRIANGLE, ray).hits[0]
    assert hit["t"] == np.float32(t)
    if np.isfinite(t):
        assert hit["normal"].tolist() == [0, 0, 1]
        assert hit["point"].tolist() == [ray[k] + t * ray[3 + k] for k in range(3)]


@pytest.mark.parametrize(
    "corners",
    [
        ((0, 0, 0), (0, 0, 0), (0, 0, 0)),
        ((0, 0, 0), (1, 0, 0), (1, 0, 0)),
        ((0, 0, 0), (0, 0, 0), (1, 0, 0)),
        ((0, 0, 0), (1, 0, 0), (2, 0, 0)),
        ((0.1, 0.2, 0.3), (0.7, 0.1, 0.9), (0.1, 0.2, 0.3)),
    ],
)
def test_triangles_without_area_are_never_hit(library: ctypes.CDLL, corners: Corners) -> None:
    """Points and lines are missed, also by rays that pass right through them."""
    for point in (np.asarray(c) for c in corners):
        assert shoot(library, LARGE, corners, (*point, 0, 0, 1, -1, INF)).hits["t"][0] == INF
        ray = (*(point - (0, 0, 1)), 0, 0, 1, 0, INF)
        assert shoot(library, LARGE, corners, ray).hits["t"][0] == INF


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1, 1e4])
def test_small_triangles_are_hit_like_large_ones(library: ctypes.CDLL, size: float) -> None:
    """No absolute epsilon decides: the same scene in any size has the same hits."""
    corners = tuple(tuple(size * x for x in corner) for corner in TRIANGLE)
    ray = (0.25 * size, 0.25 * size, size, 0, 0, -size, 0, INF)
    assert shoot(library, LARGE, corners, ray).hits["t"][0] == pytest.approx(1, rel=1e-6)
