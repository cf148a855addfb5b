"""Which boxes of a tree are shown? The nodes of a level stand in a row, level by level."""

import numpy as np

from grader.model.mesh import Bvh, Floats

DEEPEST = 15
"""Of 65,535 boxes nobody tells one from another."""

MOST_BOXES = 2 ** (DEEPEST + 1) - 1


def corners_of(tree: Bvh) -> Floats:
    """Return (K, 6) float32, lower and upper corners of the first nodes; NaN in empty slots."""
    count = min(len(tree.end), MOST_BOXES)
    corners = np.concatenate([tree.low[:count], tree.high[:count]], axis=1).astype(np.float32)
    bad = (tree.end[:count] == 0) | ~np.isfinite(corners).all(axis=1)
    corners[bad] = np.nan
    return np.ascontiguousarray(corners)


def deepest_of(tree: Bvh | None) -> int:
    """Return the last level that can be shown; -1 if there is no tree."""
    if tree is None or not len(tree.end):
        return -1
    used = np.flatnonzero(tree.end[:MOST_BOXES])
    return int(np.log2(int(used[-1]) + 1)) if used.size else -1


def count_of(nodes: int, level: int, only: bool) -> tuple[int, int]:
    """Return the first node that is shown, and the one behind the last."""
    if level < 0:
        return 0, 0
    return (2**level - 1 if only else 0), min(2 ** (level + 1) - 1, nodes)
