"""What of a failing case can be turned in three dimensions: mesh, boxes, node, ray."""

from collections.abc import Sequence

import numpy as np

from grader.counterexample.explain import Explanation, Setting
from grader.counterexample.table import first_difference
from grader.model.mesh import Bvh, Floats, Integers, Mesh
from grader.model.trials import AlteredTrial, ImageTrial, TraceTrial
from grader.model.views import Model, ShownRay, Step
from grader.verify.bounds import loose_nodes
from grader.verify.closest import closest_sure
from grader.verify.structure import unreadable
from grader.verify.tree import spans

MOST_BOXES = 1023
"""Nodes of the ten uppermost levels: what is below hides more than it shows."""

MOST_STEPS = 400


def with_tree(check: str, mesh: Mesh, tree: Bvh, expected: Bvh) -> Model:
    """Show a submission's tree of a small mesh, and in it the first node that is wrong.

    Args:
        check: Id of the check that fails.
        mesh: The mesh.
        tree: What `construct` made of it.
        expected: The right tree that is nearest to it.
    """
    node = loose_node(mesh, tree)
    if node < 0:
        count = max(len(expected.end), len(tree.end))
        node = first_difference(expected, tree, range(min(count, MOST_BOXES)))
    return Model(
        check=check,
        title="",
        mesh=mesh,
        faces=len(mesh.faces),
        low=boxes(tree)[0],
        high=boxes(tree)[1],
        node=node if node < MOST_BOXES else -1,
        right_box=right_box(mesh, tree, node),
        marked=faces_of(mesh, tree, node),
        ray=None,
    )


def with_ray(
    check: str,
    setting: Setting,
    trial: TraceTrial | AlteredTrial | ImageTrial,
    ray: int,
    found: Explanation,
) -> Model:
    """Show a ray with a wrong result, and the nodes that it visited.

    Args:
        check: Id of the check that fails.
        setting: The tree and the recorded path.
        trial: What was asked.
        ray: Index of the ray.
        found: Why the result is wrong.
    """
    tree = setting.tree
    shown = _ray(setting, trial, ray, found)
    face = shown.face
    return Model(
        check=check,
        title="",
        mesh=setting.mesh,
        faces=len(setting.mesh.faces),
        low=boxes(tree)[0],
        high=boxes(tree)[1],
        node=-1,
        right_box=(),
        marked=np.array([face] if face >= 0 else [], np.int64),
        ray=shown,
    )


def boxes(tree: Bvh) -> tuple[Floats, Floats]:
    """Return corners of a tree's first nodes, (N, 3) each, NaN in empty slots."""
    count = min(len(tree.end), MOST_BOXES)
    used = (tree.end[:count] != 0)[:, None]
    nothing = np.float32(np.nan)
    low = np.where(used, tree.low[:count], nothing)
    return low, np.where(used, tree.high[:count], nothing)


def loose_node(mesh: Mesh, tree: Bvh) -> int:
    """Return the first node whose box is not the box of its own faces; -1 if there is none.

    Of a tree that is not readable nothing is known.
    """
    if not len(tree.end) or unreadable(mesh, tree) is not None:
        return -1
    loose = loose_nodes(mesh, tree)[:1].tolist()
    return next((n for n in (0, *loose) if right_box(mesh, tree, n)), -1)


def right_box(mesh: Mesh, tree: Bvh, node: int) -> tuple[float, ...]:
    """Return minimum and maximum of a node's faces; empty if its box is that, or unknown."""
    if not 0 <= node < len(tree.end) or unreadable(mesh, tree) is not None:
        return ()
    true = spans(mesh, tree)
    same = (tree.low[node] == true.low[node]) & (tree.high[node] == true.high[node])
    if same.all() or not np.isfinite(true.low[node]).all():
        return ()
    return tuple(map(float, (*true.low[node], *true.high[node])))


def faces_of(mesh: Mesh, tree: Bvh, node: int) -> Integers:
    """Return the (K,) int64 faces in a node's range; none of a node that does not exist."""
    if not 0 <= node < len(tree.end):
        return np.zeros(0, np.int64)
    held = tree.order[tree.begin[node] : tree.end[node]]
    return held[held < len(mesh.faces)].astype(np.int64)


def _ray(
    setting: Setting,
    trial: TraceTrial | AlteredTrial | ImageTrial,
    ray: int,
    found: Explanation,
) -> ShownRay:
    rays, answers = trial.rays, trial.answers
    nearest = closest_sure(answers, ray)
    return ShownRay(
        origin=_triple(rays.origin[ray]),
        direction=_triple(rays.direction[ray]),
        t_min=float(rays.t_min[ray]),
        t_max=float(rays.t_max[ray]),
        expected=float(answers.t[nearest]) if nearest >= 0 else float(np.inf),
        got=setting.path.found,
        face=int(answers.face[nearest]) if nearest >= 0 else -1,
        lost=found.node,
        sentence=found.text,
        steps=tuple(steps_of(setting)),
    )


def steps_of(setting: Setting) -> Sequence[Step]:
    """Tell the first tests that the submission called, in order."""
    path, mesh = setting.path, setting.mesh
    count, nodes = min(len(path.is_box), MOST_STEPS), setting.nodes()
    known = _faces_by_corners(mesh, path.corners[:count][~path.is_box[:count]])
    return [
        Step(
            node=int(nodes[step]),
            face=-1 if path.is_box[step] else known.get(path.corners[step].tobytes(), -1),
            hit=bool(path.hit[step]),
            t_max=float(path.t_max[step]),
        )
        for step in range(count)
    ]


def _faces_by_corners(mesh: Mesh, tested: Floats) -> dict[bytes, int]:
    """Find faces by the bytes of their corners, without going through all of a large mesh.

    Args:
        mesh: The mesh.
        tested: (K, 9) float32, corners of the triangles that are looked for.
    """
    begins = np.isin(mesh.vertices[mesh.faces[:, 0], 0], tested[:, 0])
    likely = np.flatnonzero(begins)
    rows = np.ascontiguousarray(mesh.vertices[mesh.faces[likely]].reshape(-1, 9))
    return {row.tobytes(): int(face) for row, face in zip(rows, likely, strict=True)}


def _triple(values: Floats) -> tuple[float, float, float]:
    x, y, z = map(float, values)
    return x, y, z
