"""The exercise's own triangle test in float32 on arrays: what a right solution returns."""

import numpy as np

from grader.model.mesh import Bvh, Floats, Hits, Indices, Mesh, Rays
from grader.oracle.culling import culled_pairs


def cross(a: Floats, b: Floats) -> Floats:
    """Return (K, 3) cross products in float32."""
    x = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    y = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    z = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.stack([x, y, z], axis=1)


def dot(a: Floats, b: Floats) -> Floats:
    """Return (K,) dot products in float32."""
    product: Floats = a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2]
    return product


def plane_test(rays: Rays, corners: Floats) -> tuple[Floats, Floats, Floats]:
    """Return point, t and normal of K pairs; t is infinite for a miss."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    n = cross(b - a, c - a)
    o, d = rays.origin, rays.direction
    with np.errstate(all="ignore"):
        t = dot(a - o, n) / dot(d, n)
        inside = (rays.t_min < t) & (t < rays.t_max)
        p = o + d * t[:, None]
        for edge, foot in ((b - a, a), (c - b, b), (a - c, c)):
            inside &= dot(n, cross(edge, p - foot)) >= 0
        normal = (n / np.sqrt(dot(n, n))[:, None]).astype(np.float32)
    point: Floats = p
    kept: Floats = np.where(inside, t, np.float32(np.inf)).astype(np.float32)
    return point, kept, normal


def trace(mesh: Mesh, rays: Rays, tree: Bvh) -> Hits:
    """Return the closest hit of each ray."""
    hits, _ = trace_all(mesh, rays, tree)
    return hits


def trace_all(mesh: Mesh, rays: Rays, tree: Bvh) -> tuple[Hits, Floats]:
    """Return the closest hit of each ray, and (R,) float32 t of the second closest."""
    count = len(rays.t_min)
    point = np.zeros((count, 3), dtype=np.float32)
    normal = np.zeros((count, 3), dtype=np.float32)
    t, second = (np.full(count, np.inf, dtype=np.float32) for _ in range(2))
    faces: Indices = mesh.faces
    for ray, face in culled_pairs(mesh, rays, tree, np.full(count, np.inf)):
        part = Rays(rays.origin[ray], rays.direction[ray], rays.t_min[ray], rays.t_max[ray])
        p, found, n = plane_test(part, mesh.vertices[faces[face]])
        order = np.argsort(-found, kind="stable")
        order = order[np.isfinite(found[order])]
        for k in order:
            r = ray[k]
            if found[k] < t[r]:
                second[r] = t[r]
                t[r], point[r], normal[r] = found[k], p[k], n[k]
            elif t[r] < found[k] < second[r]:
                second[r] = found[k]
    return Hits(point, t, normal), second
