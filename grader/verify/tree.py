"""What does a tree consist of, and what do its nodes really hold?

Everything is computed for whole arrays of nodes. Minima and maxima are kept as minima only,
with maxima negated, so one `np.minimum` serves both. True spans go bottom-up from the leaves
wherever children partition their parent, and are taken from the faces themselves elsewhere.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grader.model.mesh import Bvh, Floats, FrozenArrays, Integers, Mask, Mesh
from grader.tolerances import FACES_PER_LEAF

BLOCK = 16384

LARGE = 100_000
"""Faces of a mesh whose table is kept."""


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
        first, past = 2 * int(level[0]) + 1, 2 * int(level[-1]) + 3
        if past - first == 2 * level.size:
            # No node is left out, as in most levels of a right tree.
            level = first + np.flatnonzero(used[first:past])
        else:
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
    """What the faces of each reached node really span; rows of other nodes are infinite.

    Column by column in memory, so `low[:, axis]` is read several times as fast as a row.
    """

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
    minima = np.full((12, len(bvh.end)), np.inf, dtype=np.float32)
    direct = form.reached[~form.parted[form.reached]]
    held = bvh.end[direct].astype(np.int64) - bvh.begin[direct]
    table = face_minima(mesh)
    _from_few(minima, table, bvh, direct[(held > 0) & (held <= FACES_PER_LEAF)])
    _from_many(minima, table, bvh, direct[held > FACES_PER_LEAF])
    _join(minima, form.reached[form.parted[form.reached]], form.depth)
    np.negative(minima[3:6], out=minima[3:6])
    np.negative(minima[9:12], out=minima[9:12])
    low, high, centre_low, centre_high = (part.T for part in np.vsplit(minima, 4))
    return Spans(low, high, centre_low, centre_high)


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


def centres(mesh: Mesh) -> Floats:
    """(F, 3) float32, the centre of each triangle."""
    return face_minima(mesh)[:, 6:9]


def on_any_axis(mask: Mask) -> Mask:
    """(K,) bool, `mask.any(axis=1)` of (K, 3) bool, ten times as fast."""
    return np.asarray(mask[:, 0] | mask[:, 1] | mask[:, 2])


def face_minima(mesh: Mesh) -> Floats:
    """(F, 12) float32: low, -high, centre, -centre of each triangle.

    A row lies in one place, since a tree names faces in an order of its own. Who grades many
    submissions has the tables of large meshes at hand: they take longer than all the rest.
    """
    return _kept_minima(mesh) if len(mesh.faces) >= LARGE else _face_minima(mesh)


@lru_cache(maxsize=4)
def _kept_minima(mesh: Mesh) -> Floats:
    return _face_minima(mesh)


def _face_minima(mesh: Mesh) -> Floats:
    columns = np.ascontiguousarray(mesh.vertices.T)
    minima = np.empty((len(mesh.faces), 12), dtype=np.float32)
    # Each axis has a row of its own: whole rows are computed several times as fast as triples.
    rows = np.empty((12, BLOCK), dtype=np.float32)
    for block in _blocks(len(minima)):
        corners = mesh.faces[block].T.astype(np.int64, order="C")
        some = rows[:, : corners.shape[1]]
        for axis, column in enumerate(columns):
            a, b, c = column.take(corners)
            np.minimum(np.minimum(a, b), c, out=some[axis])
            np.negative(np.maximum(np.maximum(a, b), c), out=some[3 + axis])
            centre = a.astype(np.float64)
            centre += b
            centre += c
            centre /= 3
            some[6 + axis] = centre
            np.negative(some[6 + axis], out=some[9 + axis])
        minima[block] = some.T
    return minima


def _blocks(count: int) -> Iterator[slice]:
    """Divide a range, so that what is computed on the way stays in the processor's cache."""
    return (slice(first, first + BLOCK) for first in range(0, count, BLOCK))


def _from_few(minima: Floats, table: Floats, bvh: Bvh, nodes: Integers) -> None:
    """Fill in the minima of nodes that hold at most as many faces as a leaf, and not none."""
    for block in _blocks(nodes.size):
        some = nodes[block]
        first, last = bvh.begin[some].astype(np.int64), bvh.end[some].astype(np.int64) - 1
        # Taking the last face again where there are fewer changes no minimum.
        places = (np.minimum(first + k, last) for k in range(FACES_PER_LEAF))
        one, two, three, four = (table.take(bvh.order[each], axis=0) for each in places)
        np.minimum(one, two, out=one)
        np.minimum(three, four, out=three)
        minima[:, _run(some)] = np.minimum(one, three, out=one).T


def _run(nodes: Integers) -> Integers | slice:
    """Return ascending nodes as a slice if they leave none out: that is copied much faster."""
    first, past = int(nodes[0]), int(nodes[-1]) + 1
    return slice(first, past) if past - first == nodes.size else nodes


def _from_many(minima: Floats, table: Floats, bvh: Bvh, nodes: Integers) -> None:
    """Fill in the minima of nodes with more faces than a leaf, of which no two make up one.

    Two overlapping windows of 2^p faces cover each range. Every width of a window is computed
    once, so a tree whose nodes all claim all faces takes no longer to read than a right one.
    """
    if not nodes.size:
        return
    faces = np.ascontiguousarray(table.take(bvh.order[: len(table)], axis=0).T)
    begin = bvh.begin[nodes].astype(np.int64)
    held = bvh.end[nodes] - begin
    power = np.frexp(held.astype(np.float64))[1] - 1
    for p in range(int(power.max()) + 1):
        if p:
            half = 2 ** (p - 1)
            faces = np.minimum(faces[:, :-half], faces[:, half:])
        chosen = np.flatnonzero(power == p)
        first, last = begin[chosen], begin[chosen] + held[chosen] - 2**p
        minima[:, nodes[chosen]] = np.minimum(faces[:, first], faces[:, last])
