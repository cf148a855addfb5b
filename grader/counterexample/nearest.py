"""Which right tree is nearest to a submission's? The one that goes with it as far as it may.

Where a split is legal, nothing is held against it: which half gets the odd face, and how equal
centres are ordered, is free. So what differs from this tree is wrong.
"""

from collections.abc import Iterator

import numpy as np

from grader.model.mesh import Bvh, Integers, Mesh
from grader.tolerances import FACES_PER_LEAF
from grader.verify.halves import splits
from grader.verify.structure import unreadable
from grader.verify.tree import centres, on_any_axis

Node = tuple[int, int, int]
"""Number, begin and end."""


def nearest_tree(mesh: Mesh, tree: Bvh) -> Bvh:
    """Build a right tree of a small mesh, with the splits of another one that are legal.

    Args:
        mesh: Of so few faces that no depth limit is near.
        tree: What a submission made of it: anything.
    """
    faces = len(mesh.faces)
    legal = _legal_splits(mesh, tree)
    order = tree.order.astype(np.int64) if legal is not None else np.arange(faces)
    nodes = list(_built(mesh, tree, order, legal or set()))
    count = max((node for node, _, _ in nodes), default=-1) + 1
    low, high = np.zeros((2, count, 3), np.float32)
    begin, end = np.zeros((2, count), np.uint32)
    for node, first, past in nodes:
        corners = mesh.vertices[mesh.faces[order[first:past]]].reshape(-1, 3)
        if corners.size:
            low[node], high[node] = corners.min(axis=0), corners.max(axis=0)
        begin[node], end[node] = first, past
    return Bvh(low, high, begin, end, order.astype(np.uint32), count)


def _legal_splits(mesh: Mesh, tree: Bvh) -> set[int] | None:
    """Find the nodes that are divided as they may be; None if the tree holds other faces."""
    faces = np.arange(len(mesh.faces))
    if unreadable(mesh, tree) is not None or not np.array_equal(np.sort(tree.order), faces):
        return None
    found = splits(mesh, tree)
    end, begin = tree.end.astype(np.int64), tree.begin.astype(np.int64)
    left, right = 2 * found.node + 1, 2 * found.node + 2
    is_even = np.abs(end[left] - begin[left] - end[right] + begin[right]) <= 1
    return set(found.node[is_even & on_any_axis(found.ordered & found.longest)].tolist())


def _built(mesh: Mesh, tree: Bvh, order: Integers, legal: set[int]) -> Iterator[Node]:
    """Divide all nodes, and order the faces where the submission's order cannot stay."""
    centre = centres(mesh)
    # Below a node that is divided anew, what the submission did is of other faces.
    waiting = [(0, 0, len(mesh.faces), bool(legal) and _holds_all(mesh, tree))]
    while waiting:
        node, begin, end, goes_along = waiting.pop(0)
        yield node, begin, end
        if end - begin <= FACES_PER_LEAF:
            continue
        goes_along = goes_along and node in legal
        if goes_along:
            middle = int(tree.end[2 * node + 1])
        else:
            held = order[begin:end]
            corners = mesh.vertices[mesh.faces[held]].reshape(-1, 3)
            axis = int(np.argmax(np.ptp(corners, axis=0)))
            order[begin:end] = held[np.argsort(centre[held, axis], kind="stable")]
            middle = begin + (end - begin) // 2
        waiting.append((2 * node + 1, begin, middle, goes_along))
        waiting.append((2 * node + 2, middle, end, goes_along))


def _holds_all(mesh: Mesh, tree: Bvh) -> bool:
    """Tell whether the root's range is the whole mesh."""
    return (int(tree.begin[0]), int(tree.end[0])) == (0, len(mesh.faces))
