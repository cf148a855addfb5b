"""What is found in one part of the exercise explains nothing that fails in the other."""

from dataclasses import replace

import pytest

from grader.diagnose.causes import causes_by_part
from grader.diagnose.notes import Notes
from grader.model.cases import SurvivalCase
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial, Trial, part_of
from grader.model.verdict import Verdict
from tests.diagnose.test_hits import trial
from tests.report import samples
from tests.verify.builder import soup

SURVIVES = {"a": "bvh.survives-every-mesh", "b": "hits.survives-every-ray"}
WORK = "work.excludes-most-triangles"

TRIALS: tuple[Trial, ...] = (ConstructTrial("mesh", soup(9)), trial(1))


@pytest.mark.parametrize("given", TRIALS, ids=part_of)
def test_an_exception_explains_only_its_own_part(given: Trial) -> None:
    """All three checks are known to fail where something throws."""
    notes = Notes()
    thrown = Ending(Stop.CRASHED, "it threw an exception", 0, 0, "")
    notes.note(SurvivalCase("thrown", given, thrown))
    failed = [
        replace(samples.check(1), check=check, part=part, verdict=Verdict.FAIL)
        for part, check in (*SURVIVES.items(), ("b", WORK))
    ]
    causes = causes_by_part(notes, notes, failed)
    part = part_of(given)
    assert set(causes) == {SURVIVES[part], *([WORK] if part == "b" else [])}
    assert {cause.id for cause in causes.values()} == {"end.exception"}
