"""Can a tree be looked into, and what do ranges of its face indices hold?"""

import numpy as np

from grader.model.cases import TreeCase
from grader.model.mesh import Doubles, Integers, Mesh
from grader.verify.structure import unreadable


def is_readable(case: TreeCase) -> bool:
    """Tell whether a tree has faces and all its ranges lie within the mesh."""
    return len(case.trial.mesh.faces) > 0 and unreadable(case.trial.mesh, case.bvh) is None


def corners(mesh: Mesh) -> Doubles:
    """(F, 3, 3) float64, of each face its three corners."""
    return mesh.vertices[mesh.faces].astype(np.float64)


def extremes(rows: Doubles, begin: Integers, end: Integers) -> tuple[Doubles, Doubles]:
    """(K, ...) float64, smallest and largest of `rows[begin[k]:end[k]]`; infinite without any.

    Args:
        rows: (F, ...) float64.
        begin: (K,) int64.
        end: (K,) int64.
    """
    shape = (len(begin), *rows.shape[1:])
    low, high = np.full(shape, np.inf), np.full(shape, -np.inf)
    some = np.flatnonzero(begin < end)
    if some.size:
        ends = np.stack([begin[some], end[some]], axis=1).ravel().astype(np.int64)
        padded = np.concatenate([rows, rows[:1]])
        low[some] = np.minimum.reduceat(padded, ends)[::2]
        high[some] = np.maximum.reduceat(padded, ends)[::2]
    return low, high
