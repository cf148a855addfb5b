"""A ray in the thicket visits all nodes, and has one right answer."""

import numpy as np

from grader.oracle.costs import plain_costs
from grader.oracle.embree import contradicted, embree_t
from grader.oracle.shapes import flatness
from grader.oracle.thicket import FACES, thicket, thicket_trial
from grader.tolerances import NEEDLE
from grader.verify.closest import is_ambiguous
from tests.oracle.treebuilder import tree_of


def test_no_tree_helps() -> None:
    """Every face is tested, more than 10,000 boxes are, and most answers are sure."""
    mesh = thicket(5)
    trial = thicket_trial(5, mesh, tree_of(mesh))
    boxes, triangles = plain_costs(trial.tree, trial.rays)
    assert boxes > 10_000
    assert triangles == len(mesh.faces) == FACES
    assert np.isfinite(trial.answers.limit).all()
    assert is_ambiguous(trial.answers).mean() < 0.2
    assert not contradicted(trial.rays, trial.answers, embree_t(mesh, trial.rays)).any()


def test_no_face_is_a_needle() -> None:
    """Hits are judged on triangles that float32 can decide."""
    mesh = thicket(6)
    assert flatness(mesh.vertices[mesh.faces].astype(np.float64)).max() < NEEDLE
