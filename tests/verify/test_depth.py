"""Trees that end at the depth limit, above it or below."""

import numpy as np
import pytest

from grader.model.cases import DepthCase, TreeCase
from grader.model.mesh import Bvh
from grader.model.trials import ConstructTrial
from grader.model.verdict import Evidence, Verdict
from grader.tolerances import MAX_DEPTH, SMALL_MAX_DEPTH
from grader.verify.structure import depth_is_limited
from tests.verify.builder import Reading, altered, build, changed, findings, soup

LIMITED = soup(600)
"""More faces than the small depth limit has room for."""


def limited(bvh: Bvh) -> set[str]:
    """Judge a tree of the build with the small limit; returns the checks that fail."""
    case = TreeCase("mesh", ConstructTrial("mesh", LIMITED, sanitized=True), bvh)
    return {id for id, one in findings(case).items() if one.verdict is Verdict.FAIL}


@pytest.mark.parametrize("depth", [SMALL_MAX_DEPTH - 1, SMALL_MAX_DEPTH, MAX_DEPTH])
def test_a_tree_that_ends_at_the_limit_is_right(depth: int) -> None:
    """Whether the root is level 0 or 1; and so is one that knows the number 20 only."""
    assert limited(build(LIMITED, Reading(depth=depth))) == set()


@pytest.mark.parametrize("depth", [SMALL_MAX_DEPTH - 2, SMALL_MAX_DEPTH + 1])
def test_a_tree_that_ends_elsewhere_has_large_leaves(depth: int) -> None:
    """They are no leaves on the last allowed level."""
    assert limited(build(LIMITED, Reading(depth=depth))) == {"bvh.leaves-hold-at-most-four"}


def test_one_node_on_the_last_level_does_not_excuse_the_others() -> None:
    """A leaf above the last level is split if anything is on it."""
    deep = build(LIMITED, Reading(depth=SMALL_MAX_DEPTH))
    last = np.arange(deep.end.size) >= 2**SMALL_MAX_DEPTH + 1
    few = altered(deep, end=np.where(last, 0, deep.end), begin=np.where(last, 0, deep.begin))
    assert "bvh.leaves-hold-at-most-four" in limited(few)


def test_a_box_on_the_last_level_is_looked_at() -> None:
    """Only trees at the limit have such nodes."""
    deep = build(LIMITED, Reading(depth=SMALL_MAX_DEPTH))
    assert limited(changed(deep, "low", (deep.end.size - 1, 0), -9.0)) == {
        "bvh.boxes-are-tight"
    }


def full_tree(levels: int) -> Bvh:
    """Make a tree of one face per node whose deepest level is `levels`."""
    count = 2 ** (levels + 1) - 1
    zeros = np.zeros((count, 3), np.float32)
    ones = np.ones(count, np.uint32)
    return Bvh(zeros, zeros, ones - 1, ones, np.zeros(300, np.uint32), count)


def depth_evidence(levels: int, max_depth: int) -> Evidence:
    """Judge the depth of a full tree."""
    trial = ConstructTrial("deep", soup(300), sanitized=True)
    return depth_is_limited.decide(DepthCase("deep", trial, full_tree(levels), max_depth))


@pytest.mark.parametrize(("max_depth", "levels"), [(6, 5), (6, 6), (20, 19), (20, 20)])
def test_the_last_level_may_be_counted_from_zero_or_one(max_depth: int, levels: int) -> None:
    """The root is level 0 or level 1: the deepest node is on the limit or one above it."""
    assert depth_evidence(levels, max_depth).wrong == 0


@pytest.mark.parametrize(("max_depth", "levels"), [(6, 4), (6, 7), (6, 0), (20, 18), (20, 21)])
def test_other_depths_are_wrong(max_depth: int, levels: int) -> None:
    """One level less or more is a mistake, and the message names both levels."""
    (example,) = depth_evidence(levels, max_depth).examples
    assert f"the deepest node is on level {levels}" in example.message
    assert f"level {max_depth - 1} or {max_depth}" in example.message


def test_a_large_leaf_above_the_last_level_of_the_large_mesh_is_seen() -> None:
    """It waited when the first node reached the last level; small meshes have other checks."""
    tree = full_tree(6)
    end = tree.end.copy()
    end[5] = 9
    for row in ((11, 13), (23, 27), (47, 55), (95, 111)):
        end[slice(*row)] = 0
    left = altered(tree, end=end)
    for sanitized, wrong in ((False, 1), (True, 0)):
        trial = ConstructTrial("deep", soup(300), sanitized=sanitized)
        evidence = depth_is_limited.decide(DepthCase("deep", trial, left, 6))
        assert evidence.wrong == wrong
    large = ConstructTrial("deep", soup(300))
    assert not depth_is_limited.decide(DepthCase("deep", large, tree, 6)).wrong
