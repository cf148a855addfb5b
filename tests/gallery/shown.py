"""Views made by hand: one scene with one wrong pixel, one small model with a ray."""

import numpy as np

from grader.model.mesh import Bytes, Mesh
from grader.model.views import Drawing, Model, Picture, ShownRay, Step, Views
from tests.verify.builder import soup

SIDE = 200


def noise(seed: int) -> Bytes:
    """Return a picture that cannot be compressed."""
    return np.random.default_rng(seed).integers(0, 256, (SIDE, SIDE, 3), dtype=np.uint8)


def picture(name: str, wrong_pixel: tuple[int, int] | None = None) -> Picture:
    """Make a picture in which at most one pixel (x, y) is wrong."""
    reference = noise(1)
    yours, wrong = reference.copy(), np.zeros((SIDE, SIDE), np.uint8)
    difference = np.zeros((SIDE, SIDE), np.uint8)
    if wrong_pixel is not None:
        x, y = wrong_pixel
        yours[y, x] = 255 - yours[y, x]
        wrong[y, x], difference[y, x] = 1, 252
    drawing = Drawing(
        yours=yours,
        difference=difference,
        wrong=wrong,
        tests=np.full((SIDE, SIDE), 7, np.int64),
        flip=0.25,
        box_tests=5.0,
        triangle_tests=2.0,
        without_shadows=False,
    )
    return Picture(name, f"the {name}", reference, drawing)


def model(mesh: Mesh) -> Model:
    """Show a mesh with one box and one ray."""
    ray = ShownRay(
        origin=(0.0, 1.0, 2.0),
        direction=(0.0, 0.0, -1.0),
        t_min=0.0,
        t_max=float("inf"),
        expected=float("inf"),
        got=2.5,
        face=-1,
        lost=-1,
        sentence="node 1 was never visited",
        steps=(Step(0, -1, True, float("inf")), Step(-1, 2, False, 2.5)),
    )
    box = np.array([[0, 0, 0], [np.nan] * 3], np.float32)
    marked = np.array([1, 2, 4])
    return Model("hits.closest-wins", "", mesh, 9, box, box + 1, 0, (), marked, ray)


def some_views() -> Views:
    """Return both."""
    return Views((picture("wall", wrong_pixel=(30, 60)),), (model(soup(5)),))
