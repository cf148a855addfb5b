"""What is planned for a check is what its trials really deliver."""

import mmap
from collections import Counter
from dataclasses import replace

import pytest

from grader.model.cases import (
    BuildCase,
    Case,
    DepthCase,
    MemoryCase,
    SourceCase,
    SurvivalCase,
)
from grader.model.stages import Ending, Stop
from grader.model.trials import ImageTrial, Trial
from grader.run.job import Result
from grader.run.requests import request
from grader.run.trials import is_sanitized
from grader.verify import every_check
from grader.verify.planned import kinds_of, planned_cases
from tests.verify.trials import construct, every_trial

DEEP = (4 << 20) + 1
ENDED = Ending(Stop.FINISHED, "", 1.0, 1.0, "")


class Zeros(Result):
    """A result in which the worker wrote nothing."""

    def __init__(self, size: int) -> None:
        self._memory = mmap.mmap(-1, size)


def delivered(trial: Trial) -> tuple[Case, ...]:
    """Make the cases that a trial gives when its worker finishes."""
    asked = request(trial)
    cases = asked.read([Zeros(job.result_size) for job in asked.jobs], ENDED)
    ended = (MemoryCase if is_sanitized(trial) else SurvivalCase)(trial.name, trial, ENDED)
    return (ended, *cases)


@pytest.mark.parametrize("trial", every_trial(), ids=lambda trial: trial.name)
def test_each_trial_delivers_the_planned_kinds(trial: Trial) -> None:
    """The plan and the requests agree on the kinds; each case bears the name of its trial."""
    cases = delivered(trial)
    assert Counter(type(case) for case in cases) == Counter(kinds_of(trial))
    assert {case.name for case in cases} == {trial.name}


def test_each_check_sees_as_many_cases_as_planned() -> None:
    """Counted by the checks' own conditions over all that the trials deliver."""
    trials = every_trial()
    cases = [(trial, case) for trial in trials for case in delivered(trial)]
    for each in every_check():
        if each.kind in (BuildCase, SourceCase):
            continue
        shown = sum(isinstance(case, each.kind) and each.when(trial) for trial, case in cases)
        assert planned_cases([each], trials) == {each.id: shown}


def test_every_kind_of_case_is_delivered() -> None:
    """No check waits for a kind of case that no trial gives."""
    kinds = {kind for trial in every_trial() for kind in kinds_of(trial)}
    assert {each.kind for each in every_check()} == kinds | {BuildCase, SourceCase}


def test_the_build_and_the_source_are_looked_at_once() -> None:
    """Without any trial nothing was compiled, so that there are no calls to look at."""
    planned = planned_cases(every_check(), ())
    assert {id: count for id, count in planned.items() if count} == {"build.compiles": 1}
    planned = planned_cases(every_check(), [construct(9)])
    assert planned["build.compiles"] == planned["source.construct-loops"] == 1


@pytest.mark.parametrize(
    ("faces", "sanitized", "limited"),
    [(256, True, False), (257, True, True), (DEEP - 1, False, False), (DEEP, False, True)],
)
def test_the_depth_is_looked_at_where_faces_do_not_fit(
    faces: int, sanitized: bool, limited: bool
) -> None:
    """4 x 2^limit faces fit into a tree that deep; one more does not."""
    assert (DepthCase in kinds_of(construct(faces, sanitized))) is limited


def test_the_large_mesh_replaces_the_small_ones() -> None:
    """Once a submission needed the full depth, small meshes do not count for it."""
    small = [construct(257, sanitized=True), construct(300, sanitized=True)]
    depth = [each for each in every_check() if each.kind is DepthCase]
    assert planned_cases(depth, small) == {"bvh.depth-is-limited": 2}
    assert planned_cases(depth, [*small, construct(DEEP)]) == {"bvh.depth-is-limited": 1}


def test_a_picture_counts_as_its_weight_says() -> None:
    """In every check that looks at it; all else counts once."""
    checks = [each for each in every_check() if each.id.startswith(("image.", "hits.surv"))]
    (image,) = (trial for trial in every_trial() if isinstance(trial, ImageTrial))
    heavy = replace(image, name="heavy", weight=2.5)
    assert planned_cases(checks, [image, heavy]) == {each.id: 3.5 for each in checks}
