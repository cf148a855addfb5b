"""The smallest inputs of failures, made by hand."""

from dataclasses import replace

from grader.model.counterexample import Column, Counterexample, NodeTable
from grader.model.trials import ConstructTrial
from tests.verify.builder import soup


def small_trace() -> Counterexample:
    """The smallest input of a failure in part b."""
    return replace(
        small(),
        check="hits.closest-wins",
        rays=1,
        message="ray 0: t is 2.5, but face 1 is hit at 1.5",
        explanation="node 2, on the way to face 1, was never visited after node 0",
        table=NodeTable(
            columns=(Column(0, "hit", "hit"), Column(1, "miss", "miss"), Column(2, "hit", "-")),
            expected_faces="3 0 | 4 2 1",
            got_faces="",
            first_difference=2,
        ),
        expected="a hit on face 1 at t = 1.5",
        got="t is 2.5",
    )


def small() -> Counterexample:
    """The smallest input of a failure."""
    return Counterexample(
        check="bvh.boxes-are-tight",
        trial=ConstructTrial("tree over strip-x", soup(5)),
        faces=5,
        rays=0,
        found_in="tree over strip-x",
        message="node 1: box is too small",
        expected="node 1 box.max = (0.5, 1, 0)",
        got="node 1 box.max = (0.25, 1, 0)",
        table=NodeTable(
            columns=tuple(Column(node, "[0,9)", "[0,9)") for node in range(7)),
            expected_faces="3 2 | 1 0 4",
            got_faces="0 4 | 1 2 3",
            first_difference=1,
        ),
    )
