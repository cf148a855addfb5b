"""Which mesh will do while the camera moves? One whose vertices are pulled into a grid's cells.

A report's mesh is made with more care (`gallery/coarse.py`), which takes seconds for a million
faces; this one is looked at for a moment, and takes a tenth of one.
"""

import numpy as np

from grader.gallery.coarse import FEWEST, some_of
from grader.model.mesh import Mesh

FEW = 60_000
"""Faces that are drawn fast enough as they are."""

CELLS = 104
"""Along the longest side."""


def thinned(mesh: Mesh) -> Mesh:
    """Return a mesh of fewer faces, or the mesh itself if it has few."""
    if len(mesh.faces) <= FEW:
        return mesh
    low = mesh.vertices.min(axis=0)
    size = float((mesh.vertices.max(axis=0) - low).max())
    if not 0 < size < np.inf:
        return mesh
    place = ((mesh.vertices - low) * np.float32((CELLS - 1) / size)).astype(np.int32)
    sides = place.max(axis=0).astype(np.int64) + 1
    cell = (place[:, 0] * sides[1] + place[:, 1]) * sides[2] + place[:, 2]
    # The last vertex of each cell stands for all of them.
    chosen = np.full(int(sides.prod()), -1, np.int32)
    chosen[cell] = np.arange(len(cell), dtype=np.int32)
    corners = chosen[cell].take(mesh.faces.astype(np.int64))
    a, b, c = corners.T
    whole = corners[(a != b) & (b != c) & (c != a)]
    key = np.sort(whole, axis=1).astype(np.int64)
    code = (key[:, 0] * len(cell) + key[:, 1]) * len(cell) + key[:, 2]
    _, first = np.unique(code, return_index=True)
    if first.size < FEW // FEWEST:
        some = mesh.faces[some_of(len(mesh.faces), FEW)]
        return Mesh(mesh.vertices, np.ascontiguousarray(some))
    return Mesh(mesh.vertices, whole[first].astype(np.uint32))
