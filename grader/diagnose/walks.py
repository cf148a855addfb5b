"""Which mistaken way through the tree explains the distances that were returned?"""

from collections.abc import Callable
from functools import partial

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, weighed
from grader.diagnose.paths import leaves, passes, reached, through_leaves
from grader.diagnose.shots import Shots, clear, limited, same, shots
from grader.model.cases import HitCase
from grader.model.mesh import Bvh, Doubles, Integers, Mask
from grader.tolerances import FACES_PER_LEAF
from grader.verify.tree import shape

Foretell = Callable[[Shots, Bvh], Doubles]
"""(S,) float64, what a mistaken search returns for each ray; infinite for a miss."""


MOST_NODES = 1 << 12
"""In larger trees not every node is tried with every ray."""


def support(case: HitCase, foretell: Foretell, any_size: bool = False) -> Support:
    """Compare what was returned with what a mistake returns, on rays without doubtful faces."""
    given = shots(case)
    if given is None or (len(case.trial.tree.end) > MOST_NODES and not any_size):
        return NOTHING
    with np.errstate(all="ignore"):
        foretold = foretell(given, case.trial.tree)
        fits = same(given.got, foretold)
        # A prediction that is right anyway tells nothing, even if its last digits differ.
        harmless = same(foretold, limited(given).closest()) & given.right
    chosen = clear(given)
    return weighed((fits | harmless)[chosen], given.right[chosen])


def of(id: str, sentence: str, foretell: Foretell, any_size: bool = False) -> Hypothesis:
    """Declare a hypothesis on distances."""
    return Hypothesis(id, HitCase, sentence, lambda case: support(case, foretell, any_size))


Seen = Callable[[Bvh], Mask]
"""(F,) bool, the faces that are tested at all."""


def _among(seen: Seen) -> Foretell:
    def foretell(given: Shots, bvh: Bvh) -> Doubles:
        met = limited(given)
        return met.only(seen(bvh)[met.face]).closest()

    return foretell


def _not_last(bvh: Bvh) -> Mask:
    return np.asarray(leaves(bvh).place != leaves(bvh).last)


def _not_first(bvh: Bvh) -> Mask:
    return np.asarray(leaves(bvh).place != leaves(bvh).first)


def _sizes(bvh: Bvh) -> Integers:
    return leaves(bvh).last - leaves(bvh).first + 1


def _small_leaves(bvh: Bvh) -> Mask:
    return _sizes(bvh) < FACES_PER_LEAF


def _not_too_large(bvh: Bvh) -> Mask:
    return _sizes(bvh) <= FACES_PER_LEAF


def _three(bvh: Bvh) -> Mask:
    return leaves(bvh).place - leaves(bvh).first < FACES_PER_LEAF - 1


def _beginning(bvh: Bvh) -> Mask:
    return leaves(bvh).first > 0


def _not_root(bvh: Bvh) -> Mask:
    return leaves(bvh).leaf > 0


def _not_sole_node(bvh: Bvh) -> Mask:
    return _not_root(bvh) | (len(bvh.end) > 1)


def _not_root_with_slots(bvh: Bvh) -> Mask:
    return _not_root(bvh) | (len(bvh.end) == 1)


def _without_slots(bvh: Bvh) -> Mask:
    return 2 * leaves(bvh).leaf + 1 >= len(bvh.end)


def _below(child: int) -> Seen:
    def seen(bvh: Bvh) -> Mask:
        leaf = leaves(bvh).leaf
        level = np.frexp(leaf + 1.0)[1] - 1
        top = (leaf + 1) >> np.maximum(level - 1, 0)
        return np.asarray((leaf == 0) | (top == child + 1))

    return seen


ROOT = "A tree that is a single leaf is never hit: the root is not asked whether it is a leaf."
START = "The search starts at a child of the root, so one half of the mesh is never seen."

FACES = (
    of(
        "leaf.last-face-skipped",
        "The last face of each leaf is not tested: its range ends one face too early.",
        _among(_not_last),
    ),
    of(
        "leaf.first-face-skipped",
        "The first face of each leaf is not tested.",
        _among(_not_first),
    ),
    of(
        "leaf.full-ones-skipped",
        "A leaf that holds as many faces as it may is not tested: the "
        "comparison leaves out the limit itself.",
        _among(_small_leaves),
    ),
    of("leaf.three-faces-at-most", "At most three faces of a leaf are tested.", _among(_three)),
    of(
        "leaf.at-the-beginning-skipped",
        "The leaf whose range begins at 0 is taken for an empty slot.",
        _among(_beginning),
    ),
    *(
        of("leaf.root-forgotten", ROOT, _among(seen))
        for seen in (_not_root, _not_sole_node, _not_root_with_slots)
    ),
    of(
        "leaf.gaps-taken-for-children",
        "A node counts as inner wherever slots for its children exist, also if they are empty.",
        _among(_without_slots),
    ),
    of(
        "leaf.by-its-count",
        "Whether a node is a leaf is told by how many faces it holds, which "
        "is wrong where the depth limit ended the splitting.",
        _among(_not_too_large),
        any_size=True,
    ),
    of("walk.starts-at-a-child", START, _among(_below(1))),
    of("walk.starts-at-a-child", START, _among(_below(2))),
)


def _through(given: Shots, bvh: Bvh, lets_pass: Mask) -> Doubles:
    return through_leaves(bvh, reached(bvh, lets_pass), limited(given)).closest()


def _one_child(given: Shots, bvh: Bvh, second: int) -> Doubles:
    """The second child, 1 the left or 2 the right one, only where the other box is missed."""
    lets_pass = passes(given, bvh).copy()
    for node in shape(bvh).inner:
        lets_pass[:, 2 * node + second] &= ~lets_pass[:, 2 * node + 3 - second]
    return _through(given, bvh, lets_pass)


def _nearer_child(given: Shots, bvh: Bvh, far: Callable[[Shots, Bvh, int], Mask]) -> Doubles:
    lets_pass = passes(given, bvh).copy()
    for node in shape(bvh).inner:
        left, right = 2 * int(node) + 1, 2 * int(node) + 2
        both = lets_pass[:, left] & lets_pass[:, right]
        left_is_far = far(given, bvh, int(node))
        lets_pass[:, left] &= ~(both & left_is_far)
        lets_pass[:, right] &= ~(both & ~left_is_far)
    return _through(given, bvh, lets_pass)


def _middles(bvh: Bvh, node: int) -> tuple[Doubles, Doubles]:
    left, right = (
        (bvh.low[child].astype(np.float64) + bvh.high[child]) / 2
        for child in (2 * node + 1, 2 * node + 2)
    )
    return left, right


def _along(given: Shots, bvh: Bvh, node: int) -> Mask:
    left, right = _middles(bvh, node)
    return np.asarray(given.direction @ (right - left) < 0)


def _away(given: Shots, bvh: Bvh, node: int) -> Mask:
    left, right = (((given.origin - middle) ** 2).sum(axis=1) for middle in _middles(bvh, node))
    return np.asarray(right < left)


def _unlooked(given: Shots, bvh: Bvh) -> Doubles:
    """Place k of the face indices is taken for face k."""
    met, held = limited(given), leaves(bvh)
    leaf_of_place = np.empty_like(held.leaf)
    leaf_of_place[held.place] = held.leaf
    through = reached(bvh, passes(given, bvh))
    return met.only(through[met.ray, leaf_of_place[met.face]]).closest()


ONE_CHILD = "One of two children is visited only if the ray misses the other one's box."
NEARER = "If the ray meets both children, only the nearer one is visited."

CHILDREN = (
    of("walk.one-child-only", ONE_CHILD, partial(_one_child, second=2)),
    of("walk.one-child-only", ONE_CHILD, partial(_one_child, second=1)),
    of("walk.nearer-child-only", NEARER, partial(_nearer_child, far=_along)),
    of("walk.nearer-child-only", NEARER, partial(_nearer_child, far=_away)),
    of(
        "leaf.index-not-looked-up",
        "The place k is used as the number of a face: faceIndices[k] is not looked up.",
        _unlooked,
    ),
)

WALKS = (*FACES, *CHILDREN)
