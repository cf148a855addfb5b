"""What is gone from an altered tree is found again from its file, and soon."""

from dataclasses import replace

import numpy as np
import pytest

from grader.counterexample.revived import out_of_reach
from grader.counterexample.search import MOST_FACES, MOST_RAYS
from grader.oracle.altered import altered_trials
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers
from grader.oracle.hierarchy import leaves_of
from tests.oracle.treebuilder import planted
from tests.run.test_requests import rays
from tests.verify.builder import build, soup


@pytest.mark.parametrize("name", ["terrain-1200", "cloud-37"])
def test_what_is_gone_is_what_was_drawn(name: str) -> None:
    """The same rays as when the trial was made."""
    mesh, tree = planted(name)
    for trial in altered_trials(4, name, mesh, tree):
        lost = out_of_reach(trial.tree, trial.rays, trial.answers)
        assert lost.tolist() == trial.lost.tolist()
        assert lost.any()


def test_a_ray_that_hits_nothing_loses_nothing() -> None:
    """Only a hit can be out of reach."""
    mesh = soup(9)
    away = replace(rays(), direction=-rays().direction)
    found = answers(mesh, away, balanced_tree(mesh))
    assert not out_of_reach(build(mesh), away, found)[np.isinf(found.limit)].any()


def test_leaves_that_all_hold_all_faces_hold_the_one_that_is_hit() -> None:
    """A stranger's file may say so, with the most faces and rays that a file may have."""
    mesh, tree = soup(MOST_FACES), build(soup(MOST_FACES))
    leaf = leaves_of(tree) & (tree.end > 0)
    end, begin = tree.end.copy(), tree.begin.copy()
    begin[leaf], end[leaf] = 0, MOST_FACES
    low, high = np.full_like(tree.low, -1e6), np.full_like(tree.high, 1e6)
    every = replace(tree, low=low, high=high, begin=begin, end=end)
    many = rays()
    again = np.arange(MOST_RAYS) % len(many.t_min)
    many = replace(
        many,
        origin=many.origin[again],
        direction=many.direction[again],
        t_min=many.t_min[again],
        t_max=many.t_max[again],
    )
    found = answers(mesh, many, balanced_tree(mesh))
    assert not out_of_reach(every, many, found).any()
