"""Which mistaken middle explains how many faces each half of a node gets?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Support, hypothesis, weighed
from grader.diagnose.orders import halves_of, room
from grader.model.cases import TreeCase
from grader.model.mesh import Doubles, Integers
from grader.verify.tree import centres


def _by_count(case: TreeCase, count: Callable[[Integers], Integers]) -> Support:
    """The left half gets a number of faces that follows from the node's."""
    given = halves_of(case)
    if given is None:
        return NOTHING
    return weighed(given.middle - given.begin == count(given.end - given.begin), ~given.unequal)


@hypothesis(TreeCase, "middle.one-more")
def one_more(case: TreeCase) -> Support:
    """The left half always gets one face more, also where the number of faces is even."""
    return _by_count(case, lambda held: held // 2 + 1)


@hypothesis(TreeCase, "middle.one-more")
def one_less(case: TreeCase) -> Support:
    """The right half always gets one face more, also where the number of faces is even."""
    return _by_count(case, lambda held: (held - 1) // 2)


@hypothesis(TreeCase, "middle.four-to-the-left")
def four_to_the_left(case: TreeCase) -> Support:
    """One half always gets as many faces as a leaf may hold, and the other all the rest."""
    return _by_count(case, lambda held: np.minimum(held, 4))


def _by_plane(case: TreeCase, plane: Callable[[Doubles, Doubles], float]) -> Support:
    """All centres up to a plane are on the left.

    Args:
        case: The tree.
        plane: From the (2,) extent of a node's box along the axis and its (C,) centres there.
    """
    given = halves_of(case)
    if given is None:
        return NOTHING
    key = centres(case.trial.mesh).astype(np.float64)[case.bvh.order]
    foretold = np.zeros(given.node.size, dtype=np.bool_)
    slack = room(key)
    for k, node in enumerate(given.node):
        axis, begin, middle, end = (
            int(each[k]) for each in (given.axis, given.begin, given.middle, given.end)
        )
        box = np.array([case.bvh.low[node, axis], case.bvh.high[node, axis]], dtype=np.float64)
        here = plane(box, key[begin:end, axis])
        left, right = key[begin:middle, axis].max(), key[middle:end, axis].min()
        foretold[k] = left <= here + slack and right >= here - slack
    return weighed(foretold, ~given.unequal)


@hypothesis(TreeCase, "middle.of-the-box")
def of_the_box(case: TreeCase) -> Support:
    """A node is cut at the middle of its box instead of at the median of its centres."""
    return _by_plane(case, lambda box, _: float(box.mean()))


@hypothesis(TreeCase, "middle.mean")
def mean(case: TreeCase) -> Support:
    """A node is cut at the mean of its centres instead of at their median."""
    return _by_plane(case, lambda _, centre: float(centre.mean()))


MIDDLES = (one_more, one_less, four_to_the_left, of_the_box, mean)
