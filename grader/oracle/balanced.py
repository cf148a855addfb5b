"""Which tree serves when the model solution's is not at hand? One that needs no compiler.

Theory of operation. Faces are sorted along a Z-order curve through their centres, so that
neighbours in the order are neighbours in space, and every node's range is cut in the middle.
The tree has no boxes: whoever only needs its order of the faces computes boxes anyway.
"""

import numpy as np
import numpy.typing as npt

from grader.model.mesh import Bvh, Mesh
from grader.tolerances import FACES_PER_LEAF

BITS = 16
"""Cells of the curve's grid along an axis, as a power of two."""


def balanced_tree(mesh: Mesh) -> Bvh:
    """Build a tree without boxes over a mesh, for `grader.oracle.brute.answers`.

    Args:
        mesh: Triangles with finite corners; there may be none.
    """
    faces = len(mesh.faces)
    depth = max(0, -(-faces // FACES_PER_LEAF) - 1).bit_length()
    cuts = [np.arange(2**level + 1) * faces >> level for level in range(depth + 1)]
    nothing = np.zeros((0, 3), dtype=np.float32)
    return Bvh(
        low=nothing,
        high=nothing,
        begin=np.concatenate([cut[:-1] for cut in cuts]).astype(np.uint32),
        end=np.concatenate([cut[1:] for cut in cuts]).astype(np.uint32),
        order=np.argsort(_places(mesh), kind="stable").astype(np.uint32),
        node_count=2 ** (depth + 1) - 1,
    )


def _places(mesh: Mesh) -> npt.NDArray[np.uint64]:
    """Return (F,) uint64, where each face's centre is on the curve."""
    centre = mesh.vertices[mesh.faces].mean(axis=1, dtype=np.float64)
    low = centre.min(axis=0, initial=np.inf)
    size = np.maximum(centre.max(axis=0, initial=-np.inf) - low, np.finfo(np.float64).tiny)
    cell = ((centre - low) / size * (2**BITS - 1)).astype(np.uint64)
    place = np.zeros(len(cell), dtype=np.uint64)
    for bit in range(BITS):
        for axis in range(3):
            digit = (cell[:, axis] >> np.uint64(bit)) & np.uint64(1)
            place |= digit << np.uint64(3 * bit + axis)
    return place
