"""Which meshes can be described in a sentence and built by a few lines.

Coordinates are snapped to multiples of 2^-16: a sine that another processor or library version
rounds differently then still gives the same float32, so that hashes of these meshes hold.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from grader.model.mesh import Doubles, Mesh

if TYPE_CHECKING:
    import trimesh

SNAP = 2.0**-16
SOLID_RADIUS = 0.49
"""Just under half a cell, so that no two solids of the grid touch."""

OCTAHEDRON = (
    ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)),
    ((0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)),
)
"""Corners and outward faces."""


def primitive_grid(rng: np.random.Generator, side: int = 10) -> Mesh:
    """Build the sheet's grid of primitives: side x side solids in the plane z = 0.

    Every ten cells hold each of ten kinds of solids once, each turned at random.

    Source: exercise sheet, figure 3, "Multiple primitives in a 10 x 10 grid".
    """
    kinds = [rng.permutation(len(SOLIDS)) for _ in range(-(-side * side // len(SOLIDS)))]
    parts = []
    for cell, kind in enumerate(np.concatenate(kinds)[: side * side]):
        solid = SOLIDS[kind]()
        row, column = divmod(cell, side)
        centre = np.array([column - (side - 1) / 2, row - (side - 1) / 2, 0.0])
        around = np.asarray(solid.vertices) - solid.bounds.mean(axis=0)
        around *= SOLID_RADIUS / np.linalg.norm(around, axis=1).max()
        parts.append((around @ _rotation(rng).T + centre, np.asarray(solid.faces)))
    return _joined(parts)


def nested_spheres(shells: int = 6, subdivisions: int = 4, opened: bool = True) -> Mesh:
    """Build concentric spheres of radius 1, 5/6, ...; all but the innermost are opened.

    Args:
        shells: How many spheres.
        subdivisions: Each turns a face of an octahedron into four.
        opened: Leave out the octant x, y, z > 0, so that a camera there sees every sphere.
    """
    import trimesh

    vertices, faces = (np.array(table) for table in OCTAHEDRON)
    for _ in range(subdivisions):
        vertices, faces = trimesh.remesh.subdivide(vertices, faces)
    vertices = vertices / np.linalg.norm(vertices, axis=1, keepdims=True)
    removed = (vertices[faces].mean(axis=1) > 0).all(axis=1)
    parts = []
    for shell in range(shells, 0, -1):
        keep = ~removed if opened and shell > 1 else np.ones_like(removed)
        parts.append((vertices * (shell / shells), faces[keep]))
    return _joined(parts)


def _joined(parts: Sequence[tuple[Doubles, Doubles]]) -> Mesh:
    """Join (vertices, faces) pairs into one mesh with snapped coordinates."""
    counts = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = [faces + start for (_, faces), start in zip(parts, counts[:-1], strict=True)]
    vertices = np.concatenate([vertices for vertices, _ in parts])
    return Mesh(
        vertices=(np.rint(vertices / SNAP) * SNAP).astype(np.float32),
        faces=np.concatenate(faces).astype(np.uint32),
    )


def _rotation(rng: np.random.Generator) -> Doubles:
    """Return a (3, 3) rotation drawn evenly from all rotations, by a random unit quaternion."""
    quaternion = rng.standard_normal(4)
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _solid(name: str, **options: float | tuple[int, int]) -> Callable[[], "trimesh.Trimesh"]:
    """Return a maker of one of the solids that trimesh can build."""

    def make() -> "trimesh.Trimesh":
        import trimesh

        solid: trimesh.Trimesh = getattr(trimesh.creation, name)(**options)
        return solid

    return make


SOLIDS = (
    _solid("box"),
    _solid("icosahedron"),
    _solid("icosphere", subdivisions=2),
    _solid("cone", radius=0.6, height=1.2, sections=4),
    _solid("cone", radius=0.6, height=1.2, sections=32),
    _solid("cylinder", radius=0.5, height=1.0, sections=6),
    _solid("cylinder", radius=0.4, height=1.2, sections=32),
    _solid("torus", major_radius=0.6, minor_radius=0.22, major_sections=32, minor_sections=12),
    _solid("capsule", radius=0.4, height=0.7, count=(16, 16)),
    _solid("annulus", r_min=0.35, r_max=0.6, height=0.5, sections=32),
)
"""The kinds of solids in the grid, from 8 to 768 faces."""
