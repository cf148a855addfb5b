"""How many tests does a plain traversal without early out take?"""

import numpy as np

from grader.model.mesh import Bvh, Floats, Integers, Mask, Rays
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
        low, high = tree.low.take(node, axis=0), tree.high.take(node, axis=0)
        origin, scale = rays.origin.take(ray, axis=0), inverse.take(ray, axis=0)
        swap = backward.take(ray, axis=0)
        entry, leave = np.where(swap, high, low), np.where(swap, low, high)
        with np.errstate(invalid="ignore", over="ignore"):
            # fmax and fmin leave a NaN out: a ray in a slab's plane is not bounded by it.
            near = _of_all_axes(np.fmax, (entry - origin) * scale)
            far = _of_all_axes(np.fmin, (leave - origin) * scale)
            near, far = np.fmax(near, rays.t_min[ray]), np.fmin(far, rays.t_max[ray])
            hit: Mask = (near <= far + np.abs(far) * FAR_SLACK) & (near < np.inf)
        return hit

    return touches


def _of_all_axes(what: np.ufunc, values: Floats) -> Floats:
    """Return (K,) float32, `what.reduce(values, axis=1)` of (K, 3), several times as fast."""
    return np.asarray(what(what(values[:, 0], values[:, 1]), values[:, 2]))
