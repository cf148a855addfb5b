"""How far are a hit's point and normal from the truth, and how far may they be?"""

import numpy as np

from grader.model.cases import HitCase
from grader.model.mesh import Doubles, Integers
from grader.tolerances import NORMAL_ERROR, POINT_ERROR, UNIT_ROUNDOFF

u = UNIT_ROUNDOFF


def point_errors(case: HitCase, accepted: Integers) -> tuple[Doubles, Doubles]:
    """Return (R,) distances of points from o + t d, and what is allowed; NaN without a hit.

    Args:
        case: The hits.
        accepted: (R,) candidate that explains each hit, or -1.
    """
    hit = np.flatnonzero(accepted >= 0)
    candidate = accepted[hit]
    off, allowed = (np.full(accepted.size, np.nan) for _ in range(2))
    o = case.trial.rays.origin[hit].astype(np.float64)
    d = case.trial.rays.direction[hit].astype(np.float64)
    t = case.hits.t[hit].astype(np.float64)
    with np.errstate(invalid="ignore", over="ignore"):
        off[hit] = _length(case.hits.point[hit].astype(np.float64) - (o + t[:, None] * d))
    corners = _corners(case, candidate)
    largest = _length(corners).max(axis=1)
    e1, e2, e3 = _edges(corners)
    lengths = np.stack([_length(e1), _length(e2), _length(e3)])
    speed = _length(d)
    rounding = _length(o) + np.abs(t) * speed + largest
    across = lengths.max(axis=0) ** 2 / lengths.min(axis=0)
    bound = case.trial.answers.tolerance[candidate] * speed + u * (4 * rounding + 40 * across)
    allowed[hit] = POINT_ERROR * bound
    return off, allowed


def normal_errors(case: HitCase, candidate: Integers, ray: Integers) -> tuple[Doubles, Doubles]:
    """Return (K,) distances of normals from their faces' unit normals, and what is allowed.

    Args:
        case: The hits.
        candidate: (K,) candidates, none of them WILD.
        ray: (K,) the ray of each.
    """
    e1, e2, e3 = _edges(_corners(case, candidate))
    normal = np.cross(e1, e2)
    area = _length(normal)
    longest = np.maximum(np.maximum(_length(e1), _length(e2)), _length(e3))
    with np.errstate(invalid="ignore", over="ignore"):
        error = _length(case.hits.normal[ray].astype(np.float64) - normal / area[:, None])
    return error, u * NORMAL_ERROR * (1 + longest * longest / area)


def _corners(case: HitCase, candidate: Integers) -> Doubles:
    """Return (K, 3, 3) corners of candidates."""
    mesh = case.trial.mesh
    return mesh.vertices[mesh.faces[case.trial.answers.face[candidate]]].astype(np.float64)


def _edges(corners: Doubles) -> tuple[Doubles, Doubles, Doubles]:
    """Return v2 - v1, v3 - v1, v3 - v2, (K, 3) each."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    return b - a, c - a, c - b


def _length(vectors: Doubles) -> Doubles:
    """Return lengths along the last axis."""
    length: Doubles = np.sqrt((vectors * vectors).sum(axis=-1))
    return length
