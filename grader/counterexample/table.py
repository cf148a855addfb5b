"""How does a small tree look as the sheet draws one: nodes above, face indices below?"""

from collections.abc import Iterable

import numpy as np

from grader.counterexample.explain import Setting
from grader.model.counterexample import Column, NodeTable
from grader.model.mesh import Bvh, Mask, Rays
from grader.oracle.costs import given_box_test

MOST_FACES = 9
"""The sheet's figure has as many; larger tables teach less."""

MOST_NODES = 31
NONE = "-"


def tree_table(expected: Bvh, got: Bvh) -> NodeTable:
    """Hold a submission's tree against one right tree of the same mesh."""
    columns = tuple(
        Column(node, range_of(expected, node), range_of(got, node))
        for node in range(MOST_NODES)
        if is_used(expected, node) or is_used(got, node)
    )
    first = first_difference(expected, got, [column.node for column in columns])
    return NodeTable(columns, order_of(expected), order_of(got), first)


def path_table(setting: Setting, rays: Rays, lost_at: int) -> NodeTable:
    """Hold what a ray's box tests said against what a plain traversal would see."""
    tree, nodes = setting.tree, setting.nodes()
    used = np.array([node for node in range(MOST_NODES) if is_used(tree, node)], np.int64)
    touched = given_box_test(tree, rays)(np.zeros_like(used), used)
    columns = tuple(
        Column(int(node), "hit" if hit else "miss", _said(setting.path.hit[nodes == node]))
        for node, hit in zip(used, touched, strict=True)
    )
    marked = [place for place, one in enumerate(columns) if one.node == lost_at]
    return NodeTable(columns, order_of(tree), "", marked[0] if marked else -1)


def _said(answers: Mask) -> str:
    if not answers.size:
        return NONE
    return "hit" if answers.any() else "miss"


def is_used(tree: Bvh, node: int) -> bool:
    """Tell whether a node is there and is no empty slot."""
    return node < len(tree.end) and bool(tree.end[node])


def range_of(tree: Bvh, node: int) -> str:
    """Write a node's range."""
    return f"[{tree.begin[node]},{tree.end[node]})" if is_used(tree, node) else NONE


def order_of(tree: Bvh) -> str:
    """Write the face indices, with a stroke where a leaf begins."""
    begins = {
        int(tree.begin[node])
        for node in range(min(len(tree.end), MOST_NODES))
        if is_used(tree, node)
    }
    words = []
    for place, face in enumerate(tree.order[: MOST_FACES + 1].tolist()):
        words += ["|"] * (place > 0 and place in begins) + [str(face)]
    return " ".join(words)


def first_difference(expected: Bvh, got: Bvh, nodes: Iterable[int]) -> int:
    """Return the place of the first node that is not the same in both; -1 if all are."""
    for place, node in enumerate(nodes):
        if _differs(expected, got, node):
            return place
    return -1


def _differs(one: Bvh, other: Bvh, node: int) -> bool:
    """Compare a node's range, box and set of faces."""
    if range_of(one, node) != range_of(other, node):
        return True
    if not is_used(one, node):
        return False
    boxes = (one.low[node] != other.low[node]) | (one.high[node] != other.high[node])
    mine, yours = (
        sorted(tree.order[tree.begin[node] : tree.end[node]].tolist()) for tree in (one, other)
    )
    return bool(boxes.any()) or mine != yours
