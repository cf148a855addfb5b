"""Which mistake explains where nodes lie, and which of them are split?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, hypothesis, weighed
from grader.diagnose.readable import is_readable
from grader.model.cases import TreeCase
from grader.model.mesh import Bvh, Integers, Mask
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH
from grader.verify.tree import shape

Stops = Callable[[TreeCase, Integers, Integers], Mask]
"""From the reached nodes and what they hold: which of them are not split."""


def _by_leaves(case: TreeCase, stops: Stops) -> Support:
    if not is_readable(case):
        return NOTHING
    form, bvh = shape(case.bvh), case.bvh
    held = bvh.end[form.reached].astype(np.int64) - bvh.begin[form.reached]
    split = np.isin(form.reached, form.inner, assume_unique=True)
    foretold = split == ~stops(case, form.reached, held)
    return weighed(foretold, split == (held > FACES_PER_LEAF))


def _up_to(most: int) -> Stops:
    return lambda _, node, held: held <= most


def _only_children(rest: int) -> Stops:
    """Only the root and children of one side are split."""
    return lambda _, node, held: (held <= FACES_PER_LEAF) | ((node > 0) & (node % 2 != rest))


def _only_the_root(case: TreeCase, node: Integers, held: Integers) -> Mask:
    return np.asarray((held <= FACES_PER_LEAF) | (node > 0))


def _by_index(case: TreeCase, node: Integers, held: Integers) -> Mask:
    return np.asarray((held <= FACES_PER_LEAF) | (node >= MAX_DEPTH))


def _whole_levels(case: TreeCase, node: Integers, held: Integers) -> Mask:
    """All leaves are on the last level on which every node had to be split."""
    level = np.frexp(node + 1.0)[1] - 1
    large = held > FACES_PER_LEAF
    lowest = [k for k in range(MAX_DEPTH) if np.count_nonzero(large & (level == k)) < 2**k]
    full = lowest[0] if lowest else MAX_DEPTH
    deepest = int(level.max())
    # A tree may be a level short of that: the number of levels is estimated from the faces.
    return np.asarray(level >= (deepest if full - 1 <= deepest <= full else full))


def _leaves(id: str, sentence: str, stops: Stops) -> Hypothesis:
    return Hypothesis(id, TreeCase, sentence, lambda case: _by_leaves(case, stops))


SPLITS = (
    _leaves(
        "split.four-faces",
        "A node with exactly four faces is split as well, though it may stay a leaf.",
        _up_to(3),
    ),
    _leaves(
        "split.five-faces-stay",
        "A node with five faces stays a leaf, though a leaf may hold only four.",
        _up_to(5),
    ),
    _leaves(
        "split.to-single-faces",
        "Nodes are split until a single face is left, not until at most four are.",
        _up_to(1),
    ),
    _leaves(
        "split.only-the-root",
        "Only the root is split: nodes that are added during the loop are never looked at.",
        _only_the_root,
    ),
    *(
        _leaves(
            "split.one-side",
            "Of the two children of a node only one is ever split further.",
            _only_children(side),
        )
        for side in (1, 0)
    ),
    _leaves(
        "split.depth-by-index",
        "The index of a node is compared with the depth limit, not its depth.",
        _by_index,
    ),
    _leaves(
        "split.whole-levels",
        "Splitting ends at the last level that is completely full: room "
        "for the nodes below it is missing.",
        _whole_levels,
    ),
)


def _partitions(bvh: Bvh, node: int, left: int, right: int) -> bool:
    begin, end = bvh.begin, bvh.end
    if max(left, right) >= len(end):
        return False
    return bool(
        begin[left] == begin[node] < end[left] == begin[right] < end[right] == end[node]
    )


def _children_at(first: int) -> Callable[[TreeCase], Support]:
    """Look for the children of node i at 2i + first and 2i + first + 1."""

    def decide(case: TreeCase) -> Support:
        bvh, faces = case.bvh, len(case.trial.mesh.faces)
        if faces <= FACES_PER_LEAF or len(bvh.end) < 3:
            return NOTHING
        fits = against = 0
        for node in range(0 if first > 0 else 1, len(bvh.end)):
            if int(bvh.end[node]) - int(bvh.begin[node]) > FACES_PER_LEAF:
                good = _partitions(bvh, node, 2 * node + first, 2 * node + first + 1)
                fits, against = fits + good, against + (not good)
        return Support(fits, against)

    return decide


@hypothesis(TreeCase, "children.without-gaps")
def without_gaps(case: TreeCase) -> Support:
    """Children are appended one after the other, without the gaps below leaves."""
    bvh = case.bvh
    held = bvh.end.astype(np.int64) - bvh.begin
    if not len(held) or len(held) > 1 << 14:
        return NOTHING
    following, places, known = 1, [], []
    for node in range(len(held)):
        if held[node] > FACES_PER_LEAF:
            places.append(_partitions(bvh, node, following, following + 1))
            known.append(following == 2 * node + 1)
            following += 2
    return weighed(np.array(places, np.bool_), np.array(known, np.bool_))


Pairs = Callable[[Bvh, Integers, Integers, Integers], Mask]
"""From inner nodes and their left and right children: where a mistake explains ranges."""


def _by_pairs(case: TreeCase, explains: Pairs) -> Support:
    if not is_readable(case):
        return NOTHING
    form, bvh = shape(case.bvh), case.bvh
    node = form.inner[2 * form.inner + 2 < len(bvh.end)]
    parted = form.parted[node]
    return weighed(explains(bvh, node, 2 * node + 1, 2 * node + 2) | parted, parted)


def _last_lost(bvh: Bvh, node: Integers, left: Integers, right: Integers) -> Mask:
    joined = (bvh.begin[left] == bvh.begin[node]) & (bvh.end[left] == bvh.begin[right])
    return np.asarray(joined & (bvh.end[right].astype(np.int64) + 1 == bvh.end[node]))


def _lost_between(bvh: Bvh, node: Integers, left: Integers, right: Integers) -> Mask:
    around = (bvh.begin[left] == bvh.begin[node]) & (bvh.end[right] == bvh.end[node])
    return np.asarray(around & (bvh.begin[right].astype(np.int64) == bvh.end[left] + 1))


def _doubled(bvh: Bvh, node: Integers, left: Integers, right: Integers) -> Mask:
    around = (bvh.begin[left] == bvh.begin[node]) & (bvh.end[right] == bvh.end[node])
    return np.asarray(around & (bvh.begin[right].astype(np.int64) + 1 == bvh.end[left]))


def _below_leaves(bvh: Bvh, node: Integers, left: Integers, right: Integers) -> Mask:
    """Nodes that need no children have some: what lies there was never meant."""
    held = bvh.end[node].astype(np.int64) - bvh.begin[node]
    return np.asarray(held <= FACES_PER_LEAF)


def _pairs(id: str, sentence: str, explains: Pairs) -> Hypothesis:
    return Hypothesis(id, TreeCase, sentence, lambda case: _by_pairs(case, explains))


CHILDREN = (
    _pairs(
        "range.last-face-lost",
        "The right child ends one face early, as if the end of a range were its last face.",
        _last_lost,
    ),
    _pairs(
        "range.face-lost-between",
        "The right child begins one face behind the end of the left "
        "one, so a face is in neither.",
        _lost_between,
    ),
    _pairs(
        "range.face-doubled",
        "The left child ends one face too late, so a face is in both children.",
        _doubled,
    ),
    _pairs(
        "children.unused-slots-filled",
        "Slots that no node uses are not empty, so leaves seem to have children.",
        _below_leaves,
    ),
    *(
        Hypothesis(
            "children.wrong-index",
            TreeCase,
            "The children of node i are not put at 2i+1 and 2i+2, but one place beside.",
            _children_at(first),
        )
        for first in (0, 2)
    ),
    without_gaps,
)


NODES = (*SPLITS, *CHILDREN)
