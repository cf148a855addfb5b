"""Which tree is as deep as trees may be, and small enough to be looked at?

Theory of operation. Parallel faces lie above each other. The root's left child gives its last
face to a right leaf of its own, the rest to its left child, and so on to the deepest level; the
root's right child does the same the other way round. What is left at both ends are leaves
that the depth limit keeps from being divided. A ray starts just before each face and runs
towards the end that is farther away, so that every leaf is wanted by some ray, and one ray of
each end passes the boxes of all nodes of its spine before it may stop.

Few nodes are used, but the slots between them must be there: 2^20 - 1 of them for level 19.
"""

from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, Doubles, Integers, Mesh, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import classified, nearest
from grader.oracle.bundle import beams
from grader.oracle.culling import all_pairs
from grader.oracle.meshes import generator, welded
from grader.tolerances import MAX_DEPTH

DEEPEST = MAX_DEPTH - 1
"""Deepest level of the tree, below a root of level 0.

Whether a tree of depth 20 ends at level 19 or 20 is a matter of reading, and a solution may be
made for the levels of its own trees only. Level 20 is for those whose trees reach it.
"""

ROUNDS = 2
"""Rays that start before each face."""

LIMITED = 33
"""Faces in each leaf at the depth limit: many more than four."""

SIZE, TILT, ASLANT = 40.0, 0.1, 0.02
"""Of the faces, whose distance is 1; and how far rays lean."""


@dataclass(frozen=True, slots=True)
class _Node:
    """A node and its range."""

    index: int
    begin: int
    end: int


def spine_trial(seed: int, deepest: int) -> TraceTrial:
    """Make the tree and its rays.

    Args:
        seed: Of the run.
        deepest: Level of the deepest leaves; the root is level 0.
    """
    rng = generator(seed, "spines", str(deepest))
    mesh = _pile(rng, 2 * (deepest - 1 + LIMITED))
    rays = _rays(rng, len(mesh.faces))
    count = len(rays.t_min)
    found = classified(mesh, rays, all_pairs(len(mesh.faces), count))
    return TraceTrial(
        name=f"spines of {deepest} levels, ordinary rays",
        mesh=mesh,
        tree=spines(mesh, deepest),
        rays=rays,
        answers=nearest(found, count),
        families=("from-inside",),
        family=np.zeros(count, dtype=np.int64),
        special=False,
    )


def spines(mesh: Mesh, deepest: int) -> Bvh:
    """Make the tree.

    Args:
        mesh: Faces above each other along z, two for each level and some more.
        deepest: Level of the deepest leaves.
    """
    heights = mesh.vertices[mesh.faces][:, :, 2].mean(axis=1)
    order = np.argsort(heights).astype(np.uint32)
    nodes = _nodes(order.size, deepest)
    slots = (2 << deepest) - 1
    low = np.full((slots, 3), np.inf, dtype=np.float32)
    high = np.full((slots, 3), -np.inf, dtype=np.float32)
    begin, end = (np.zeros(slots, dtype=np.uint32) for _ in range(2))
    for node in nodes:
        corners = mesh.vertices[mesh.faces[order[node.begin : node.end]]].reshape(-1, 3)
        low[node.index], high[node.index] = corners.min(axis=0), corners.max(axis=0)
        begin[node.index], end[node.index] = node.begin, node.end
    return Bvh(low, high, begin, end, order, slots)


def _nodes(faces: int, deepest: int) -> list[_Node]:
    """Divide the faces among two spines and their side leaves."""
    middle = faces // 2
    left, right = _Node(1, 0, middle), _Node(2, middle, faces)
    nodes = [_Node(0, 0, faces), left, right]
    for _ in range(deepest - 1):
        side = _Node(2 * left.index + 2, left.end - 1, left.end)
        left = _Node(2 * left.index + 1, left.begin, left.end - 1)
        nodes += [side, left]
        side = _Node(2 * right.index + 1, right.begin, right.begin + 1)
        right = _Node(2 * right.index + 2, right.begin + 1, right.end)
        nodes += [side, right]
    return nodes


def _pile(rng: np.random.Generator, count: int) -> Mesh:
    """Put faces above each other, about one apart."""
    turn = rng.uniform(0, 2 * np.pi, (count, 1)) + np.arange(3) * (2 * np.pi / 3)
    height = np.arange(count)[:, None] + rng.uniform(-TILT, TILT, (count, 3))
    return welded(np.stack([SIZE * np.cos(turn), SIZE * np.sin(turn), height], axis=-1), rng)


def _rays(rng: np.random.Generator, faces: int) -> Rays:
    """Start some rays half before each face."""
    face: Integers = np.tile(np.arange(faces), ROUNDS)
    up = np.where(face < faces // 2, 1.0, -1.0)
    origin = _leaning(rng, 1.0, face - up / 2)
    return beams(origin, _leaning(rng, ASLANT, up))


def _leaning(rng: np.random.Generator, most: float, z: Doubles) -> Doubles:
    """Return (K, 3) float64 vectors of given z and of small x and y."""
    sideways = rng.uniform(-most, most, (z.size, 2))
    return np.concatenate([sideways, z[:, None]], axis=1)
