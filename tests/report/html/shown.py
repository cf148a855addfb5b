"""Views as a grade makes them: stored scenes, trees over them, and a ray on its way."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from grader.gallery.coarse import coarsened
from grader.gallery.hung import reference_picture
from grader.model.mesh import Bvh, Doubles, Mesh
from grader.model.views import Drawing, Model, Picture, ShownRay, Step, Views
from grader.oracle.balanced import balanced_tree
from grader.oracle.scenes import load_mesh, scene_named
from grader.report.views import to_json
from tests.gallery.seen import place_of
from tests.report.small_inputs import small
from tests.verify.builder import build, soup

MOST_BOXES = 1023
MOST_FACES = 20_000
ORIGIN = (-3.0, 0.2, 0.1)


def failing_views() -> dict[str, Any]:
    """Views of a submission with a wrong box, a lost hit and wrong pixels in the dragon."""
    views = Views(
        pictures=(drawn("nested", 0), drawn("dragon", 40)),
        models=(loose_box(), lost_hit(), dragon()),
        tables=tuple((one.check, one.table) for one in [small()] if one.table),
    )
    return to_json(views)


def undrawn_views() -> dict[str, Any]:
    """Views of a submission that brought nothing."""
    scene = scene_named("nested")
    picture = Picture(scene.name, scene.title, reference_picture(place_of(scene.name)), None)
    return to_json(Views(pictures=(picture,), models=()))


def drawn(name: str, wrong: int) -> Picture:
    """Draw a scene as Mitsuba does but for a square of so many pixels a side."""
    scene = scene_named(name)
    reference = reference_picture(place_of(scene.name))
    yours, mask = reference.copy(), np.zeros(reference.shape[:2], np.uint8)
    middle = slice(scene.height // 2, scene.height // 2 + wrong)
    yours[middle, middle], mask[middle, middle] = (250, 60, 60), 1
    grain = np.random.default_rng(5).integers(0, 12, mask.shape)
    drawing = Drawing(
        yours=yours,
        difference=mask * np.uint8(180),
        wrong=mask,
        tests=reference.sum(axis=2, dtype=np.int64) // 8 + grain,
        flip=0.01,
        box_tests=40.0,
        triangle_tests=5.0,
        without_shadows=False,
    )
    return Picture(scene.name, scene.title, reference, drawing)


def loose_box() -> Model:
    """Show a box that is half as wide as its faces."""
    mesh = soup(9)
    tree = build(mesh)
    right = (*tree.low[1].tolist(), *tree.high[1].tolist())
    high = tree.high.copy()
    high[1, 0] = (tree.low[1, 0] + high[1, 0]) / 2
    faces = np.sort(tree.order[int(tree.begin[1]) : int(tree.end[1])].astype(np.int64))
    return Model(
        "bvh.boxes-are-tight", "", mesh, len(mesh.faces), tree.low, high, 1, right, faces, None
    )


def lost_hit() -> Model:
    """Show a ray through a face that is not found."""
    mesh = soup(12)
    tree = build(mesh)
    target = mesh.vertices[mesh.faces[3]].mean(axis=0, dtype=np.float64)
    direction = target - np.array(ORIGIN)
    ray = ShownRay(
        origin=ORIGIN,
        direction=(float(direction[0]), float(direction[1]), float(direction[2])),
        t_min=0.0,
        t_max=float("inf"),
        expected=1.0,
        got=float("inf"),
        face=3,
        lost=1,
        sentence="node 1, on the way to face 3, was entered, and its children were not",
        steps=tuple(walk(tree, direction)),
    )
    return Model(
        "hits.closest-wins",
        "",
        mesh,
        len(mesh.faces),
        tree.low,
        tree.high,
        -1,
        (),
        np.array([3]),
        ray,
    )


def walk(tree: Bvh, direction: Doubles) -> Iterator[Step]:
    """Test boxes from the root on, and the faces of leaves, depth first."""
    waiting = [0]
    while waiting:
        node = waiting.pop()
        begin, end = int(tree.begin[node]), int(tree.end[node])
        entered = enters(tree, node, direction)
        yield Step(node, -1, entered, float("inf"))
        first = 2 * node + 1
        inner = first < len(tree.end) and tree.end[first] > tree.begin[first]
        if entered and inner:
            waiting += [first + 1, first]
        elif entered:
            for face in tree.order[begin:end].tolist():
                yield Step(-1, face, False, float("inf"))


def enters(tree: Bvh, node: int, direction: Doubles) -> bool:
    """Intersect the ray with the three slabs of a box."""
    near = (tree.low[node] - np.array(ORIGIN)) / direction
    far = (tree.high[node] - np.array(ORIGIN)) / direction
    return bool(np.minimum(near, far).max() <= np.maximum(near, far).min())


def dragon() -> Model:
    """Show the dragon, coarsened, with the first levels of a tree."""
    whole = load_mesh("dragon")
    mesh, _ = coarsened(whole, MOST_FACES)
    tree = balanced_tree(mesh)
    low, high = np.zeros((2, MOST_BOXES, 3), np.float32)
    for node in range(MOST_BOXES):
        faces = tree.order[int(tree.begin[node]) : int(tree.end[node])]
        corners = mesh.vertices[mesh.faces[faces]].reshape(-1, 3)
        low[node], high[node] = corners.min(axis=0), corners.max(axis=0)
    nothing = np.zeros(0, np.int64)
    title = scene_named("dragon").title
    return Model("", title, mesh, len(whole.faces), low, high, -1, (), nothing, None)


def flat_model() -> Model:
    """Show a mesh of one face without any extent."""
    mesh = Mesh(np.zeros((3, 3), np.float32), np.array([[0, 1, 2]], np.uint32))
    boxes = np.full((3, 3), np.nan, np.float32)
    return Model(
        "", "a point", mesh, 1, boxes, boxes, 2, (0.0,) * 6, np.zeros(0, np.int64), None
    )
