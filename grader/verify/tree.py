"""What does a tree consist of, and what do its nodes really hold?

Everything is computed for whole arrays of nodes. Minima and maxima are kept as minima only,
with maxima negated, so one `np.minimum` serves both. True spans go bottom-up from the leaves
wherever children partition their parent, and are taken from the faces themselves elsewhere.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.mesh import Bvh, Floats, FrozenArrays, Indices, Integers, Mask, Mesh
from grader.tolerances import FACES_PER_LEAF

BLOCK = 16384


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
    faces = _face_minima(mesh, bvh.order[: len(mesh.faces)])
    minima = np.full((12, len(bvh.end)), np.inf, dtype=np.float32)
    direct = form.reached[~form.parted[form.reached]]
    begin, end = bvh.begin[direct].astype(np.int64), bvh.end[direct].astype(np.int64)
    for row, each in zip(minima, _range_minima(faces, begin, end), strict=True):
        row[direct] = each
    _join(minima, form.reached[form.parted[form.reached]], form.depth)
    parts = (np.ascontiguousarray(part.T) for part in np.vsplit(minima, 4))
    low, high, centre_low, centre_high = parts
    return Spans(low, -high, centre_low, -centre_high)


def _join(minima: Floats, parted: Integers, depth: int) -> None:
    """Fill in the minima of nodes that their children partition, from the deepest level up."""
    for level in range(depth - 1, -1, -1):
        # Ascending indices are level by level.
        begin, end = 2**level - 1, 2 ** (level + 1) - 1
        first, past = np.searchsorted(parted, [begin, end])
        nodes = parted[first:past]
        if nodes.size == end - begin:
            # As slices, which are ten times as fast: most levels of a right tree are full.
            left, right = (minima[:, 2 * begin + k : 2 * end + k : 2] for k in (1, 2))
            np.minimum(left, right, out=minima[:, begin:end])
        else:
            minima[:, nodes] = np.minimum(minima[:, 2 * nodes + 1], minima[:, 2 * nodes + 2])


@lru_cache(maxsize=2)
def centres(mesh: Mesh) -> Floats:
    """(F, 3) float32, the centre of each triangle."""
    every = np.arange(len(mesh.faces), dtype=np.uint32)
    return np.ascontiguousarray(_face_minima(mesh, every)[6:9].T)


def on_any_axis(mask: Mask) -> Mask:
    """(K,) bool, `mask.any(axis=1)` of (K, 3) bool, ten times as fast."""
    return np.asarray(mask[:, 0] | mask[:, 1] | mask[:, 2])


def _face_minima(mesh: Mesh, order: Indices) -> Floats:
    """(12, K) float32: low, -high, centre, -centre of the triangles that `order` names.

    Each axis has a row of its own: whole rows are computed several times as fast as triples.
    """
    columns = np.ascontiguousarray(mesh.vertices.T)
    minima = np.empty((12, len(order)), dtype=np.float32)
    for block in _blocks(len(order)):
        corners = mesh.faces.take(order[block], axis=0).T.astype(np.int64, order="C")
        for axis, column in enumerate(columns):
            a, b, c = column.take(corners)
            np.minimum(np.minimum(a, b), c, out=minima[axis, block])
            np.negative(np.maximum(np.maximum(a, b), c), out=minima[3 + axis, block])
            centre = a.astype(np.float64)
            centre += b
            centre += c
            centre /= 3
            minima[6 + axis, block] = centre
            np.negative(minima[6 + axis, block], out=minima[9 + axis, block])
    return minima


def _blocks(count: int) -> Iterator[slice]:
    """Divide a range, so that what is computed on the way stays in the processor's cache."""
    return (slice(first, first + BLOCK) for first in range(0, count, BLOCK))


def _range_minima(faces: Floats, begin: Integers, end: Integers) -> Floats:
    """(12, K) float32, minima over `faces[:, begin[k]:end[k]]`; infinite for empty ranges."""
    result = np.full((12, len(begin)), np.inf, dtype=np.float32)
    held = end - begin
    small = np.flatnonzero((held > 0) & (held <= FACES_PER_LEAF))
    for block in _blocks(small.size):
        nodes = small[block]
        first, last = begin[nodes], end[nodes] - 1
        # Taking the last face again where there are fewer changes no minimum.
        places = (np.minimum(first + k, last) for k in range(FACES_PER_LEAF))
        one, two, three, four = (faces[:, place] for place in places)
        result[:, nodes] = np.minimum(np.minimum(one, two), np.minimum(three, four))
    large = np.flatnonzero(held > FACES_PER_LEAF)
    if large.size:
        result[:, large] = _windowed(faces, begin[large], held[large])
    return result


def _windowed(faces: Floats, begin: Integers, held: Integers) -> Floats:
    """(12, K) float32, minima over `faces[:, begin[k]:begin[k] + held[k]]`, none of them empty.

    Two overlapping windows of 2^p faces cover each range. Every width of a window is computed
    once, so a tree whose nodes all claim all faces takes no longer to read than a right one.
    """
    result = np.empty((12, len(begin)), dtype=np.float32)
    power = np.frexp(held.astype(np.float64))[1] - 1
    for p in range(int(power.max()) + 1):
        if p:
            half = 2 ** (p - 1)
            faces = np.minimum(faces[:, :-half], faces[:, half:])
        chosen = np.flatnonzero(power == p)
        first, last = begin[chosen], begin[chosen] + held[chosen] - 2**p
        result[:, chosen] = np.minimum(faces[:, first], faces[:, last])
    return result
