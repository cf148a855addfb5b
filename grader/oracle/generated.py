"""Which meshes are made from a few numbers in `scenes.toml`, as large as one likes?

Each takes the number of faces and a seed, and gives exactly so many faces, the same on every
machine (`noise.py` says why). z points up.
"""

from collections.abc import Callable, Mapping

import numpy as np

from grader.model.mesh import Doubles, Indices, Mesh
from grader.oracle.noise import drawn, hills
from grader.oracle.shapes import Soup, flatness, sheet

MOST_FACES = 4_000_000
"""Just below where the depth limit ends a tree before its leaves are small."""

OCTAVES = 8
SHORE = 0.62
"""Distance of the island's shore from its middle, in half sides of the square."""

FLATTEST = 40.0
"""`shapes.flatness` of a triangle of the soup; needles have scenes of their own."""

NEEDLE_FACES = 8
"""A needle is two thin pyramids back to back."""

WIRE_SIDES, WIRE_STEPS = 6, 48
"""A wire is a ring, and made of so many short tubes."""

AROUND = ((1, 0), (0, 1), (-1, 0), (0, -1))
"""Corners of the square where a needle is thickest."""


def landscape(faces: int, seed: int) -> Mesh:
    """Make an island of mountains in a flat sea, a square from -1 to 1."""
    cells = -(-faces // 2)
    columns = max(1, round(float(np.sqrt(cells))))
    rows = -(-cells // columns)
    x, y = np.meshgrid(np.linspace(-1, 1, columns + 1), np.linspace(-1, 1, rows + 1))
    points = np.stack([x, y, _heights(seed, x, y)], axis=-1).astype(np.float32)
    net = _net(columns, rows)[:faces]
    return Mesh(points.reshape(-1, 3)[: net.max() + 1], net)


def soup(faces: int, seed: int) -> Mesh:
    """Throw loose triangles into a ball; the more there are, the smaller they are."""
    centre = 2 * drawn(seed, 0, 4 * faces + 64, 3) - 1
    centre = centre[(centre * centre).sum(axis=1) < 1][:faces]
    size = 1.1 * (0.35 + drawn(seed, 1, faces, 1, 1)) / np.sqrt(np.sqrt(faces))
    corners = 2 * drawn(seed, 2, 3 * faces + 64, 3, 3) - 1
    corners = corners[flatness(corners) < FLATTEST][:faces]
    return _loose(centre[:, None] + size * corners)


def thin(faces: int, seed: int) -> Mesh:
    """Make a sea urchin: needles around a core, three rings of wire around the needles."""
    rings = 3 * 2 * WIRE_SIDES * WIRE_STEPS
    count = -(-max(0, faces - rings) // NEEDLE_FACES)
    parts = [_ring(axis, radius) for axis, radius in enumerate((0.94, 0.97, 1.0))]
    return _loose(np.concatenate([*parts, *_needles(seed, count)])[:faces])


GENERATED: Mapping[str, Callable[[int, int], Mesh]] = {
    "landscape": landscape,
    "soup": soup,
    "thin": thin,
}
"""Generator by its name in `scenes.toml`, from a number of faces and a seed."""


def _heights(seed: int, x: Doubles, y: Doubles) -> Doubles:
    """Return heights of the land: ridges that fade to the shore; the sea has height 0."""
    bend = 0.25 * hills(seed, 100, 1.7 * x + 9, 1.7 * y + 9)
    rough = np.zeros_like(x)
    scale, weight, before = 1.6, 0.5, np.ones_like(x)
    for octave in range(OCTAVES):
        ridge = 1 - np.abs(1.6 * hills(seed, octave, scale * (x + bend) + 31, scale * y + 57))
        ridge = ridge * ridge * before
        rough += weight * ridge
        scale, weight, before = scale * 2.03, weight * 0.5, np.clip(1.2 * ridge, 0, 1)
    away = np.sqrt(x * x + y * y) + 0.5 * hills(seed, 101, 2.3 * x + 5, 2.3 * y + 5)
    border = np.clip(5 * (0.95 - np.maximum(np.abs(x), np.abs(y))), 0, 1)
    land = np.clip((SHORE + 0.3 - away) / 0.6, 0, 1) * border
    land = land * land * (3 - 2 * land)
    return np.asarray(np.maximum(0.0, 0.55 * land * rough - 0.03))


def _net(columns: int, rows: int) -> Indices:
    """Return (2 x columns x rows, 3) vertex indices of a net's triangles, row by row."""
    start = np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)
    a, b, c, d = start, start + 1, start + columns + 2, start + columns + 1
    halves = np.stack([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)], axis=2)
    return halves.reshape(-1, 3).astype(np.uint32)


def _loose(corners: Soup) -> Mesh:
    """Turn triangles into a mesh in which equal corners are one vertex."""
    points = corners.astype(np.float32).reshape(-1, 3) + np.float32(0)  # -0.0 becomes 0.0
    vertices, faces = np.unique(points, axis=0, return_inverse=True)
    return Mesh(vertices, faces.reshape(-1, 3).astype(np.uint32))


def _needles(seed: int, count: int) -> list[Soup]:
    """Make thin double pyramids that point outwards, evenly over the sphere."""
    if not count:
        return []
    out = _spread(count)
    side = np.cross(out, np.where(np.abs(out[:, 2:]) < 0.7, [[0.0, 0, 1]], [[1.0, 0, 0]]))
    side /= np.sqrt((side * side).sum(axis=1, keepdims=True))
    other = np.cross(out, side)
    length = 0.72 + 0.2 * drawn(seed, 0, count, 1)
    tips = np.stack([0.1 * out, length * out])
    middle, wide = 0.4 * out, 0.024
    square = [middle + wide * (i * side + j * other) for i, j in AROUND]
    sides = [(square[k], square[k - 1]) for k in range(4)]
    faces = [np.stack([*side, tip], axis=1) for tip in tips for side in sides]
    return [np.stack(faces, axis=1).reshape(-1, 3, 3)]


def _spread(count: int) -> Doubles:
    """Spread points on the unit sphere along a golden spiral."""
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.arange(count) * np.pi * (3 - np.sqrt(5))
    across = np.sqrt(1 - height * height)
    return _snapped(np.stack([across * np.cos(turn), across * np.sin(turn), height], axis=1))


def _ring(axis: int, radius: float) -> Soup:
    """Make a wire: a tube around a circle across an axis."""
    along, around = np.meshgrid(
        np.arange(WIRE_STEPS + 1) % WIRE_STEPS * (2 * np.pi / WIRE_STEPS),
        np.arange(WIRE_SIDES + 1) % WIRE_SIDES * (2 * np.pi / WIRE_SIDES),
    )
    away, thick = radius + 0.014 * np.cos(around), 0.014 * np.sin(around)
    net = np.stack([away * np.cos(along), away * np.sin(along), thick], axis=-1)
    return np.roll(sheet(_snapped(net)), axis, -1)


def _snapped(points: Doubles) -> Doubles:
    """Round so coarsely that no two libraries' sines give other numbers."""
    return np.asarray(np.rint(points * 2**16) / 2**16)
