"""Which trees show whether hits are found through the tree?

Theory of operation. A tree is spoiled on purpose, in one of two ways that every right traversal
must notice, and rays are kept whose true hit can then not be found, and others, as a control,
whose hit can.

- Some leaves get the range of another leaf instead of their own, so that their faces are in no
  leaf. They are not just emptied, since no right tree has an empty leaf below the root.
- Some inner boxes are shrunk to almost nothing, together with all inner ones below them: a
  traversal may skip the test of the root's box, of a leaf's own box, and of all but every
  fourth level if a node has sixteen children for it. Below half of them leaves are shrunk, too,
  so that nothing sticks out by which somebody could tell such a tree. Rays that come near a
  shrunk box are left out.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from grader.model.mesh import (
    SOLID,
    Bvh,
    Doubles,
    FrozenArrays,
    Integers,
    Mask,
    Mesh,
    Rays,
)
from grader.model.trials import AlteredTrial
from grader.oracle.brute import Candidates, candidates, chosen, nearest
from grader.oracle.bundle import Stage, around, beams, on_surface, stage_for, unit, within
from grader.oracle.hierarchy import leaves_of
from grader.oracle.meshes import generator
from grader.tolerances import EPSILON

SHARE = 0.25
"""Of the leaves get the faces of others."""

SHRUNK = 4
"""Inner nodes whose boxes are shrunk."""

ABOVE_LEAVES = 4
"""Levels between a shrunk node and the highest leaf, at least."""

APART = 1e-2
"""How far, relative to t, another surface must be for a hit to be clearly gone."""

AIMED = 400
"""Rays that aim at what is gone; as many aim anywhere."""

KINDS = 3
"""Kinds of special rays."""


@dataclass(frozen=True, slots=True, eq=False)
class Alteration(FrozenArrays):
    """A spoiled tree."""

    tree: Bvh
    gone: Mask
    """(F,) bool, True for faces that cannot be reached any more."""

    near: Doubles
    """(B, 2, 3) float64, low and high corners of boxes that rays must keep clear of."""

    change: str
    """What was altered, in a half sentence: `9 of 64 leaves hold the faces of others`."""


Alter = Callable[[Bvh, int, np.random.Generator], Alteration]
"""Spoils a tree over so many faces."""

Draw = Callable[[Stage, Doubles], Rays]
"""Draws rays at (K, 3) points."""


def altered_trials(seed: int, name: str, mesh: Mesh, tree: Bvh) -> list[AlteredTrial]:
    """Spoil a tree in both ways, one of few levels in the first way only.

    Args:
        seed: Of the run.
        name: The mesh's.
        mesh: The triangles, some ten at least.
        tree: A right tree over them.
    """
    made = []
    for how, alter, draw in WAYS if 1 << _shrunk_level(tree) >= SHRUNK else WAYS[:1]:
        rng = generator(seed, name, how)
        alteration = alter(tree, len(mesh.faces), rng)
        stage = stage_for(mesh, rng, lambda rays: candidates(mesh, rays, tree))
        trial = _trial(f"{name} with {how}", stage, alteration, draw)
        made.append(replace(trial, sound=tree))
    return made


def _replaced(tree: Bvh, faces: int, rng: np.random.Generator) -> Alteration:
    """Give some leaves the faces of others."""
    leaves = rng.permutation(np.flatnonzero(leaves_of(tree) & (tree.end > tree.begin)))
    count = max(1, round(SHARE * leaves.size))
    replaced, lenders = leaves[:count], leaves[count : 2 * count]
    gone = _faces_below(tree, replaced, faces)
    begin, end = tree.begin.copy(), tree.end.copy()
    begin[replaced], end[replaced] = tree.begin[lenders], tree.end[lenders]
    spoiled = Bvh(tree.low, tree.high, begin, end, tree.order, tree.node_count)
    change = f"{count} of {leaves.size} leaves hold the faces of others"
    return Alteration(spoiled, gone, np.zeros((0, 2, 3)), change)


def _shrunk(tree: Bvh, faces: int, rng: np.random.Generator) -> Alteration:
    """Shrink the boxes of some inner nodes and of those below."""
    first = (1 << _shrunk_level(tree)) - 1
    nodes = first + rng.choice(first + 1, SHRUNK, replace=False)
    low, high = tree.low.copy(), tree.high.copy()
    near = np.stack([low[nodes], low[nodes] + (high[nodes] - low[nodes]) * 0.1], axis=1)
    tiny = low[nodes] + (high[nodes] - low[nodes]) * np.float32(1e-3)
    leaves, count = leaves_of(tree), 0
    for k, node in enumerate(nodes):
        below = _subtree(tree, node)
        if k < SHRUNK // 2:
            below = below[~leaves[below]]
        low[below], high[below] = tree.low[node], tiny[k]
        count += below.size
    spoiled = Bvh(low, high, tree.begin, tree.end, tree.order, tree.node_count)
    change = f"the boxes of {count} nodes are shrunk"
    near = near.astype(np.float64)
    reach = 0.1 * (near[:, 1] - near[:, 0]).max(axis=1)
    near[:, 0] -= reach[:, None]
    near[:, 1] += reach[:, None]
    return Alteration(spoiled, _faces_below(tree, nodes, faces), near, change)


def _subtree(tree: Bvh, root: int) -> Integers:
    """Return (K,) a node and the used nodes below it."""
    rows = [np.array([root])]
    while rows[-1].size:
        below = np.concatenate([2 * rows[-1] + 1, 2 * rows[-1] + 2])
        below = below[below < len(tree.end)]
        rows.append(below[tree.end[below] > tree.begin[below]])
    return np.concatenate(rows)


def _shrunk_level(tree: Bvh) -> int:
    """Return the level of the boxes that are shrunk; 0 if there are too few levels."""
    highest = int(np.flatnonzero(leaves_of(tree) & (tree.end > tree.begin))[0])
    return max(0, (highest + 1).bit_length() - 1 - ABOVE_LEAVES)


def _faces_below(tree: Bvh, nodes: Integers, faces: int) -> Mask:
    """Return (F,) bool, True for the faces in the ranges of nodes."""
    gone = np.zeros(faces, dtype=np.bool_)
    for begin, end in zip(tree.begin[nodes], tree.end[nodes], strict=True):
        gone[tree.order[begin:end]] = True
    return gone


def _trial(name: str, stage: Stage, alteration: Alteration, draw: Draw) -> AlteredTrial:
    """Find rays that tell the spoiled tree from the right one."""
    anywhere = stage.rng.integers(alteration.gone.size, size=AIMED)
    aimed = stage.rng.choice(np.flatnonzero(alteration.gone), AIMED)
    rays = draw(stage, on_surface(stage, np.concatenate([aimed, anywhere])))
    found = stage.look(rays)
    clear, first_gone = _told_apart(found, alteration.gone, len(rays.t_min))
    for low, high in alteration.near:
        clear &= ~_passes(rays, low, high)
    kept = np.flatnonzero(clear)
    rays = chosen(rays, kept)
    return AlteredTrial(
        name=name,
        mesh=stage.mesh,
        tree=alteration.tree,
        rays=rays,
        answers=nearest(stage.look(rays), kept.size),
        lost=first_gone[kept],
        change=alteration.change,
    )


def _from_outside(stage: Stage, target: Doubles) -> Rays:
    """Aim at (K, 3) points from around the mesh."""
    origin = around(stage, len(target))
    return beams(origin, unit(target - origin))


def _special(stage: Stage, target: Doubles) -> Rays:
    """Aim at (K, 3) points from within the box, along an axis, and up to a limit, in turns."""
    count = len(target)
    axis = np.eye(3)[stage.rng.integers(3, size=count)] * stage.rng.choice([-1, 1], (count, 1))
    outside, inside = around(stage, count), within(stage, count)
    along = target - 3 * stage.radius * axis
    kind = np.arange(count) % KINDS
    origin = np.choose(kind[:, None], [inside, along, outside])
    # The limit lies behind the point, and not at its t.
    towards = 1.25 * (target - origin)
    return beams(
        origin,
        np.choose(kind[:, None], [unit(towards), axis, towards]),
        np.choose(kind, [EPSILON, EPSILON, 0.0]),
        np.choose(kind, [np.inf, np.inf, 1.0]),
    )


# An own box test may be less sharp along axes, where it divides by 0: no shrunk boxes there.
WAYS: tuple[tuple[str, Alter, Draw], ...] = (
    ("replaced leaves", _replaced, _from_outside),
    ("shrunk boxes", _shrunk, _from_outside),
    ("special rays", _replaced, _special),
)
"""How a tree is spoiled, and which rays notice."""


def _told_apart(found: Candidates, gone: Mask, rays: int) -> tuple[Mask, Mask]:
    """Return (R,) which rays are clear, and (R,) which of them hit first what is gone.

    Clear is a ray with a sure hit and without any doubtful one whose nearest other surface,
    among what is left if the hit is gone, is far from the hit.
    """
    limit = nearest(found, rays).limit
    clear = np.isfinite(limit)
    clear[found.ray[found.kind != SOLID]] = False
    close = np.abs(found.t - limit[found.ray]) <= APART * np.abs(limit[found.ray])
    hit_gone = np.zeros(rays, dtype=np.bool_)
    hit_left = np.zeros(rays, dtype=np.bool_)
    hit_gone[found.ray[close & gone[found.face]]] = True
    hit_left[found.ray[close & ~gone[found.face]]] = True
    return clear & ~(hit_gone & hit_left), hit_gone


def _passes(rays: Rays, low: Doubles, high: Doubles) -> Mask:
    """Return (R,) bool, True where a ray's line meets a box."""
    o, d = rays.origin.astype(np.float64), rays.direction.astype(np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = (low - o) / d, (high - o) / d
    near, far = np.fmin(one, two).max(axis=1), np.fmax(one, two).min(axis=1)
    meets: Mask = ~(near > far)
    return meets
