"""The deepest tree is a right one, and its rays want every leaf."""

from functools import cache

import numpy as np
import pytest

from grader.model.mesh import SOLID
from grader.model.trials import TraceTrial
from grader.oracle.embree import contradicted, embree_t, witnessed
from grader.oracle.hierarchy import leaves_of
from grader.oracle.spines import DEEPEST, LIMITED, spine_trial
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH

LEVELS = (5, DEEPEST)


@cache
def trial(deepest: int) -> TraceTrial:
    """Make a trial of a seed."""
    return spine_trial(7, deepest)


def used_leaves(one: TraceTrial) -> np.ndarray:
    """Return the indices of leaves that are no empty slots."""
    return np.flatnonzero(leaves_of(one.tree) & (one.tree.end > 0))


def test_the_tree_is_right_in_every_reading_of_the_depth_limit() -> None:
    """Level 19 is the deepest one if the root counts as the first level."""
    assert DEEPEST == MAX_DEPTH - 1
    assert trial(DEEPEST).tree.node_count == 2**MAX_DEPTH - 1


@pytest.mark.parametrize("deepest", LEVELS)
def test_leaves_hold_every_face_once_and_many_only_at_the_limit(deepest: int) -> None:
    """Both ends of the deepest level have more faces than a leaf elsewhere may have."""
    one = trial(deepest)
    leaves = used_leaves(one)
    begin, end = one.tree.begin[leaves], one.tree.end[leaves]
    faces = [one.tree.order[b:e] for b, e in zip(begin, end, strict=True)]
    assert sorted(np.concatenate(faces)) == list(range(len(one.mesh.faces)))
    first, last = 2**deepest - 1, 2 ** (deepest + 1) - 2
    large = leaves[end - begin > FACES_PER_LEAF]
    assert large.tolist() == [first, last]
    assert LIMITED > FACES_PER_LEAF


@pytest.mark.parametrize("deepest", LEVELS)
def test_boxes_and_ranges_of_children_are_their_parents(deepest: int) -> None:
    """Every inner node is what its two children are together."""
    tree = trial(deepest).tree
    inner = np.flatnonzero((tree.end > 0) & ~leaves_of(tree))
    left, right = 2 * inner + 1, 2 * inner + 2
    assert (tree.begin[left] == tree.begin[inner]).all()
    assert (tree.end[left] == tree.begin[right]).all()
    assert (tree.end[right] == tree.end[inner]).all()
    assert (tree.low[inner] == np.minimum(tree.low[left], tree.low[right])).all()
    assert (tree.high[inner] == np.maximum(tree.high[left], tree.high[right])).all()


@pytest.mark.parametrize("deepest", LEVELS)
def test_every_face_is_wanted_and_none_is_doubtful(deepest: int) -> None:
    """Each ray has a sure hit and nothing else to choose from; Embree sees the same."""
    one = trial(deepest)
    assert (one.answers.kind == SOLID).all()
    assert (np.diff(one.answers.first) == 1).all()
    assert set(one.answers.face.tolist()) == set(range(len(one.mesh.faces)))
    theirs = embree_t(one.mesh, one.rays)
    assert witnessed(one.rays, one.answers, theirs).all()
    assert not contradicted(one.rays, one.answers, theirs).any()
