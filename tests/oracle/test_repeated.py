"""What is asked again can be told from what was answered before."""

import numpy as np

from grader.oracle.repeated import ALIKE, GROWING, REPEATED, TWIN, repeat_trials
from tests.oracle.treebuilder import planted, tree_of


def test_the_last_ray_tells_one_mesh_from_the_other() -> None:
    """It hits one of the two only, unless both are alike; answers belong to their rays."""
    names = {TWIN, *(name for pair in (*REPEATED, GROWING) for name in pair)}
    scenes = {name: planted(name) for name in names}
    trials = repeat_trials(
        7,
        {name: mesh for name, (mesh, _) in scenes.items()},
        {name: tree for name, (_, tree) in scenes.items()},
        lambda meshes: [tree_of(mesh) for mesh in meshes],
    )
    *others, reflection, reverse, growing = trials
    assert len(others) == len(REPEATED)
    for trial in (*others, reflection):
        assert trial.answers.limit.size == len(trial.rays.t_min)
        last = (trial.answers.limit[-1], trial.other_answers.limit[-1])
        assert np.isfinite(last).sum() == 1
    assert (reflection.mesh.faces == reflection.other_mesh.faces).all()
    mine, theirs = reflection.mesh.vertices, reflection.other_mesh.vertices
    assert (mine != theirs).any(axis=1).all()
    for end in (np.min, np.max):
        assert (end(mine, axis=0) == end(theirs, axis=0)).all()
    assert (reverse.mesh.faces[::-1] == reverse.other_mesh.faces).all()
    assert (reverse.answers.limit == reverse.other_answers.limit).all()
    assert [trial.sanitized for trial in trials] == [False] * (len(trials) - 1) + [True]
    assert growing.other_tree.node_count < growing.tree.node_count


def test_two_trees_differ_in_their_leaves_only() -> None:
    """Who keeps what is a leaf for as long as there are as many nodes is found out."""
    larger, smaller = (tree_of(planted(name)[0]) for name in ALIKE)
    assert larger.node_count == smaller.node_count
    filled = [np.count_nonzero(tree.end) for tree in (larger, smaller)]
    assert filled[0] > filled[1]
