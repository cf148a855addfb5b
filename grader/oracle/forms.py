"""In which forms may a tree's empty slots come?"""

from dataclasses import replace

import numpy as np

from grader.model.mesh import Bvh

TRIMMED = ("terrain-600", "cloud-5", "soup-degenerate")
PADDED = ("cloud-1", "cloud-37", "parallel-quads")
"""Meshes whose trees come in the other form that the sheet allows for empty slots.

cloud-1: a single leaf, which some tell by the number of nodes. Not cloud-4: its tree is one
leaf of several faces, and some do with these otherwise if there is one node.
"""


def other_form(name: str, tree: Bvh) -> Bvh:
    """Return a tree with empty slots at the end left out, or with more of them."""
    used = int(np.flatnonzero(tree.end)[-1]) + 1
    if name in TRIMMED:
        return _resized(tree, used)
    if name in PADDED:
        return _resized(tree, (2 << used.bit_length()) - 1)
    return tree


def _resized(tree: Bvh, count: int) -> Bvh:
    """Return a tree of `count` nodes; new ones are `Node{}`."""
    kept = min(count, tree.end.size)
    more = count - kept
    corner = np.full((more, 3), np.inf, dtype=np.float32)
    none = np.zeros(more, dtype=np.uint32)
    return replace(
        tree,
        low=np.concatenate([tree.low[:kept], corner]),
        high=np.concatenate([tree.high[:kept], -corner]),
        begin=np.concatenate([tree.begin[:kept], none]),
        end=np.concatenate([tree.end[:kept], none]),
        node_count=count,
    )
