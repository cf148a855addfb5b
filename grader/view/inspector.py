"""What is in a node, and what is wrong with it?

The rules are those of `verify`; here they are asked node by node, and nothing is decided.
"""

from dataclasses import dataclass

import numpy as np

from grader.model.cases import TreeCase
from grader.model.mesh import Bvh, Doubles, FrozenArrays, Integers, Mask, Mesh
from grader.model.trials import ConstructTrial
from grader.tolerances import FACES_PER_LEAF
from grader.verify.axis import judge
from grader.verify.bounds import loose_nodes
from grader.verify.check import vector
from grader.verify.halves import splits
from grader.verify.structure import (
    face_indices_are_a_permutation,
    root_holds_all_faces,
    unreadable,
)
from grader.verify.tree import shape, spans
from grader.view.boxes import MOST_BOXES, count_of
from grader.view.camera import Orbit, rays_of

MOST_FACES = 12
"""Face indices of a node that are listed."""


@dataclass(frozen=True, slots=True, eq=False)
class Judgement(FrozenArrays):
    """Which nodes of a tree are wrong, (K,) int64 each, in ascending order."""

    unreadable: str
    """Why nothing can be said of the nodes; empty if it can."""

    loose: Integers
    """Their box is not the box of their faces."""

    unparted: Integers
    """Their children do not share out their faces."""

    unsplit: Integers
    """They hold too many faces for a leaf, or are split with too few."""

    lopsided: Integers
    """Their halves are not equal, or not divided by the centres."""

    sideways: Integers
    """They are divided along another axis than the longest."""

    every: Integers
    """All of them; the root, too, where something is wrong with the whole."""

    whole: tuple[str, ...] = ()
    """What is wrong with what the root holds, its box or the face indices; told of node 0."""


@dataclass(frozen=True, slots=True, eq=False)
class NodeFacts(FrozenArrays):
    """One node."""

    node: int
    level: int
    begin: int
    end: int
    faces: Integers
    """(K,) int64, its faces that exist."""

    low: tuple[float, ...]
    high: tuple[float, ...]
    right_box: tuple[float, ...]
    """Minimum and maximum of its faces; empty if its box is that, or unknown."""

    parent: int
    """-1 for the root."""

    children: tuple[int, ...]
    """Those that are used."""

    faults: tuple[str, ...]
    """What is wrong with it, a sentence each; empty if nothing is."""


NOTHING = np.zeros(0, np.int64)


def judgement(mesh: Mesh, tree: Bvh) -> Judgement:
    """Judge every node that is in reach of the root."""
    example = unreadable(mesh, tree)
    if example is not None or not len(tree.end):
        text = example.message if example is not None else ""
        return unjudged(text)
    form, found = shape(tree), splits(mesh, tree)
    held = tree.end.astype(np.int64) - tree.begin
    unparted = form.inner[~form.parted[form.inner]]
    split = np.isin(form.reached, form.inner, assume_unique=True)
    unsplit = form.reached[split != (held[form.reached] > FACES_PER_LEAF)]
    left, right = held[2 * found.node + 1], held[2 * found.node + 2]
    lopsided = found.node[(np.abs(left - right) > 1) | ~found.ordered.any(axis=1)]
    sideways = found.node[judge(mesh, tree, found).wrong]
    loose = loose_nodes(mesh, tree)
    parts = (loose, unparted, unsplit, lopsided, sideways)
    whole = _whole(mesh, tree)
    root = np.zeros(1 if whole else 0, np.int64)
    return Judgement("", *parts, np.unique(np.concatenate([root, *parts])), whole)


def unjudged(why: str) -> Judgement:
    """Say why nothing can be said of the nodes; an empty reason if there are none."""
    none = NOTHING
    return Judgement(why, none, none, none, none, none, none)


def _whole(mesh: Mesh, tree: Bvh) -> tuple[str, ...]:
    """Word what the checks of the root and of the face indices say of a readable tree."""
    case = TreeCase("", ConstructTrial("", mesh), tree)
    checks = (root_holds_all_faces, face_indices_are_a_permutation)
    found = [one.decide(case).examples for one in checks]
    return tuple(examples[0].message for examples in found if examples)


def facts_of(mesh: Mesh, tree: Bvh, node: int, known: Judgement | None) -> NodeFacts:
    """Describe a node that exists.

    Args:
        mesh: The mesh.
        tree: The tree, of which nothing is trusted.
        node: Index of a node.
        known: What is wrong with the tree; None if nobody has looked yet.
    """
    begin, end = int(tree.begin[node]), int(tree.end[node])
    held = tree.order[min(begin, len(tree.order)) : end].astype(np.int64)
    count = len(tree.end)
    children = (2 * node + 1, 2 * node + 2)
    readable = known is not None and not known.unreadable
    box = _right_box(mesh, tree, node) if readable else ()
    return NodeFacts(
        node=node,
        level=int(np.log2(node + 1)),
        begin=begin,
        end=end,
        faces=held[held < len(mesh.faces)],
        low=tuple(map(float, tree.low[node])),
        high=tuple(map(float, tree.high[node])),
        right_box=box,
        parent=(node + 1) // 2 - 1,
        children=tuple(one for one in children if one < count and tree.end[one]),
        faults=() if known is None else tuple(_faults(tree, node, known, box)),
    )


def _right_box(mesh: Mesh, tree: Bvh, node: int) -> tuple[float, ...]:
    true = spans(mesh, tree)
    low, high = true.low[node], true.high[node]
    if node == 0 and len(mesh.faces):
        # As its check has it: also of vertices that no face uses.
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    same = (tree.low[node] == low).all() and (tree.high[node] == high).all()
    return () if same or not np.isfinite(low).all() else tuple(map(float, (*low, *high)))


def _faults(tree: Bvh, node: int, known: Judgement, box: tuple[float, ...]) -> list[str]:
    """Word what is wrong with a node."""
    if known.unreadable:
        return [known.unreadable]
    told = [] if node else list(known.whole)
    held = int(tree.end[node]) - int(tree.begin[node])
    if node in known.loose and box:
        told.append(f"its triangles span {vector(box[:3])} to {vector(box[3:])}")
    if node in known.unparted:
        told.append("its children do not share out its faces")
    if node in known.unsplit:
        few, many = f"{held} faces, but it is split", f"{held} faces, but it is not split"
        told.append(many if held > FACES_PER_LEAF else few)
    if node in known.lopsided:
        told.append("it is not divided in two equal halves at the median of the centres")
    if node in known.sideways:
        told.append("it is not divided along the longest axis of its box")
    return told


def some_faces(facts: NodeFacts) -> str:
    """List the first faces of a node."""
    few = ", ".join(map(str, facts.faces[:MOST_FACES].tolist()))
    return f"{few}, ..." if facts.faces.size > MOST_FACES else few


def next_of(nodes: Integers, after: int) -> int:
    """Return the first of some nodes behind another, from the start if need be; -1 if none.

    Args:
        nodes: (K,) int64, ascending.
        after: A node.
    """
    if not nodes.size:
        return -1
    later = nodes[nodes > after]
    return int(later[0] if later.size else nodes[0])


def picked(
    tree: Bvh,
    orbit: Orbit,
    size: tuple[int, int],
    pixel: tuple[int, int],
    shown: tuple[int, bool],
) -> int:
    """Return the node whose box lies under a pixel; -1 if there is none.

    Of all boxes that are shown and that the pixel's ray meets it is the smallest.

    Args:
        tree: The tree.
        orbit: The camera.
        size: Of the picture.
        pixel: Column and row.
        shown: The level of boxes, and whether only that one is shown.
    """
    first, past = count_of(min(len(tree.end), MOST_BOXES), *shown)
    if past <= first:
        return -1
    width, height = size
    ray = rays_of(orbit, width, height, np.array([pixel[1] * width + pixel[0]]))[0]
    low, high = tree.low[first:past], tree.high[first:past]
    met = _met(low, high, ray[0:3], ray[3:6]) & (tree.end[first:past] != 0)
    places = np.flatnonzero(met)
    if not places.size:
        return -1
    with np.errstate(over="ignore"):
        measure = (high[places].astype(np.float64) - low[places]).sum(axis=1)
    return int(first + places[np.argmin(measure)])


def _met(low: np.ndarray, high: np.ndarray, origin: Doubles, direction: Doubles) -> Mask:
    """(K,) bool, which boxes a ray meets."""
    with np.errstate(all="ignore"):
        one, other = (low - origin) / direction, (high - origin) / direction
        near = np.fmin(one, other).max(axis=1)
        far = np.fmax(one, other).min(axis=1)
        return np.asarray((near <= far) & (far >= 0) & (low <= high).all(axis=1))
