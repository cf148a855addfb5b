"""Which rays run exactly in the planes of boxes, and yet have only one right answer?

Theory of operation. A hit in a side's plane lies on the border of every face of that box, where
float32 cannot say whether a face is hit: the rule of closest hits allows both answers. Here the
faces are unit cells of a lattice with whole heights and all numbers are multiples of 1/4, so
that every product and quotient of any triangle test is exact. The two faces on both sides of a
lattice line are then hit, and such a hit is as sure as one in the middle of a face.
"""

import numpy as np

from grader.model.mesh import EDGE, SOLID, Bvh, Integers, Mesh, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import candidates, nearest
from grader.oracle.bundle import beams
from grader.oracle.meshes import generator, welded
from grader.oracle.shapes import Soup, sheet

CELLS = 16
HEIGHTS = 4
ABOVE = 8.0
"""Where the rays start, above the highest point."""


def lattice(seed: int, up: int) -> Mesh:
    """Make a height field of unit cells and whole heights.

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
    )


def _cells(rng: np.random.Generator, up: int) -> Soup:
    """Return the faces of a lattice."""
    u, v = np.meshgrid(np.arange(CELLS + 1.0), np.arange(CELLS + 1.0))
    height = rng.integers(HEIGHTS, size=u.shape).astype(np.float64)
    return np.roll(sheet(np.stack([u, v, height], axis=-1)), up - 2, axis=-1)


def _rays(rng: np.random.Generator, up: int) -> Rays:
    """Return rays straight down on inner lattice lines, a quarter beside the crossings."""
    line: Integers = np.arange(1, CELLS)
    across, along = np.meshgrid(line.astype(np.float64), np.arange(CELLS) + 0.25)
    across, along = across.ravel(), along.ravel()
    height = np.full(across.size, ABOVE)
    origin = np.concatenate(
        [np.stack([across, along, height], axis=1), np.stack([along, across, height], axis=1)]
    )
    direction = rng.choice([-0.0, 0.0], origin.shape)
    direction[:, 2] = -1.0
    return beams(np.roll(origin, up - 2, axis=1), np.roll(direction, up - 2, axis=1))
