"""The cause of a visible check tells nothing of what hidden ones look at."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from grader.model.cases import HitCase
from grader.model.grade import Cause
from grader.model.mesh import Hits
from grader.options import Options
from grader.selection import select
from grader.summary import Summary
from tests.diagnose.test_hits import CLOSEST, RAYS, farthest, table, trial
from tests.report import samples
from tests.test_selection import hiding

SPECIAL, RECORD = "hits.special-rays", "hits.record-is-complete"


def causes(rubric: Path | None) -> dict[str, Cause | None]:
    """Grade a search that keeps the farthest hit on ordinary trials and on a special one."""
    selection = select(rubric, ())
    summary = Summary(selection, Options(1, None, (), lambda *_: None), "none")
    trials = (trial(1), trial(2), replace(trial(0), name="limits", special=True))
    nothing = np.zeros((RAYS, 3), np.float32)
    for given in trials:
        t = farthest(given, table(given)).astype(np.float32)
        summary.examine([HitCase(given.name, given, Hits(nothing, t, nothing))])
    grade = summary.grade(samples.SUBMISSION, samples.BUILD, trials)
    return {one.check: one.cause for one in grade.checks}


def places(cause: Cause | None) -> int:
    """How many places a cause was found in."""
    assert cause
    return cause.places


def test_hidden_cases_are_not_counted_for_a_visible_check(tmp_path: Path) -> None:
    """They are for the hidden one, which only a teacher sees."""
    everywhere = causes(None)
    assert everywhere[CLOSEST] == everywhere[SPECIAL]
    hidden = causes(hiding(tmp_path, SPECIAL, RECORD))
    assert 0 < places(hidden[CLOSEST]) < places(everywhere[CLOSEST])
    assert hidden[SPECIAL] == everywhere[SPECIAL]


def test_a_visible_check_keeps_the_cases_that_visible_ones_look_at(tmp_path: Path) -> None:
    """The points and normals of special rays are looked at by a check that is not hidden."""
    assert causes(hiding(tmp_path, SPECIAL))[CLOSEST] == causes(None)[CLOSEST]
