"""How does a mesh of a million faces become one that a browser shows at once?

Vertices are pulled together in the cells of a grid; faces that lose a corner by that are left
out, and of several faces between the same cells one stays.
Source: J. Rossignac, P. Borrel, Multi-resolution 3D approximations for rendering complex
scenes, Modeling in Computer Graphics, 1993.
"""

import numpy as np

from grader.model.mesh import Doubles, Integers, Mesh

FINEST = 2.0
"""Cells along the longest side that are tried first, in square roots of the faces wanted."""

FEWEST = 100
"""One of so many faces wanted: of a surface far more are left than that."""

BITS = 10
"""Of each coordinate, by which faces are put in order."""


def coarsened(mesh: Mesh, most: int) -> tuple[Mesh, Integers]:
    """Return a mesh of at most so many faces, and (K,) the face that each of them was.

    Args:
        mesh: Of any size; one that is small enough is returned as it is.
        most: Faces that the result may have.
    """
    if len(mesh.faces) <= most:
        return mesh, np.arange(len(mesh.faces))
    cells = FINEST * float(np.sqrt(most))
    while True:
        small, kept = _clustered(mesh, cells)
        if len(kept) < max(1, most // FEWEST):
            kept = some_of(len(mesh.faces), most)
            points = mesh.vertices.astype(np.float64)
            return _renumbered(points, mesh.faces[kept].astype(np.int64)), kept
        if len(kept) <= most:
            return small, kept
        # Faces of a surface grow with the square of the cells along a side.
        cells *= min(0.95, float(np.sqrt(most / len(kept))))


def some_of(faces: int, most: int) -> Integers:
    """Return (K,) int64, faces spread evenly over all, at most so many.

    For loose faces that are smaller than a cell: no grid keeps them, but some of such faces
    look like all of them.
    """
    return np.arange(0, faces, -(-faces // most))


def _clustered(mesh: Mesh, cells: float) -> tuple[Mesh, Integers]:
    """Pull together the vertices of each cell, and keep the faces that still are triangles.

    If none does, the mesh comes back as it was, and no face was kept.
    """
    points = mesh.vertices.astype(np.float64)
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max()) or 1.0
    place = np.floor((points - low) * (cells / size)).astype(np.int64)
    side = int(cells) + 2
    _, cell = np.unique(place @ np.array([1, side, side * side]), return_inverse=True)
    corners = cell[mesh.faces.astype(np.int64)]
    whole = np.flatnonzero(
        (corners[:, 0] != corners[:, 1])
        & (corners[:, 1] != corners[:, 2])
        & (corners[:, 2] != corners[:, 0])
    )
    count = int(cell.max()) + 1
    ordered = np.sort(corners[whole], axis=1) @ np.array([1, count, count * count])
    _, first = np.unique(ordered, return_index=True)
    kept = whole[first]
    if not kept.size:
        return mesh, kept
    kept = kept[np.argsort(_along_a_curve(points[mesh.faces[kept, 0]]))]
    return _renumbered(_middles(points, cell, count), corners[kept]), kept


def _along_a_curve(points: Doubles) -> Integers:
    """Return (K,) int64, places on a curve that fills space: near ones are near in space.

    Source: G. M. Morton, A computer oriented geodetic data base, IBM, 1966.
    """
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max()) or 1.0
    place = ((points - low) * ((2**BITS - 1) / size)).astype(np.int64)
    code = np.zeros(len(points), np.int64)
    for bit in range(BITS):
        for axis in range(3):
            code |= (place[:, axis] >> bit & 1) << (3 * bit + axis)
    return code


def _middles(points: Doubles, cell: Integers, count: int) -> Doubles:
    """Return (count, 3) the mean of each cell's vertices."""
    sums = np.stack([np.bincount(cell, points[:, axis], count) for axis in range(3)], axis=1)
    return np.asarray(sums / np.bincount(cell, minlength=count)[:, None])


def _renumbered(points: Doubles, faces: Integers) -> Mesh:
    """Leave out unused points, and number the others as the faces come to them.

    Neighbours in the list of faces have near numbers then, which compress well.
    """
    used, first = np.unique(faces.ravel(), return_index=True)
    order = used[np.argsort(first)]
    place = np.zeros(len(points), np.int64)
    place[order] = np.arange(order.size)
    return Mesh(points[order].astype(np.float32), place[faces].astype(np.uint32))
