"""A ray through an altered tree is told by what it found, not by what could be wrong."""

import numpy as np
import pytest

from grader.counterexample.describe import explanation
from grader.model.mesh import SOLID, Answers, Rays
from grader.model.trials import AlteredTrial
from tests.counterexample.paths import PILE, TREE, Walk

FACE = int(TREE.order[0])


def altered(lost: bool) -> AlteredTrial:
    """Ask for one ray that surely hits a face at t = 1, which the tree may not lead to."""
    ray = Rays(
        np.zeros((1, 3), np.float32),
        np.ones((1, 3), np.float32),
        np.zeros(1, np.float32),
        np.full(1, np.inf, np.float32),
    )
    answers = Answers(
        first=np.array([0, 1]),
        face=np.array([FACE]),
        t=np.ones(1),
        tolerance=np.full(1, 1e-3),
        kind=np.array([SOLID], np.uint8),
        limit=np.full(1, 1.001),
    )
    return AlteredTrial("altered", PILE, TREE, ray, answers, np.array([lost]), "a change")


@pytest.mark.parametrize(
    ("lost", "found", "words"),
    [
        (True, 1.0, "and yet it was found: not through the tree"),
        (True, np.inf, ""),
        (True, 5.0, ""),
        (False, 1.0, ""),
        (False, np.inf, "was never visited"),
        (False, 0.5, "no test of a face gave t = 0.5"),
    ],
)
def test_only_what_is_gone_and_was_found_went_around_the_tree(
    lost: bool, found: float, words: str
) -> None:
    """A ray that finds nothing there is right, and one whose face is left is like any other."""
    setting = Walk().box(0).setting(found)
    told = explanation(setting, altered(lost), 0).text
    assert words in told
    assert bool(told) == bool(words)
