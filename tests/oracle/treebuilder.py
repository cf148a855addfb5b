"""A median-split tree in plain numpy, so that oracle tests need no compiler."""

from functools import cache

import numpy as np

from grader.model.mesh import Bvh, Floats, Integers, Mesh
from grader.oracle.meshes import mesh_named
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH


def tree_of(mesh: Mesh) -> Bvh:
    """Build a tree as the exercise asks for it."""
    faces = len(mesh.faces)
    corners = mesh.vertices[mesh.faces]
    low, high = corners.min(axis=1), corners.max(axis=1)
    centre = corners.astype(np.float64).mean(axis=1)
    order = np.arange(faces)
    nodes = {0: (0, faces)}
    waiting = [0]
    while waiting:
        node = waiting.pop()
        begin, end = nodes[node]
        if end - begin <= FACES_PER_LEAF or (node + 1).bit_length() > MAX_DEPTH:
            continue
        part = order[begin:end]
        axis = int(np.argmax(high[part].max(axis=0) - low[part].min(axis=0)))
        order[begin:end] = part[np.argsort(centre[part, axis], kind="stable")]
        middle = (begin + end) // 2
        nodes[2 * node + 1], nodes[2 * node + 2] = (begin, middle), (middle, end)
        waiting += [2 * node + 1, 2 * node + 2]
    return _record(nodes, order, low, high)


def _record(
    nodes: dict[int, tuple[int, int]], order: Integers, low: Floats, high: Floats
) -> Bvh:
    """Collect nodes, given by their ranges, and their boxes."""
    count = max(nodes) + 1
    box_low = np.full((count, 3), np.inf, np.float32)
    box_high = np.full((count, 3), -np.inf, np.float32)
    begins, ends = np.zeros(count, np.uint32), np.zeros(count, np.uint32)
    for node, (begin, end) in nodes.items():
        begins[node], ends[node] = begin, end
        if end > begin:
            box_low[node] = low[order[begin:end]].min(axis=0)
            box_high[node] = high[order[begin:end]].max(axis=0)
    return Bvh(box_low, box_high, begins, ends, order.astype(np.uint32), count)


@cache
def planted(name: str, seed: int = 7) -> tuple[Mesh, Bvh]:
    """Return a mesh by its name, and a tree over it."""
    mesh = mesh_named(seed, name)
    return mesh, tree_of(mesh)
