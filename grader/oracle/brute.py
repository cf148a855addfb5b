"""Which triangles does a ray hit, which may it hit, and which can float32 not decide?

The rule, in float64 on float32 inputs; u = 2^-24, edges e1 = v2 - v1, e2 = v3 - v1, e3, the
longest of length L:

    n = e1 x e2, den = d . n, t = (v1 - o) . n / den, s = |v1 - o|
    rel   = 12u |e1||e2||d| / |den|
    flat  = 4 |n| (|o| + max|v_k|), if the test forms n . v - n . o
    tol   = u ((12 |e1||e2| (s + |t||d|) + flat) / |den| + 2|t|) / (1 - rel)
    eps_k = tol |d| + 2u (|o| + |t||d| + max|v|) + 40u L^2/|e_k|
    WILD    rel >= 1/4, if the ray touches the triangle's padded box
    MISS    some in-plane distance to an edge < -eps, or t outside of the interval by > tol
    SOLID   all distances > eps and t inside of the interval by > tol
    EDGE    otherwise, if the ray touches the triangle's padded box
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np

from grader.model.mesh import (
    EDGE,
    SOLID,
    WILD,
    Answers,
    Bvh,
    Bytes,
    Doubles,
    FrozenArrays,
    Integers,
    Mask,
    Mesh,
    Rays,
)
from grader.oracle.culling import ALL_PAIRS, Pairs, all_pairs, culled_pairs
from grader.oracle.padding import Corners, columns, corners_of, cross, dot, edge_padding, norm
from grader.tolerances import (
    EDGE_ERROR,
    EDGE_ON,
    PLANE_ERROR,
    TRIANGLE_ERROR,
    UNIT_ROUNDOFF,
    WILD_PADDING,
)

RULE_VERSION = 2
"""Goes up when the rule answers otherwise, so that answers stored before are not used."""

u = UNIT_ROUNDOFF


@dataclass(frozen=True, slots=True, eq=False)
class Candidates(FrozenArrays):
    """(ray, face) pairs that are not a MISS, sorted by ray, then face."""

    ray: Integers
    """(C,) int64."""

    face: Integers
    """(C,) int64."""

    t: Doubles
    """(C,) float64."""

    tolerance: Doubles
    """(C,) float64; infinite if WILD."""

    kind: Bytes
    """(C,) uint8, one of SOLID, EDGE, WILD."""

    entry: Doubles
    """(C,) float64, where the ray enters the padded box; no hit on this face comes earlier."""


NOTHING = Candidates(
    ray=np.zeros(0, dtype=np.int64),
    face=np.zeros(0, dtype=np.int64),
    t=np.zeros(0),
    tolerance=np.zeros(0),
    kind=np.zeros(0, dtype=np.uint8),
    entry=np.zeros(0),
)


@dataclass(frozen=True, slots=True, eq=False)
class Beams(FrozenArrays):
    """Rays of pairs, as the formulas want them."""

    o: Doubles
    """(3, K) float64 origins."""

    d: Doubles
    """(3, K) float64 directions."""

    t_min: Doubles
    t_max: Doubles
    """(K,) float64 each."""


def answers(mesh: Mesh, rays: Rays, tree: Bvh, cut: Doubles | None = None) -> Answers:
    """Say what the rule of closest hits says of each ray.

    Args:
        mesh: The triangles.
        rays: The rays.
        tree: Any tree over the mesh; its boxes are not trusted, its order of the faces is used.
        cut: (R,) float64, a guess of the closest hit; saves time if it is a little too large
            and costs some if it is too small. The answers do not depend on it.
    """
    count = len(rays.t_min)
    found = candidates(mesh, rays, tree, cut)
    if cut is not None:
        again = np.flatnonzero(~(_limits(found, count) <= cut) & np.isfinite(cut))
        rest = candidates(mesh, chosen(rays, again), tree)
        kept = ~np.isin(found.ray, again)
        rest = replace(rest, ray=again[rest.ray])
        found = _joined([_taken(found, kept), rest])
    return nearest(found, count)


def candidates(mesh: Mesh, rays: Rays, tree: Bvh, cut: Doubles | None = None) -> Candidates:
    """List all that is not a MISS, also behind the closest hit.

    Args:
        mesh: The triangles.
        rays: The rays.
        tree: As for `answers`.
        cut: (R,) float64, candidates behind it need not be listed.
    """
    faces, count = len(mesh.faces), len(rays.t_min)
    if faces <= ALL_PAIRS:
        return classified(mesh, rays, all_pairs(faces, count))
    if cut is None:
        cut = np.full(count, np.inf)
    return classified(mesh, rays, culled_pairs(mesh, rays, tree, cut))


def nearest(found: Candidates, rays: int) -> Answers:
    """Keep what may be reported at or before the closest sure hit of each ray."""
    limit = _limits(found, rays)
    bound = limit[found.ray]
    decided = found.kind != WILD
    earliest = np.full(found.t.size, -np.inf)
    earliest[decided] = found.t[decided] - found.tolerance[decided]
    kept = np.flatnonzero((earliest <= bound) & (found.entry <= bound))
    first = np.zeros(rays + 1, dtype=np.int64)
    np.cumsum(np.bincount(found.ray[kept], minlength=rays), out=first[1:])
    return Answers(
        limit=limit,
        first=first,
        face=found.face[kept],
        t=found.t[kept],
        tolerance=found.tolerance[kept],
        kind=found.kind[kept],
    )


def chosen(rays: Rays, which: Integers | Mask) -> Rays:
    """Return some of the rays: (K,) int64, or (R,) bool where it is True."""
    return Rays(rays.origin[which], rays.direction[which], rays.t_min[which], rays.t_max[which])


def classified(mesh: Mesh, rays: Rays, pairs: Iterable[Pairs]) -> Candidates:
    """Apply the rule to pairs, chunk by chunk."""
    return _joined([NOTHING, *_classified(mesh, rays, pairs)])


def _taken(found: Candidates, which: Integers | Mask) -> Candidates:
    """Return some of the candidates."""
    return Candidates(*(getattr(found, field.name)[which] for field in fields(found)))


def _joined(parts: Sequence[Candidates]) -> Candidates:
    """Return the candidates of all parts, sorted by ray, then face."""
    both = Candidates(
        *(
            np.concatenate([getattr(part, field.name) for part in parts])
            for field in fields(Candidates)
        )
    )
    return _taken(both, np.lexsort((both.face, both.ray)))


def _limits(found: Candidates, rays: int) -> Doubles:
    """Return (R,) float64, each ray's smallest t + tolerance of a SOLID triangle."""
    limit = np.full(rays, np.inf)
    solid = found.kind == SOLID
    np.minimum.at(limit, found.ray[solid], found.t[solid] + found.tolerance[solid])
    return limit


def _classified(mesh: Mesh, rays: Rays, pairs: Iterable[Pairs]) -> Iterator[Candidates]:
    """Apply the rule to each chunk of pairs."""
    vertices = columns(mesh.vertices)
    largest = float(norm(vertices).max(initial=0.0))
    o, d = columns(rays.origin), columns(rays.direction)
    t_min, t_max = rays.t_min.astype(np.float64), rays.t_max.astype(np.float64)
    for ray, face in pairs:
        beams = Beams(o[:, ray], d[:, ray], t_min[ray], t_max[ray])
        corners = corners_of(vertices, mesh.faces[face])
        t, tolerance, kind, kept = _rule(beams, corners, largest)
        ray, face, kind = ray[kept], face[kept], kind[kept]
        entry, touched = _box_entry(beams, corners, kept, kind)
        yield Candidates(
            ray[touched],
            face[touched],
            t[kept][touched],
            tolerance[kept][touched],
            kind[touched],
            entry[touched],
        )


def _rule(
    beams: Beams, corners: Corners, largest: float
) -> tuple[Doubles, Doubles, Bytes, Integers]:
    """Return t, tolerance and kind of all pairs, and which of them are not a MISS.

    Args:
        beams: The rays of K pairs.
        corners: The corners of K triangles, (3, K) each.
        largest: Length of the mesh's longest vertex, max|v| of the rule.
    """
    a, b, c = corners
    e1, e2, e3 = b - a, c - a, c - b
    n = cross(e1, e2)
    to_plane = a - beams.o
    speed, span = norm(beams.d), norm(e1) * norm(e2)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        den = np.abs(dot(beams.d, n))
        t = dot(to_plane, n) / dot(beams.d, n)
        rel = TRIANGLE_ERROR * u * span * speed / den
        reach = norm(to_plane) + np.abs(t) * speed
        outermost = np.maximum(norm(a), np.maximum(norm(b), norm(c)))
        flat = PLANE_ERROR * norm(n) * (norm(beams.o) + outermost)
        tol = u * ((TRIANGLE_ERROR * span * reach + flat) / den + 2 * np.abs(t)) / (1 - rel)
        wild = ~(rel < EDGE_ON)
        inside = np.minimum(t - beams.t_min, beams.t_max - t)
        outer = tol * speed + 2 * u * (norm(beams.o) + np.abs(t) * speed + largest)
        margin, slack = _margins(beams.o + t * beams.d, corners, (e1, e2, e3), n)
        solid = (inside > tol) & (margin > outer + slack).all(axis=0)
        miss = ~((inside >= -tol) & (margin >= -(outer + slack)).all(axis=0))
    kind = np.where(wild, WILD, np.where(solid, SOLID, EDGE)).astype(np.uint8)
    return t, np.where(wild, np.inf, tol), kind, np.flatnonzero(wild | ~miss)


def _margins(
    p: Doubles, corners: Corners, edges: Corners, n: Doubles
) -> tuple[Doubles, Doubles]:
    """Return (3, K) signed in-plane distances to the edges, and (3, K) error 40u L^2/|e_k|."""
    a, b, c = corners
    e1, e2, e3 = edges
    size = norm(n)
    lengths = np.stack([norm(e1), norm(e3), norm(e2)])
    sides = ((e1, p - a), (e3, p - b), (-e2, p - c))
    distance = np.stack([dot(n, cross(edge, q)) for edge, q in sides]) / (size * lengths)
    return distance, EDGE_ERROR * u * lengths.max(axis=0) ** 2 / lengths


def _box_entry(
    beams: Beams, corners: Corners, kept: Integers, kind: Bytes
) -> tuple[Doubles, Mask]:
    """Return where rays enter the padded boxes of their triangles, and whether they do.

    A SOLID triangle is in its own box: minus infinity, True.
    """
    a, b, c = (corner[:, kept] for corner in corners)
    o, d = beams.o[:, kept], beams.d[:, kept]
    factor, size = edge_padding((a, b, c))
    factor = np.where(kind == WILD, WILD_PADDING * u, factor)
    pad = factor * (norm(o) + size)
    low, high = np.minimum(np.minimum(a, b), c) - pad, np.maximum(np.maximum(a, b), c) + pad
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = (low - o) / d, (high - o) / d
        slack = pad / norm(d)
    still = d == 0
    within = (low <= o) & (o <= high)
    near = np.where(still, np.where(within, -np.inf, np.inf), np.minimum(one, two)).max(axis=0)
    far = np.where(still, np.inf, np.maximum(one, two)).min(axis=0)
    near = np.maximum(near, beams.t_min[kept] - slack)
    touched = near <= np.minimum(far, beams.t_max[kept] + slack)
    solid = kind == SOLID
    return np.where(solid, -np.inf, near), touched | solid
