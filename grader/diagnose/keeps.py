"""Which mistaken choice among the hits of a ray explains the distances that were returned?"""

from functools import partial

import numpy as np

from grader.diagnose.paths import ORDERS, sequence
from grader.diagnose.shots import Shots, limited
from grader.diagnose.walks import of
from grader.model.mesh import Bvh, Doubles


def _first(given: Shots, bvh: Bvh, order: str) -> Doubles:
    return sequence(given, bvh, order).t[:, 0]


def _last(given: Shots, bvh: Bvh, order: str) -> Doubles:
    t = sequence(given, bvh, order).t
    return np.asarray(t[np.arange(len(t)), np.maximum(np.isfinite(t).sum(axis=1) - 1, 0)])


def _farthest(given: Shots, bvh: Bvh) -> Doubles:
    met = limited(given)
    farthest = np.full(met.shots, -np.inf)
    np.maximum.at(farthest, met.ray, met.t)
    return np.where(np.isfinite(farthest), farthest, np.inf)


def _of_leaf(given: Shots, bvh: Bvh, order: str, last: bool) -> Doubles:
    """Return the closest hit of the first or last leaf that has one."""
    found = sequence(given, bvh, order)
    column = np.maximum(np.isfinite(found.t).sum(axis=1) - 1, 0) if last else 0
    chosen = found.leaf[np.arange(len(found.t)), column]
    return np.asarray(np.where(found.leaf == chosen[:, None], found.t, np.inf).min(axis=1))


def _first_of_each_leaf(given: Shots, bvh: Bvh, order: str, shrinks: bool) -> Doubles:
    """Only the first hit of each leaf counts; of a shrinking ray the first that is closer."""
    found = sequence(given, bvh, order)
    best = np.full(len(found.t), np.inf)
    done = np.full(len(found.t), -1)
    for t, leaf in zip(found.t.T, found.leaf.T, strict=True):
        accepted = (leaf != done) & ((t < best) if shrinks else np.isfinite(t))
        done = np.where(accepted, leaf, done)
        best = np.where(accepted, np.minimum(t, best), best)
    return best


def _by_a_margin(given: Shots, bvh: Bvh, order: str, margin: float) -> Doubles:
    """A hit replaces a former one only if it is closer by a margin."""
    found = sequence(given, bvh, order)
    best = np.full(len(found.t), np.inf)
    for t in found.t.T:
        best = np.where((t < best - margin) | np.isinf(best), t, best)
    return best


FIRST_HIT = "The first hit that is found is returned, not the closest one."
LAST_HIT = "Every hit replaces the one before it, so the last one wins, not the closest."
ONE_LEAF = (
    "The hit of one leaf is returned though another leaf holds a closer one: hits of different "
    "leaves are not compared."
)
LEAF_HIT = "The loop over the faces of a leaf ends at its first hit."
MARGIN = "A hit replaces the one before it only if it is closer by some margin."

KEEPS = (
    of(
        "keeps.farthest",
        "The farthest hit wins: the comparison is the wrong way round.",
        _farthest,
    ),
    *(
        of(
            "keeps.first-of-each-leaf",
            LEAF_HIT,
            partial(_first_of_each_leaf, order=order, shrinks=shrinks),
        )
        for order in ORDERS
        for shrinks in (False, True)
    ),
    *(of("keeps.first", FIRST_HIT, partial(_first, order=order)) for order in ORDERS),
    *(of("keeps.last", LAST_HIT, partial(_last, order=order)) for order in ORDERS),
    *(
        of("keeps.one-leaf", ONE_LEAF, partial(_of_leaf, order=order, last=True))
        for order in ORDERS
    ),
    *(
        of(
            "keeps.one-leaf",
            ONE_LEAF,
            partial(_of_leaf, order=order, last=False),
        )
        for order in ORDERS
    ),
    *(
        of("keeps.only-by-a-margin", MARGIN, partial(_by_a_margin, order=order, margin=0.01))
        for order in ORDERS
    ),
)
