"""Which leaves of a tree does each ray reach? A traversal of all rays at once, level by level.

The frontier is a list of (ray, node) pairs; a box test, given from outside, thins it out, and
the children of what is left are the next frontier. Rays are taken in blocks, so that the
frontier fits in memory.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, FrozenArrays, Integers, Mask

BLOCK = 16_384
"""Rays that are taken through the tree together."""

Touches = Callable[[Integers, Integers], Mask]
"""(K,) rays and (K,) nodes -> (K,) bool, True where the ray enters the node's box."""


@dataclass(frozen=True, slots=True, eq=False)
class Visits(FrozenArrays):
    """What a block of rays did in a tree."""

    ray: Integers
    """(K,) int64, ray of each leaf whose box was entered."""

    leaf: Integers
    """(K,) int64, that leaf's node index."""

    tested: Integers
    """(T,) int64, ray of each box test."""


def leaves_of(tree: Bvh) -> Mask:
    """Return (N,) bool, True where a node has no children.

    Source: exercise sheet, part b, "A node is a leaf node, if its child node indices would be
    outside of the node vector or if the child node's facesEnd is 0".
    """
    count = tree.end.size
    leaf = np.ones(count, dtype=np.bool_)
    inner = np.arange(max(0, (count - 1) // 2))
    leaf[inner] = (tree.end[2 * inner + 1] == 0) | (tree.end[2 * inner + 2] == 0)
    return leaf


def traverse(leaf: Mask, rays: int, touches: Touches) -> Iterator[Visits]:
    """Take rays through a tree, block by block.

    Args:
        leaf: (N,) bool, True where a node has no children.
        rays: How many rays there are.
        touches: The box test.
    """
    for start in range(0, rays if leaf.size else 0, BLOCK):
        yield _block(leaf, np.arange(start, min(start + BLOCK, rays)), touches)


def _block(leaf: Mask, ray: Integers, touches: Touches) -> Visits:
    """Take one block of rays through the tree."""
    node = np.zeros_like(ray)
    tested, found_ray, found_leaf = [], [], []
    while ray.size:
        tested.append(ray)
        hit = touches(ray, node)
        ray, node = ray[hit], node[hit]
        at_leaf = leaf[node]
        found_ray.append(ray[at_leaf])
        found_leaf.append(node[at_leaf])
        ray, node = np.repeat(ray[~at_leaf], 2), np.repeat(2 * node[~at_leaf] + 1, 2)
        node[1::2] += 1
    return Visits(
        ray=np.concatenate(found_ray),
        leaf=np.concatenate(found_leaf),
        tested=np.concatenate(tested),
    )


def spread(ray: Integers, begin: Integers, end: Integers) -> tuple[Integers, Integers]:
    """Turn ranges into one entry for each place in them.

    Args:
        ray: (K,) int64.
        begin: (K,) int64, where the range of each ray begins.
        end: (K,) int64, where it ends, excluded.

    Returns:
        Ray and place of each entry, (M,) int64 each, M the sum of the ranges' lengths.
    """
    size = end - begin
    offset = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
    return np.repeat(ray, size), np.repeat(begin, size) + offset
