"""On which mesh does no tree help? Its rays must visit every node, however many there are.

Theory of operation. Thin faces run side by side along the diagonal of a cube, so that every
node's box is nearly the whole cube, and a ray to the bundle's middle enters all of them. A
guard that ends the walk after some thousand nodes, and a list that has no room for more, lose
hits here. Other meshes do not show it: on a dragon a ray tests about a hundred boxes.
"""

import numpy as np

from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import classified, nearest
from grader.oracle.bundle import beams, unit
from grader.oracle.culling import all_pairs
from grader.oracle.meshes import generator, welded

FACES = 40_000
"""A tree of 32,767 nodes."""

RAYS = 64
"""About every tenth is lost by a walk that ends after 10,000 nodes: of 16 sometimes none."""

WIDTH, BUNDLE = 0.2, 0.3
"""Of a face, whose length is 3.5; radius of the bundle, in a cube of side 2."""

DIAGONAL = (1.0, 1.0, 1.0)


def thicket(seed: int) -> Mesh:
    """Make the mesh."""
    rng = generator(seed, "thicket")
    across = np.cross(rng.standard_normal((FACES, 3)), DIAGONAL)
    offset = rng.uniform(0, BUNDLE, (FACES, 1)) * unit(across)
    side = WIDTH * unit(np.cross(rng.standard_normal((FACES, 3)), DIAGONAL))
    low, high = offset - DIAGONAL, offset + DIAGONAL
    return welded(np.stack([low - side / 2, low + side / 2, high], axis=1), rng)


def thicket_trial(seed: int, mesh: Mesh, tree: Bvh) -> TraceTrial:
    """Look at the middle of the bundle from all around.

    Args:
        seed: Of the run.
        mesh: From `thicket`.
        tree: A tree over it.
    """
    rays = _rays(seed)
    found = classified(mesh, rays, all_pairs(len(mesh.faces), RAYS))
    return TraceTrial(
        name="thicket, ordinary rays",
        mesh=mesh,
        tree=tree,
        rays=rays,
        answers=nearest(found, RAYS),
        families=("inbound",),
        family=np.zeros(RAYS, dtype=np.int64),
        special=False,
    )


def _rays(seed: int) -> Rays:
    """From all around to a point near the middle."""
    rng = generator(seed, "thicket rays")
    origin = 4.0 * unit(rng.standard_normal((RAYS, 3)))
    target = rng.uniform(-BUNDLE / 2, BUNDLE / 2, (RAYS, 3))
    return beams(origin, unit(target - origin))
