"""Along which axis is a node divided, where its faces may be in the wrong order?

A split between a few faces proves little: whoever orders them wrongly along the right axis
divides them, by chance, exactly along another one. So a wrong axis is only named where chance
and a slip in the order are no explanation; what is wrong with the order, another check says.
"""

from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, FrozenArrays, Integers, Mask, Mesh
from grader.verify.halves import Splits
from grader.verify.tree import centres, on_any_axis

EVIDENCE = 16
"""Faces in two equal halves that are hardly ever ordered by chance: once in 12,870 times."""

TELLING = 2 * EVIDENCE
"""Faces in two equal halves that are hardly ever nearly ordered by chance: 2 in 100,000."""

MOST = 256
"""Nodes of a tree, the largest ones, in which faces on the wrong side are counted."""

MOST_SHARE = 21
"""So many times the mesh's faces they hold together: all levels of a right tree hold no more.
Where nodes that share their faces hold more, the others are not looked into."""

_NEAR, _FAR = 8, 4
"""Up to every eighth face of a half on the wrong side is a slip; from every fourth on, the
faces are not ordered along that axis at all: where nothing is ordered, every second one is."""


@dataclass(frozen=True, slots=True, eq=False)
class Judged(FrozenArrays):
    """Which splits tell their axis."""

    right: Mask
    """(K,) bool, True where a longest axis explains the split."""

    wrong: Mask
    """(K,) bool, True where another axis does, and no longest one nearly so."""


def judge(mesh: Mesh, bvh: Bvh, found: Splits) -> Judged:
    """Judge every split of a readable tree."""
    explained = on_any_axis(found.ordered & found.longest)
    wrong = np.zeros(len(found.node), np.bool_)
    if explained.all():
        return Judged(explained, wrong)
    if not on_any_axis(found.ordered & ~found.flat).all():
        return _judge_large(mesh, bvh, found)
    weight = _weight(bvh, found)
    some = np.flatnonzero(~explained)
    wrong[some] = True
    some = some[: _most(mesh, bvh, found.node[some])]
    off = _off(mesh, bvh, found.node[some])
    wrong[some] = _far(off, weight[some], found.longest[some])
    return Judged(explained, np.asarray(wrong & (weight[wrong].sum() >= EVIDENCE)))


def _judge_large(mesh: Mesh, bvh: Bvh, found: Splits) -> Judged:
    """Judge the largest splits where some have no order, and only if at least half of them do.

    On an axis on which all centres agree, every order is one: such a split is like one without.
    """
    weight = _weight(bvh, found)
    some = np.flatnonzero(weight >= TELLING)
    some = some[: _most(mesh, bvh, found.node[some])]
    weight, longest = weight[some], found.longest[some]
    off = _off(mesh, bvh, found.node[some])
    near = found.ordered[some] | (off <= (weight // 2 // _NEAR)[:, None])
    right, wrong = np.zeros((2, len(found.node)), np.bool_)
    right[some] = (near & longest).any(axis=1)
    wrong[some] = near.any(axis=1) & _far(off, weight, longest)
    enough = 2 * (right | wrong).sum() >= some.size
    return Judged(np.asarray(right & enough), np.asarray(wrong & enough))


def tells(bvh: Bvh, found: Splits) -> bool:
    """Whether some node has enough faces to show an axis even if their order is not right."""
    return bool((_weight(bvh, found) >= TELLING).any())


def _weight(bvh: Bvh, found: Splits) -> Integers:
    """(K,) int64, twice the faces of the smaller half."""
    left, right = 2 * found.node + 1, 2 * found.node + 2
    held = bvh.end.astype(np.int64) - bvh.begin
    return np.asarray(2 * np.minimum(held[left], held[right]))


def _most(mesh: Mesh, bvh: Bvh, node: Integers) -> int:
    """Tell how many nodes, (K,) int64, are looked into: the first ones."""
    held = (bvh.end[node[:MOST]].astype(np.int64) - bvh.begin[node[:MOST]]).cumsum()
    return int(np.searchsorted(held, MOST_SHARE * len(mesh.faces), side="right"))


def _far(off: Integers, weight: Integers, longest: Mask) -> Mask:
    """(K,) bool, True where no longest axis nearly explains the split."""
    return np.asarray((~longest | (off > (weight // 2 // _FAR)[:, None])).all(axis=1))


def _off(mesh: Mesh, bvh: Bvh, node: Integers) -> Integers:
    """(K, 3) int64, how many faces of the smaller half are on the wrong side, per axis.

    Whether the smaller centres are on the left or on the right does not matter here.
    """
    off = np.zeros((len(node), 3), np.int64)
    centre = centres(mesh)
    for k, each in enumerate(node):
        begin, end = int(bvh.begin[each]), int(bvh.end[each])
        held = centre[bvh.order[begin:end]]
        left = int(bvh.end[2 * each + 1]) - begin
        last = np.partition(held, left - 1, axis=0)[left - 1]
        moved = (held[:left] > last).sum(axis=0)
        off[k] = np.minimum(moved, np.abs(min(left, end - begin - left) - moved))
    return off
