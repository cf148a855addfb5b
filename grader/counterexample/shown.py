"""What of a failing case can be turned in three dimensions: mesh, boxes, node, ray."""

from collections.abc import Sequence

import numpy as np

from grader.counterexample.explain import Explanation, Setting
from grader.model.mesh import SOLID, Bvh, Floats, Integers, Mesh
from grader.model.path import NO_NODE
from grader.model.trials import AlteredTrial, ImageTrial, TraceTrial
from grader.model.views import Model, ShownRay, Step
from grader.verify.tree import Shape, shape, spans

MOST_BOXES = 1023
"""Nodes of the ten uppermost levels: what is below hides more than it shows."""

MOST_STEPS = 400
SEARCHED_FACES = 5_000
"""Of a larger mesh, a box that was copied is not looked for among all nodes."""


def with_tree(check: str, mesh: Mesh, tree: Bvh, expected: Bvh) -> Model:
    """Show a submission's tree of a small mesh, and in it the first node that is wrong.

    Args:
        check: Id of the check that fails.
        mesh: The mesh.
        tree: What `construct` made of it.
        expected: A right tree of it.
    """
    readable = is_readable(mesh, tree)
    loose = loose_node(mesh, tree) if readable else -1
    node = loose if loose >= 0 else _first_difference(expected, tree)
    box: tuple[float, ...] = ()
    if loose >= 0:
        true = spans(mesh, tree)
        box = tuple(map(float, (*true.low[loose], *true.high[loose])))
    return Model(
        check=check,
        title="",
        mesh=mesh,
        faces=len(mesh.faces),
        low=boxes(tree)[0],
        high=boxes(tree)[1],
        node=node if node < MOST_BOXES else -1,
        right_box=box,
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


def is_readable(mesh: Mesh, tree: Bvh) -> bool:
    """Tell whether ranges and face indices lie within the mesh."""
    faces = len(mesh.faces)
    whole = len(tree.order) == faces and len(tree.end) == tree.node_count
    return bool(
        whole
        and (tree.begin <= tree.end).all()
        and (tree.end <= faces).all()
        and (tree.order < faces).all()
    )


def loose_node(mesh: Mesh, tree: Bvh) -> int:
    """Return the first node whose box is not the box of its own faces; -1 if there is none.

    The tree has to be readable.
    """
    form: Shape = shape(tree)
    true, rows = spans(mesh, tree), form.reached
    loose = (tree.low[rows] != true.low[rows]) | (tree.high[rows] != true.high[rows])
    wrong = rows[loose.any(axis=1)]
    return int(wrong[0]) if wrong.size else -1


def faces_of(mesh: Mesh, tree: Bvh, node: int) -> Integers:
    """Return the faces in a node's range; none of a node that does not exist."""
    if not 0 <= node < len(tree.end):
        return np.zeros(0, np.int64)
    held = tree.order[tree.begin[node] : tree.end[node]]
    return held[held < len(mesh.faces)].astype(np.int64)


def _first_difference(expected: Bvh, tree: Bvh) -> int:
    """Return the first node in which two trees differ; -1 if none does."""
    for node in range(min(max(len(expected.end), len(tree.end)), MOST_BOXES)):
        if _content(expected, node) != _content(tree, node):
            return node
    return -1


def _content(tree: Bvh, node: int) -> object:
    if node >= len(tree.end) or not tree.end[node]:
        return None
    begin, end = int(tree.begin[node]), int(tree.end[node])
    box = (tree.low[node].tobytes(), tree.high[node].tobytes())
    return begin, end, sorted(tree.order[begin:end].tolist()), box


def _ray(
    setting: Setting,
    trial: TraceTrial | AlteredTrial | ImageTrial,
    ray: int,
    found: Explanation,
) -> ShownRay:
    rays, answers = trial.rays, trial.answers
    mine = np.arange(answers.first[ray], answers.first[ray + 1])
    solid = mine[answers.kind[mine] == SOLID]
    nearest = solid[np.argmin(answers.t[solid])] if solid.size else -1
    return ShownRay(
        origin=_triple(rays.origin[ray]),
        direction=_triple(rays.direction[ray]),
        t_min=float(rays.t_min[ray]),
        t_max=float(rays.t_max[ray]),
        expected=float(answers.t[nearest]) if solid.size else float(np.inf),
        got=setting.path.found,
        face=int(answers.face[nearest]) if solid.size else -1,
        lost=found.node,
        sentence=found.text,
        steps=tuple(_steps(setting)),
    )


def _steps(setting: Setting) -> Sequence[Step]:
    """Tell the first tests that the submission called, in order."""
    path, mesh = setting.path, setting.mesh
    count = min(len(path.is_box), MOST_STEPS)
    nodes = setting.nodes() if len(mesh.faces) <= SEARCHED_FACES else path.node.astype(np.int64)
    nodes = np.where(nodes == NO_NODE, -1, nodes)
    corners = np.ascontiguousarray(mesh.vertices[mesh.faces].reshape(-1, 9))
    known = {row.tobytes(): face for face, row in enumerate(corners)}
    return [
        Step(
            node=int(nodes[step]),
            face=-1 if path.is_box[step] else known.get(path.corners[step].tobytes(), -1),
            hit=bool(path.hit[step]),
            t_max=float(path.t_max[step]),
        )
        for step in range(count)
    ]


def _triple(values: Floats) -> tuple[float, float, float]:
    x, y, z = map(float, values)
    return x, y, z
