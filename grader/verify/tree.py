"""What does a tree consist of, and what do its nodes really hold?

Everything is computed for whole arrays of nodes. Minima and maxima are kept as minima only,
with maxima negated, so one `np.minimum` serves both. True spans go bottom-up from the leaves
wherever children partition their parent, and are taken from the faces themselves elsewhere.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.mesh import Bvh, Floats, FrozenArrays, Indices, Integers, Mask, Mesh
from grader.tolerances import FACES_PER_LEAF


@dataclass(frozen=True, slots=True, eq=False)
class Shape(FrozenArrays):
    """Which nodes a traversal can reach, and which of them have children."""

    reached: Integers
    """(K,) int64, nodes in reach of the root, ascending: level by level."""

    inner: Integers
    """(K,) int64, reached nodes with at least one used child."""

    leaves: Integers
    """(K,) int64, reached nodes without a used child."""

    parted: Mask
    """(N,) bool, True for inner nodes whose two children partition their range."""

    depth: int
    """Deepest level in reach; the root is level 0, and -1 says that there is no root."""


@lru_cache(maxsize=2)
def shape(bvh: Bvh) -> Shape:
    """Walk the tree level by level, as the sheet defines a leaf.

    A node is a leaf where both child indices lie outside the nodes or the child's `facesEnd`
    is 0. Source: exercise sheet, part b, "A node is a leaf node, if".
    """
    count = len(bvh.end)
    used = np.zeros(2 * count + 3, dtype=np.bool_)
    used[:count] = bvh.end != 0
    level = np.zeros(min(count, 1), dtype=np.int64)
    levels: list[Integers] = []
    while level.size:
        levels.append(level)
        children = np.stack([2 * level + 1, 2 * level + 2], axis=1).ravel()
        level = children[used[children]]
    reached = np.concatenate(levels) if levels else np.zeros(0, dtype=np.int64)
    has_child = used[2 * reached + 1] | used[2 * reached + 2]
    inner = reached[has_child]
    parted = np.zeros(count, dtype=np.bool_)
    parted[inner] = _partitions(bvh, inner, used)
    return Shape(reached, inner, reached[~has_child], parted, len(levels) - 1)


def _partitions(bvh: Bvh, inner: Integers, used: Mask) -> Mask:
    """(K,) bool, True where two non-empty, touching ranges make up the parent's range."""
    left, right = 2 * inner + 1, 2 * inner + 2
    both = used[left] & used[right]
    left, right = np.where(both, left, inner), np.where(both, right, inner)
    return np.asarray(
        both
        & (bvh.begin[left] == bvh.begin[inner])
        & (bvh.end[left] == bvh.begin[right])
        & (bvh.end[right] == bvh.end[inner])
        & (bvh.begin[left] < bvh.end[left])
        & (bvh.begin[right] < bvh.end[right])
    )


@dataclass(frozen=True, slots=True, eq=False)
class Spans(FrozenArrays):
    """What the faces of each reached node really span; rows of other nodes are infinite."""

    low: Floats
    """(N, 3) float32, smallest corner of the node's triangles."""

    high: Floats
    """(N, 3) float32."""

    centre_low: Floats
    """(N, 3) float32, smallest centre of the node's triangles on each axis."""

    centre_high: Floats
    """(N, 3) float32."""


@lru_cache(maxsize=2)
def spans(mesh: Mesh, bvh: Bvh) -> Spans:
    """Compute every reached node's true box and the box of its triangles' centres.

    The tree must be readable: ranges and face indices within the mesh.
    """
    form = shape(bvh)
    faces, order = _face_minima(mesh), bvh.order[: len(mesh.faces)]
    minima = np.full((len(bvh.end), 12), np.inf, dtype=np.float32)
    direct = form.reached[~form.parted[form.reached]]
    minima[direct] = _range_minima(faces, order, bvh.begin[direct], bvh.end[direct])
    parted = form.reached[form.parted[form.reached]]
    # Ascending indices are level by level, so going backwards meets children first.
    for level in range(form.depth - 1, -1, -1):
        first, past = np.searchsorted(parted, [2**level - 1, 2 ** (level + 1) - 1])
        nodes = parted[first:past]
        minima[nodes] = np.minimum(minima[2 * nodes + 1], minima[2 * nodes + 2])
    low, high, centre_low, centre_high = np.hsplit(minima, 4)
    return Spans(low, -high, centre_low, -centre_high)


def centres(mesh: Mesh) -> Floats:
    """(F, 3) float32, the centre of each triangle."""
    return _face_minima(mesh)[:, 6:9]


@lru_cache(maxsize=2)
def _face_minima(mesh: Mesh) -> Floats:
    """(F, 12) float32: low, -high, centre, -centre of each triangle."""
    a, b, c = (np.take(mesh.vertices, mesh.faces[:, corner], axis=0) for corner in range(3))
    minima = np.empty((len(mesh.faces), 12), dtype=np.float32)
    np.minimum(np.minimum(a, b), c, out=minima[:, 0:3])
    np.negative(np.maximum(np.maximum(a, b), c), out=minima[:, 3:6])
    centre = a.astype(np.float64)
    centre += b
    centre += c
    centre /= 3
    minima[:, 6:9] = centre
    np.negative(minima[:, 6:9], out=minima[:, 9:12])
    return minima


def _range_minima(faces: Floats, order: Indices, begin: Indices, end: Indices) -> Floats:
    """(K, 12) float32, minima over `order[begin[k]:end[k]]`; infinite for empty ranges."""
    result = np.full((len(begin), 12), np.inf, dtype=np.float32)
    held = end.astype(np.int64) - begin
    small = np.flatnonzero((held > 0) & (held <= FACES_PER_LEAF))
    if small.size:
        first, last = begin[small].astype(np.int64), end[small].astype(np.int64) - 1
        # Taking the last face again where there are fewer changes no minimum.
        takes = (np.minimum(first + k, last) for k in range(FACES_PER_LEAF))
        one, two, three, four = (np.take(faces, order[place], axis=0) for place in takes)
        result[small] = np.minimum(np.minimum(one, two), np.minimum(three, four))
    large = np.flatnonzero(held > FACES_PER_LEAF)
    if large.size:
        rows = np.take(faces, order, axis=0)
        result[large] = _windowed(rows, begin[large].astype(np.int64), held[large])
    return result


def _windowed(rows: Floats, begin: Integers, held: Integers) -> Floats:
    """(K, 12) float32, minima over `rows[begin[k]:begin[k] + held[k]]`, none of them empty.

    Two overlapping windows of 2^p rows cover each range. Every width of a window is computed
    once, so a tree whose nodes all claim all faces takes no longer to read than a right one.
    """
    result = np.empty((len(begin), 12), dtype=np.float32)
    power = np.frexp(held.astype(np.float64))[1] - 1
    for p in range(int(power.max()) + 1):
        if p:
            half = 2 ** (p - 1)
            rows = np.minimum(rows[:-half], rows[half:])
        chosen = np.flatnonzero(power == p)
        first, last = begin[chosen], begin[chosen] + held[chosen] - 2**p
        result[chosen] = np.minimum(rows[first], rows[last])
    return result
