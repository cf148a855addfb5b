"""The next wrong node is found, or it is said why there is none."""

from types import SimpleNamespace
from typing import Any, cast

import pytest

from grader.phrases import teller
from grader.view.desk import Desk
from grader.view.nodes import Nodes
from grader.view.stage import Stage, State
from grader.view.study import Study
from tests.verify.builder import build, changed, soup
from tests.view.shown import of_mesh, until

MESH = soup(40)
BAD = changed(build(MESH), "high", (4, 0), 99.0)
DESK = cast("Desk", SimpleNamespace(level=0, deepest=3, stage=None))


def stage_of(tree: Any, state: State) -> Stage:  # noqa: ANN401 - a tree, or none
    """Give what takes the place of a stage."""
    made = SimpleNamespace(state=state, subject=of_mesh(MESH), tree=tree)
    return cast("Stage", made)


def test_who_asks_for_the_next_one_is_told_that_it_is_looked_for() -> None:
    """Until the judgement comes, which takes long on a large mesh; then it is looked at."""
    stage, study = stage_of(BAD, State.TRACING), Study(DESK)
    study._stage = stage
    study.next_node()
    assert study.remark == "looking at every node ..."
    until(lambda: study.facts is not None, lambda: study._judge(stage))
    assert study.facts is not None
    assert study.facts.node == 4
    assert study.remark == ""
    study.close()


@pytest.mark.parametrize("stage", [None, stage_of(None, State.ENDED)], ids=["none", "crashed"])
def test_where_there_is_no_tree_that_is_said(stage: Stage | None) -> None:
    """Nobody waits for what will not come."""
    nodes = Nodes(DESK, str, str)
    assert nodes.next_wrong(stage) == "there is no tree"
    assert not nodes.goes_on
    nodes.close()


def test_while_construct_runs_the_tree_is_waited_for() -> None:
    """It is judged once it is there."""
    nodes = Nodes(DESK, str, str)
    assert nodes.next_wrong(stage_of(None, State.CONSTRUCTING)) == "looking at every node ..."
    assert nodes.goes_on
    nodes.close()


def test_what_is_wrong_is_told_in_the_language_of_the_rest() -> None:
    """The sentences of the checks and those of the inspector."""
    stage = stage_of(changed(BAD, "high", (0, 1), 99.0), State.TRACING)
    nodes = Nodes(DESK, str, teller("de"))
    nodes.goes_on = True
    until(lambda: nodes.known is not None, lambda: nodes.advance(stage))
    nodes.select(stage, 4)
    assert nodes.facts is not None
    assert nodes.facts.faults[0].startswith("seine Dreiecke reichen von (")
    nodes.select(stage, 0)
    assert nodes.facts.faults[0].startswith("Knoten 0: die Box ist ")
    nodes.close()
