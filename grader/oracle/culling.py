"""Which (ray, face) pairs does the rule of closest hits have to look at?

Theory of operation. The tree serves only as an order of the faces: boxes are computed here, as
unions of face boxes that are padded by more than the rule can ask for, and tested in float32.
A box is kept as centre and half extent, and a direction's zeros are replaced by something tiny,
so that no infinity and no NaN appears. A tree whose boxes are wrong cannot lose a candidate;
a tree whose `order` misses a face would, and is refused.
"""

from collections.abc import Iterator

import numpy as np

from grader.errors import OracleFault
from grader.model.mesh import Bvh, Doubles, Floats, Integers, Mask, Mesh, Rays
from grader.oracle.hierarchy import Touches, leaves_of, spread, traverse
from grader.oracle.padding import columns, corners_of, edge_padding, norm
from grader.tolerances import EDGE_PADDING, NEEDLE, UNIT_ROUNDOFF

ALL_PAIRS = 16
"""Meshes of at most so many faces are tested face by face."""

CHUNK = 1 << 13
"""Pairs that are handed out together: so few that what the rule works out of them stays in the
processor's cache."""

EXTRA = 1.25
"""Boxes are padded by so much more than the rule's own box test, for float32's sake."""

TINY, TINIEST = 1e-30, 1e-32
"""What a zero of a unit direction becomes: 30 orders of magnitude below any margin. It becomes
the second number at least, whose inverse is a float32: 20 orders below a length of 1e-12.
"""

WIDEST = EXTRA * EDGE_PADDING * UNIT_ROUNDOFF * NEEDLE
"""The padding of the flattest face that can be an EDGE."""

Pairs = tuple[Integers, Integers]
"""(K,) ray indices and (K,) face indices."""


def all_pairs(faces: int, rays: int) -> Iterator[Pairs]:
    """Hand out every pair, ray by ray."""
    step = max(1, CHUNK // max(1, faces))
    for start in range(0, rays if faces else 0, step):
        ray = np.arange(start, min(start + step, rays))
        yield np.repeat(ray, faces), np.tile(np.arange(faces), ray.size)


def culled_pairs(mesh: Mesh, rays: Rays, tree: Bvh, cut: Doubles) -> Iterator[Pairs]:
    """Hand out every pair that can be a candidate at or before `cut`, and some more.

    Args:
        mesh: The triangles.
        rays: The rays.
        tree: Ranges and order of a tree over the mesh; its boxes are not used.
        cut: (R,) float64, beyond which no candidate of the ray is of interest.

    Raises:
        OracleFault: The leaves of the tree do not hold every face once.
    """
    leaf = leaves_of(tree)
    reach = float(norm(columns(rays.origin)).max(initial=0.0))
    touches = _slab_test(_boxes(mesh, tree, leaf, reach), rays, cut)
    begin, end = tree.begin.astype(np.int64), tree.end.astype(np.int64)
    for visits in traverse(leaf, len(rays.t_min), touches):
        first, last = begin[visits.leaf], end[visits.leaf]
        chunk = np.cumsum(last - first) // CHUNK
        for part in np.split(np.arange(chunk.size), np.flatnonzero(np.diff(chunk)) + 1):
            ray, place = spread(visits.ray[part], first[part], last[part])
            yield ray, tree.order[place].astype(np.int64)


def _boxes(mesh: Mesh, tree: Bvh, leaf: Mask, reach: float) -> tuple[Floats, Floats]:
    """Return centres and half extents of all nodes, (M, 3) float32 each, padded.

    Args:
        mesh: The triangles.
        tree: Ranges and order.
        leaf: (N,) bool, True where a node has no children.
        reach: Largest distance of a ray's origin from the world's origin.
    """
    table = _leaf_boxes(_face_boxes(mesh, reach), tree, leaf)
    first = table.shape[0] // 2
    while first:
        children = table[first : 2 * first + 1]
        first = (first - 1) // 2
        parents = table[first : 2 * first + 1]
        np.minimum(parents, np.minimum(children[0::2], children[1::2]), out=parents)
    low, high = table[:, :3], -table[:, 3:]
    empty = low > high
    with np.errstate(invalid="ignore"):
        centre = np.where(empty, 0.0, (low + high) / 2)
        half = np.where(empty, -np.inf, (high - low) / 2)
    return centre.astype(np.float32), half.astype(np.float32)


def _face_boxes(mesh: Mesh, reach: float) -> Doubles:
    """Return (F, 6) float64, minimum and negated maximum of each padded face.

    One minimum serves both: -max(x) is min(-x).
    """
    corners = corners_of(columns(mesh.vertices), mesh.faces)
    a, b, c = corners
    factor, size = edge_padding(corners)
    pad = EXTRA * factor * (reach + size)
    low = np.minimum(np.minimum(a, b), c) - pad
    high = np.maximum(np.maximum(a, b), c) + pad
    return np.ascontiguousarray(np.concatenate([low, -high]).T)


def _leaf_boxes(face_boxes: Doubles, tree: Bvh, leaf: Mask) -> Doubles:
    """Return (M, 6) float64: the unions of the leaves' faces; infinity elsewhere.

    Raises:
        OracleFault: The leaves do not hold every face once.
    """
    faces = len(face_boxes)
    node = np.flatnonzero(leaf & (tree.end > tree.begin))
    node = node[np.argsort(tree.begin[node], kind="stable")]
    begin, end = tree.begin[node].astype(np.int64), tree.end[node].astype(np.int64)
    covered = np.array_equal(begin, np.concatenate([[0], end])[: node.size])
    whole = tree.order.size == faces and (end.size == 0 or end[-1] == faces)
    if not (covered and whole and np.bincount(tree.order, minlength=faces).max(initial=1) == 1):
        raise OracleFault(
            f"a reference tree over {faces} faces does not hold every face in one leaf; "
            "its answers cannot be trusted, check the reference solution"
        )
    full = (1 << max(1, int(leaf.size).bit_length())) - 1
    table = np.full((full, 6), np.inf)
    if node.size:
        table[node] = np.minimum.reduceat(face_boxes[tree.order], begin, axis=0)
    return table


def _slab_test(boxes: tuple[Floats, Floats], rays: Rays, until: Doubles) -> Touches:
    """Return a box test in float32 that is true too often rather than too seldom."""
    centre, half = boxes
    origin = rays.origin
    direction = rays.direction.astype(np.float64)
    speed = np.sqrt((direction * direction).sum(axis=1, keepdims=True))
    tiny = np.copysign(np.maximum(TINY * speed, TINIEST), direction)
    moving = np.where(np.abs(direction) < np.abs(tiny), tiny, direction)
    inverse = (1 / moving).astype(np.float32)
    backward = np.abs(inverse)
    # Interval ends give way by more than any face's own padding does.
    size = np.abs(centre[:1]) + np.abs(half[:1])
    size = np.where(np.isfinite(size), size, 0).sum()
    slack = WIDEST * (np.sqrt((origin.astype(np.float64) ** 2).sum(axis=1)) + 4 * size)
    slack /= speed[:, 0]
    since = (rays.t_min - slack).astype(np.float32)
    until = (np.minimum(rays.t_max, until) + slack).astype(np.float32)

    def touches(ray: Integers, node: Integers) -> Mask:
        middle = centre.take(node, axis=0) - origin.take(ray, axis=0)
        middle *= inverse.take(ray, axis=0)
        reach = half.take(node, axis=0) * backward.take(ray, axis=0)
        near, far = middle - reach, middle + reach
        latest = np.maximum(np.maximum(near[:, 0], near[:, 1]), near[:, 2])
        soonest = np.minimum(np.minimum(far[:, 0], far[:, 1]), far[:, 2])
        hit: Mask = np.maximum(latest, since[ray]) <= np.minimum(soonest, until[ray])
        return hit

    return touches
