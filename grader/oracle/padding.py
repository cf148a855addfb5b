"""How far from its triangle can a hit lie that float32 arithmetic reports? And small algebra.

A hit that a float32 test reports is a point of the ray, off the triangle's plane by at most
12u |e1||e2| (s + |t||d|) / |n| and off its edges by 40u L^2/|e|, which at an acute corner
reaches L^2/|n| times as far. Both are below

    EDGE_PADDING u (|o| + |v1| + |e1| + |e2|) L^2/|n|

so a triangle whose padded box the ray does not touch cannot be reported.
"""

import numpy as np

from grader.model.mesh import Doubles, Floats, Indices
from grader.tolerances import EDGE_ON, EDGE_PADDING, NEEDLE, TRIANGLE_ERROR, UNIT_ROUNDOFF

FLATTEST = EDGE_ON / (TRIANGLE_ERROR * UNIT_ROUNDOFF)
"""From |e1||e2|/|n| on a triangle is WILD for every ray."""


Corners = tuple[Doubles, Doubles, Doubles]
"""The three corners of K triangles, (3, K) float64 each."""


def dot(a: Doubles, b: Doubles) -> Doubles:
    """Return (K,) dot products of (3, K) vectors, all float64."""
    product: Doubles = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return product


def cross(a: Doubles, b: Doubles) -> Doubles:
    """Return (3, K) cross products of (3, K) vectors, all float64."""
    return np.stack(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def norm(a: Doubles) -> Doubles:
    """Return (K,) lengths of (3, K) vectors."""
    length: Doubles = np.sqrt(dot(a, a))
    return length


def columns(vectors: Floats) -> Doubles:
    """Turn (K, 3) float32 vectors into (3, K) float64 ones, components apart."""
    return np.ascontiguousarray(vectors.T, dtype=np.float64)


def corners_of(vertices: Doubles, faces: Indices) -> Corners:
    """Return the corners (3, K) of faces, given all vertices as (3, V)."""
    a, b, c = (vertices[:, faces[:, corner]] for corner in range(3))
    return a, b, c


def edge_padding(corners: Corners) -> tuple[Doubles, Doubles]:
    """Return what pads a face's box for EDGE candidates: (K,) factor, (K,) size of the face.

    The padding is factor x (distance of the ray's origin from the world's origin + size).
    """
    a, b, c = corners
    e1, e2, e3 = b - a, c - a, c - b
    first, second, area = norm(e1), norm(e2), norm(cross(e1, e2))
    longest = np.maximum(np.maximum(first, second), norm(e3))
    always_wild = first * second >= FLATTEST * area
    with np.errstate(divide="ignore", invalid="ignore"):
        flatness = np.clip(longest * longest / area, 1.0, NEEDLE)
    factor = EDGE_PADDING * UNIT_ROUNDOFF * np.where(always_wild, 1.0, flatness)
    return factor, norm(a) + first + second
