"""Which rays run exactly in the planes of boxes, and yet have only one right answer?

Theory of operation. A hit in a side's plane lies on the border of every face of that box,
where float32 cannot say whether a face is hit: the rule of closest hits allows both answers.
Here the faces are halves of unit squares that lie flat at whole heights, and all numbers are
multiples of 1/4, so that every product and quotient of any triangle test is exact, those of a
normal that was made a unit vector included. The squares on both sides of a line that is
followed have the same height, so it is enough if one of them counts the border as its own. Such
a hit is as sure as one in the middle of a face. Only a test that takes no border for a part of
the face finds none of them, and the rule allows that; `hits.special-rays` does not count the
case then.
"""

import numpy as np

from grader.model.mesh import EDGE, SOLID, Bvh, Integers, Mesh, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import candidates, nearest
from grader.oracle.bundle import beams
from grader.oracle.meshes import generator, welded
from grader.oracle.shapes import Soup

CELLS = 16
HEIGHTS = 4
BESIDE = 2.0 * CELLS
"""How far the squares with lines along the second axis are from the others."""

ABOVE = 8.0
"""Where the rays start, above the highest point."""


def lattice(seed: int, up: int) -> Mesh:
    """Make two fields of unit squares in rows of whole heights.

    Args:
        seed: Of the run.
        up: Axis of the heights.
    """
    rng = generator(seed, "lattice", str(up))
    return welded(_cells(rng, up), rng)


def exact_trial(seed: int, up: int, mesh: Mesh, tree: Bvh) -> TraceTrial:
    """Look down on a lattice along all its lines.

    Args:
        seed: Of the run.
        up: Axis of the heights.
        mesh: From `lattice`.
        tree: A tree over it.
    """
    rays = _rays(generator(seed, "lattice rays", str(up)), up)
    found = candidates(mesh, rays, tree)
    kind = np.where(found.kind == EDGE, SOLID, found.kind).astype(np.uint8)
    sure = type(found)(found.ray, found.face, found.t, found.tolerance, kind, found.entry)
    count = len(rays.t_min)
    return TraceTrial(
        name=f"lattice along {'xyz'[up]}, special rays",
        mesh=mesh,
        tree=tree,
        rays=rays,
        answers=nearest(sure, count),
        families=("in-slab-planes",),
        family=np.zeros(count, dtype=np.int64),
        special=True,
        on_borders=True,
    )


def _cells(rng: np.random.Generator, up: int) -> Soup:
    """Return the faces: first rows along one axis, then, beside them, along the other."""
    steps = rng.integers(HEIGHTS, size=(2, CELLS)).astype(np.float64)
    u, v = (grid.ravel() for grid in np.meshgrid(np.arange(CELLS), np.arange(CELLS)))
    place = [(u, v, steps[0][v]), (u + BESIDE, v, steps[1][u])]
    corner = np.concatenate([np.stack(each, axis=1) for each in place])[:, None]
    square = corner + np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    halves = np.stack([square[:, [0, 1, 2]], square[:, [0, 2, 3]]], axis=1)
    return np.roll(halves.reshape(-1, 3, 3), up - 2, axis=-1)


def _rays(rng: np.random.Generator, up: int) -> Rays:
    """Return rays straight down on the inner lines of each row, a quarter from its border."""
    line: Integers = np.arange(1, CELLS)
    across, along = np.meshgrid(line.astype(np.float64), np.arange(CELLS) + 0.25)
    across, along = across.ravel(), along.ravel()
    height = np.full(across.size, ABOVE)
    first = np.stack([across, along, height], axis=1)
    second = np.stack([along + BESIDE, across, height], axis=1)
    origin = np.concatenate([first, second])
    direction = rng.choice([-0.0, 0.0], origin.shape)
    direction[:, 2] = -1.0
    return beams(np.roll(origin, up - 2, axis=1), np.roll(direction, up - 2, axis=1))
