"""Which checks and trials a run has: what a rubric drops, and what it hides from students."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.model.cases import DepthCase
from grader.model.stages import Further
from grader.model.trials import ImageTrial, TraceTrial, Trial
from grader.oracle.plan import deeper_trials
from grader.run.trials import build_of
from grader.score.rubric import SHIPPED
from grader.selection import Selection, select
from grader.solution import Solution
from grader.verify import every_check
from grader.verify.planned import kinds_of
from tests.verify.trials import every_trial

EVERY = [each.id for each in every_check()]


def hiding(folder: Path, *checks: str, how: str = "hidden") -> Path:
    """Write the shipped rubric with some checks hidden."""
    text = SHIPPED.read_text()
    for check in checks:
        head, found, tail = text.partition(f'check = "{check}"\n')
        assert found
        text = f'{head}{found}visibility = "{how}"\n{tail}'
    path = folder / "rubric.toml"
    path.write_text(text)
    return path


def run(selection: Selection) -> list[str]:
    """Ids of the checks that are decided."""
    return [each.id for each in selection.checks]


def scored(selection: Selection) -> list[str]:
    """Ids of the checks that a result tells of."""
    return [criterion.check for criterion in selection.rubric.criteria]


@pytest.mark.parametrize("how", ["hidden", "after_due_date"])
def test_a_student_s_run_leaves_out_what_is_hidden(tmp_path: Path, how: str) -> None:
    """It is neither decided nor told of; a teacher's run has everything."""
    rubric = hiding(tmp_path, "bvh.boxes-are-tight", "image.equals-mitsuba", how=how)
    student, teacher = select(rubric, (), for_student=True), select(rubric, ())
    rest = [id for id in EVERY if id not in ("bvh.boxes-are-tight", "image.equals-mitsuba")]
    assert run(student) == rest
    assert set(scored(student)) == set(rest)
    assert student.hidden == ("bvh.boxes-are-tight", "image.equals-mitsuba")
    assert run(teacher) == EVERY
    assert set(scored(teacher)) == set(EVERY)
    assert teacher.hidden == ()


def test_trials_of_hidden_checks_are_not_run(tmp_path: Path) -> None:
    """No input that only a hidden check looks at reaches a student's machine code."""
    of_rebuild = (
        "bvh.rebuild-starts-afresh",
        "bvh.survives-every-mesh",
        "bvh.memory-is-safe",
    )
    student = select(hiding(tmp_path, *of_rebuild), (), for_student=True)
    kinds = {type(trial).__name__ for trial in student.useful(every_trial())}
    assert kinds == {
        "ConstructTrial",
        "TraceTrial",
        "AlteredTrial",
        "WorkTrial",
        "RepeatTrial",
        "ImageTrial",
    }


@pytest.mark.parametrize(
    ("hidden", "lost"),
    [
        ("bvh.splits-at-the-median", {"bvh.splits-the-longest-axis"}),
        ("hits.closest-wins", set()),
        (
            "work.uses-the-tree",
            {id for id in EVERY if id.startswith(("hits.", "image."))}
            - {"hits.memory-is-safe", "hits.survives-every-ray"},
        ),
    ],
)
def test_what_waits_for_a_hidden_check_is_hidden_too(
    tmp_path: Path, hidden: str, lost: set[str]
) -> None:
    """By waiting it would say that the hidden one fails."""
    student = select(hiding(tmp_path, hidden), (), for_student=True)
    assert set(student.hidden) == {hidden} | lost
    assert set(run(student)) == set(EVERY) - {hidden} - lost


def test_a_hidden_check_cannot_be_asked_for(tmp_path: Path) -> None:
    """Neither it nor what waits for it; a teacher may."""
    rubric = hiding(tmp_path, "bvh.splits-at-the-median")
    for id in ("bvh.splits-at-the-median", "bvh.splits-the-longest-axis"):
        with pytest.raises(UsageError, match="hides this check"):
            select(rubric, (id,), for_student=True)
        assert id in scored(select(rubric, (id,)))


def test_a_rubric_that_hides_everything_leaves_nothing_to_run(tmp_path: Path) -> None:
    """That is said, and not graded as zero of zero."""
    rubric = hiding(tmp_path, *EVERY)
    with pytest.raises(UsageError, match="hides every check"):
        select(rubric, (), for_student=True)


def test_what_may_be_named_as_a_reason_is_decided_too() -> None:
    """Else a tree without any order would be our own fault, and the score withheld."""
    only = select(None, ("bvh.splits-the-longest-axis",))
    assert "bvh.splits-at-the-median" in run(only)
    assert "bvh.splits-at-the-median" not in scored(only)


def further(*only: str) -> set[str]:
    """What is made for some checks beside the graded library."""
    return {one.value for one in select(None, only).further}


@pytest.mark.parametrize(
    ("only", "made"),
    [
        ("bvh.boxes-are-tight", {"sanitized"}),
        ("source.construct-loops", set()),
        ("bvh.rebuild-starts-afresh", set()),
        ("work.uses-the-tree", set()),
        ("hits.special-rays", set()),
        ("bvh.depth-is-limited", {"sanitized"}),
        ("bvh.memory-is-safe", {"sanitized"}),
        ("hits.closest-wins", {"sanitized"}),
        ("hits.memory-is-safe", {"sanitized", "deep"}),
    ],
)
def test_only_the_builds_of_the_asked_checks_are_made(only: str, made: set[str]) -> None:
    """And the call graph, which names the lines of functions in every report."""
    assert further(only) == {"calls"} | made


def test_a_whole_run_has_every_build() -> None:
    """No check of a grade waits for something that was not made."""
    assert select(None, ()).further == frozenset(Further)


@cache
def planned() -> tuple[Sequence[Trial], Sequence[Trial]]:
    """Draw the trials of a seed, and those on deeper trees."""
    return Solution().plan(41).trials, deeper_trials(41)


@pytest.mark.parametrize("id", EVERY)
def test_every_trial_of_a_run_has_its_build(id: str) -> None:
    """No check passes or fails because a build was left out, and none is made for nothing."""
    selection = select(None, (id,))
    needed = {build_of(trial) for trial in selection.useful([*planned()[0], *planned()[1]])}
    # Where nothing runs and nobody asks who calls whom, no function is named.
    calls = set() if id == "build.compiles" else {Further.CALLS}
    assert {None, *selection.further} == {None, *calls, *needed}


@pytest.mark.parametrize("id", EVERY)
def test_who_looks_at_deep_trees_learns_whether_they_are_asked_for(id: str) -> None:
    """Trees of part a tell that, even where the check of the run does not look at them."""
    selection = select(None, (id,))
    depths = [trial for trial in planned()[0] if DepthCase in kinds_of(trial)]
    (check,) = (each for each in every_check() if each.id == id)
    looks = any(check.kind in kinds_of(trial) and check.when(trial) for trial in depths)
    wanted = depths if looks or selection.useful(planned()[1]) else ()
    assert selection.useful(depths) == tuple(wanted)


def test_a_gate_of_the_other_part_is_not_run() -> None:
    """It closes nothing that was asked for; that of the whole file is."""
    gates = {"build.compiles", "bvh.is-readable", "work.uses-the-tree"}
    assert gates & set(run(select(None, ("hits.closest-wins",)))) == {
        "build.compiles",
        "work.uses-the-tree",
    }
    assert gates & set(run(select(None, ("bvh.boxes-are-tight",)))) == {
        "build.compiles",
        "bvh.is-readable",
    }
    assert gates <= set(run(select(None, ("hits.closest-wins", "bvh.boxes-are-tight"))))


def test_a_hidden_scene_is_not_run_for_a_student() -> None:
    """Whoever grades runs it; and a visible one is run for everybody."""
    (image,) = (trial for trial in every_trial() if isinstance(trial, ImageTrial))
    hidden = replace(image, shown=False)
    assert select(None, (), for_student=True).useful([image, hidden]) == (image,)
    assert select(None, ()).useful([image, hidden]) == (image, hidden)


SPECIAL = "hits.special-rays"
OF_SPECIAL_RAYS = (SPECIAL, "hits.record-is-complete")
"""All that look at what special rays hit."""


def test_a_visible_check_of_endings_tells_nothing_of_a_hidden_one_s_trials(
    tmp_path: Path,
) -> None:
    """It looks at all trials, and whoever crashes on purpose would learn their inputs."""
    trials = planned()[0]
    traces = [trial for trial in trials if isinstance(trial, TraceTrial)]
    special = {trial.name for trial in traces if "special rays" in trial.name}
    assert special
    hidden = select(hiding(tmp_path, *OF_SPECIAL_RAYS), (), for_student=True)
    assert not special & {trial.name for trial in hidden.useful(trials)}
    open_to_all = select(hiding(tmp_path, SPECIAL), (), for_student=True)
    assert special <= {trial.name for trial in open_to_all.useful(trials)}
    teacher = select(hiding(tmp_path, *OF_SPECIAL_RAYS), ())
    assert special <= {trial.name for trial in teacher.useful(trials)}
    assert special == {trial.name for trial in trials if teacher.is_secret(trial)}
