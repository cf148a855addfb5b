"""How many tests does a plain traversal without early out take?"""

import numpy as np

from grader.model.mesh import Bvh, Integers, Mask, Rays
from grader.oracle.hierarchy import Touches, leaves_of, traverse
from grader.tolerances import UNIT_ROUNDOFF

FAR_SLACK = np.float32(6 * UNIT_ROUNDOFF / (1 - 3 * UNIT_ROUNDOFF))
"""2 * gamma(3), by which the given box test widens a box's far side.

Source: T. Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013, section 3.
"""


def plain_costs(tree: Bvh, rays: Rays) -> tuple[float, float]:
    """Return mean calls of the box test and of the triangle test per ray.

    Tested are the root's box, the children's boxes of every inner node whose box is hit, and
    the faces of every leaf whose box is hit.
    """
    size = tree.end.astype(np.int64) - tree.begin
    boxes = triangles = 0
    for visits in traverse(leaves_of(tree), len(rays.t_min), given_box_test(tree, rays)):
        boxes += visits.tested.size
        triangles += int(size[visits.leaf].sum())
    count = max(1, len(rays.t_min))
    return boxes / count, triangles / count


def given_box_test(tree: Bvh, rays: Rays) -> Touches:
    """Return the exercise's box test, in float32, on the tree's own boxes."""
    with np.errstate(divide="ignore"):
        inverse = np.float32(1) / rays.direction
    backward = inverse < 0

    def touches(ray: Integers, node: Integers) -> Mask:
        low, high, swap = tree.low[node], tree.high[node], backward[ray]
        entry, leave = np.where(swap, high, low), np.where(swap, low, high)
        with np.errstate(invalid="ignore", over="ignore"):
            # fmax and fmin leave a NaN out: a ray in a slab's plane is not bounded by it.
            near = np.fmax.reduce((entry - rays.origin[ray]) * inverse[ray], axis=1)
            far = np.fmin.reduce((leave - rays.origin[ray]) * inverse[ray], axis=1)
            near, far = np.fmax(near, rays.t_min[ray]), np.fmin(far, rays.t_max[ray])
            hit: Mask = (near <= far + np.abs(far) * FAR_SLACK) & (near < np.inf)
        return hit

    return touches
