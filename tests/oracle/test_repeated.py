"""What is asked again can be told from what was answered before."""

import numpy as np

from grader.oracle.repeated import REPEATED, TWIN, repeat_trials
from tests.oracle.treebuilder import planted, tree_of


def test_the_last_ray_tells_one_mesh_from_the_other() -> None:
    """It hits one of the two only; answers belong to their rays."""
    names = {TWIN, *(name for pair in REPEATED for name in pair)}
    scenes = {name: planted(name) for name in names}
    trials = repeat_trials(
        7,
        {name: mesh for name, (mesh, _) in scenes.items()},
        {name: tree for name, (_, tree) in scenes.items()},
        lambda meshes: [tree_of(mesh) for mesh in meshes],
    )
    assert len(trials) == len(REPEATED) + 1
    for trial in trials:
        assert trial.answers.limit.size == len(trial.rays.t_min)
        last = (trial.answers.limit[-1], trial.other_answers.limit[-1])
        assert np.isfinite(last).sum() == 1
    twin = trials[-1]
    assert (twin.mesh.faces == twin.other_mesh.faces).all()
    assert (twin.mesh.vertices == -twin.other_mesh.vertices).all()
