"""What is drawn over the panes: a node's box, a ray, and the boxes that it tested.

Lines in space become lines on a picture here, so that a window and a file draw the same.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, Doubles, Mesh
from grader.view.camera import Orbit, frame_of, spread
from grader.view.inspector import NodeFacts
from grader.view.stage import Stage
from grader.view.walking import Walk

Colour = tuple[int, int, int]

NODE: Colour = (255, 178, 0)
WRONG: Colour = (255, 90, 79)
RIGHT: Colour = (56, 214, 122)
RAY: Colour = (33, 184, 232)
VISITED: Colour = (138, 163, 255)
NOW: Colour = (247, 107, 230)

NEAREST = 1e-4
"""Of what is drawn, in distances of the camera."""

MOST_OUTLINES = 64


@dataclass(frozen=True, slots=True, eq=False)
class Stroke:
    """Lines of one colour."""

    lines: Doubles
    """(K, 2, 3) float64 in space, or (K, 2, 2) in pixels."""

    colour: Colour
    width: float


def of_both(
    stage: Stage | None, facts: NodeFacts | None, walk: Walk | None, step: int
) -> list[Stroke]:
    """Draw a node and a ray of what is looked at, if there are any.

    Args:
        stage: What is looked at.
        facts: The node.
        walk: The ray.
        step: How many of its steps are done.
    """
    if stage is None or stage.tree is None:
        return []
    mesh, found = stage.subject.mesh, list[Stroke]()
    if facts is not None:
        found += of_node(mesh, facts)
    if walk is not None:
        found += of_walk(mesh, stage.tree, walk, step, stage.subject.home.size)
    return found


def of_node(mesh: Mesh, facts: NodeFacts) -> Iterator[Stroke]:
    """Draw a node, and the box that it should have."""
    bad = bool(facts.faults)
    yield Stroke(edges((*facts.low, *facts.high)), WRONG if bad else NODE, 2.5)
    if facts.right_box:
        yield Stroke(edges(facts.right_box), RIGHT, 2.0)
    if facts.faces.size <= MOST_OUTLINES:
        yield Stroke(outlines(mesh, facts.faces), NODE, 1.5)


def of_walk(mesh: Mesh, tree: Bvh, walk: Walk, step: int, size: float) -> Iterator[Stroke]:
    """Draw a ray up to a step.

    Args:
        mesh: The mesh.
        tree: The tree.
        walk: The ray and its steps.
        step: How many steps are done.
        size: Of the scene, for rays that go on for ever.
    """
    before = [one for one in walk.steps[: max(step - 1, 0)] if _has_box(tree, one.node)]
    if before:
        yield Stroke(np.concatenate([_box(tree, one.node) for one in before]), VISITED, 1.2)
    if 0 < step <= len(walk.steps):
        now = walk.steps[step - 1]
        if _has_box(tree, now.node):
            yield Stroke(_box(tree, now.node), NOW, 3.0)
        if 0 <= now.face < len(mesh.faces):
            yield Stroke(outlines(mesh, np.array([now.face])), NOW, 3.0)
    yield from _ray(walk, size)


def _ray(walk: Walk, size: float) -> Iterator[Stroke]:
    ray = walk.ray.astype(np.float64)
    origin, direction = ray[0:3], ray[3:6]
    length = float(np.linalg.norm(direction)) or 1.0
    known = [t for t in (walk.found, walk.expected) if t is not None and np.isfinite(t)]
    reach = 3 * size / length
    far = max([t for t in known if 0 < t < 100 * reach], default=reach)
    yield Stroke(np.array([[origin, origin + far * direction]]), RAY, 2.0)
    for t, colour, wide in ((walk.expected, RIGHT, 9.0), (walk.found, WRONG, 6.0)):
        if t is not None and np.isfinite(t):
            place = origin + t * direction
            yield Stroke(
                np.array([[place, place + 1e-3 * size / length * direction]]), colour, wide
            )


def edges(box: tuple[float, ...]) -> Doubles:
    """(12, 2, 3) float64, world space, the edges of a box, given by minimum and maximum."""
    corner = np.array(box, np.float64).reshape(2, 3)
    lines = []
    for axis in range(3):
        for k in range(4):
            place = np.array([0, 0, 0])
            place[(axis + 1) % 3], place[(axis + 2) % 3] = k & 1, k >> 1
            other = place.copy()
            other[axis] = 1
            lines.append([corner[one, np.arange(3)] for one in (place, other)])
    return np.array(lines)


def outlines(mesh: Mesh, faces: np.ndarray) -> Doubles:
    """(3K, 2, 3) float64, world space, the sides of (K,) faces, given by integers."""
    corners = mesh.vertices[mesh.faces[faces]].astype(np.float64)
    return np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 3)


def projected(stroke: Stroke, orbit: Orbit, width: int, height: int) -> Stroke:
    """Bring lines onto a picture; what lies behind the camera is cut off."""
    frame, (wide, high) = frame_of(orbit), spread(orbit, width, height)
    axes = np.stack([frame.right, frame.up, -frame.back])
    near = NEAREST * orbit.distance
    with np.errstate(all="ignore"):
        seen = (stroke.lines - frame.eye) @ axes.T
        depth = seen[..., 2]
        kept = np.isfinite(seen).all(axis=(1, 2)) & (depth.max(axis=1, initial=-1) > near)
        seen, depth = seen[kept], depth[kept]
        share = (near - depth[:, :1]) / (depth[:, 1:] - depth[:, :1])
        cut = seen[:, 0] + share * (seen[:, 1] - seen[:, 0])
        for end in (0, 1):
            behind = depth[:, end] < near
            seen[behind, end] = cut[behind]
        x = (seen[..., 0] / seen[..., 2] / wide + 1) * width / 2
        y = (1 - seen[..., 1] / seen[..., 2] / high) * height / 2
    return Stroke(np.clip(np.stack([x, y], axis=2), -1e4, 1e4), stroke.colour, stroke.width)


def _has_box(tree: Bvh, node: int) -> bool:
    return 0 <= node < len(tree.end)


def _box(tree: Bvh, node: int) -> Doubles:
    return edges((*tree.low[node].tolist(), *tree.high[node].tolist()))
