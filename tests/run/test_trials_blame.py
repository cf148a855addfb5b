"""Whose fault is a stop by the clock?"""

import pytest

from grader import rounds
from grader.cli.progress import silent
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial
from grader.options import Options
from grader.rounds import budget_of
from grader.run.session import Allowance
from grader.run.trials import HURRIED_SECONDS, PATIENCE, Budget
from grader.score.rubric import load_rubric
from tests.verify.builder import soup

LIMITS = load_rubric().limits
TRIAL = ConstructTrial("a mesh", soup(9))
ALLOWED = Allowance(10.0, 30.0)
NOT_BEGUN = Ending(Stop.TIMED_OUT, "not run", 0.0, 0.0, "")


def late(cpu: float, delayed: float, seconds: float = 30.0) -> Ending:
    """A worker that the clock ended."""
    return Ending(
        Stop.TIMED_OUT, "stopped", seconds, cpu, "", by_clock=True, delayed_seconds=delayed
    )


@pytest.mark.parametrize(
    ("ending", "crowded"),
    [
        (late(0.1, 0.0), False),
        (late(0.1, 15.0), False),
        (late(5.0, 24.0), True),
        (late(9.9, 20.1), True),
        (late(10.0, 25.0), False),
        (late(11.0, 3.0, seconds=6.0), False),
    ],
    ids=["sleeps", "sleeps a bit", "starves", "nearly done", "computes", "threads"],
)
def test_standing_in_line_is_no_fault_of_the_submission(ending: Ending, crowded: bool) -> None:
    """Sleeping and computing count as use of its own time; waiting for a processor does not."""
    assert Budget(LIMITS, 100.0).blamed(TRIAL, ending, ALLOWED).crowded is crowded


def test_the_kernel_stops_a_little_early_and_means_it() -> None:
    """A worker that its CPU limit ended has had its time, whatever the figures say."""
    ending = Ending(Stop.TIMED_OUT, "stopped", 1.2, 0.9, "", delayed_seconds=0.4)
    assert not Budget(LIMITS, 100.0).blamed(TRIAL, ending, Allowance(1.0, 3.0)).crowded


def test_what_is_not_begun_is_the_fault_of_who_used_the_time() -> None:
    """Who sleeps in every case has used up the grade; who starves has not."""
    sleeper, starved = Budget(LIMITS, 100.0), Budget(LIMITS, 100.0)
    for _ in range(PATIENCE):
        sleeper.blamed(TRIAL, late(0.1, 0.0), ALLOWED)
        starved.blamed(TRIAL, late(2.0, 27.0), ALLOWED)
    assert not sleeper.blamed(TRIAL, NOT_BEGUN, None).crowded
    assert starved.blamed(TRIAL, NOT_BEGUN, None).crowded


@pytest.mark.parametrize("left", [-100.0, 0.0, 5.0])
def test_what_compiling_and_planning_took_is_nobodys_fault(left: float) -> None:
    """On a machine so busy that little or nothing was left before the first worker began."""
    budget = Budget(LIMITS, left, 100.0)
    assert budget.blamed(TRIAL, NOT_BEGUN, None).crowded
    budget.blamed(TRIAL, Ending(Stop.FINISHED, "", 4.0, 3.0, ""), ALLOWED)
    assert budget.blamed(TRIAL, NOT_BEGUN, None).crowded
    for _ in range(PATIENCE):
        budget.blamed(TRIAL, late(0.1, 0.0), ALLOWED)
    assert not budget.blamed(TRIAL, NOT_BEGUN, None).crowded


@pytest.mark.parametrize(("compiling", "crowded"), [(120.0, False), (15.0, True)])
def test_who_is_compiled_for_long_has_less_to_use_up(
    compiling: float, crowded: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 102 s a minute is gone, by two compilers at work or in line for a processor."""
    monkeypatch.setattr(rounds, "at_once", lambda: 2)
    budget = budget_of(LIMITS, Options(41, None, (), silent), 61.0, compiling)
    assert budget.blamed(TRIAL, NOT_BEGUN, None).crowded
    budget.blamed(TRIAL, Ending(Stop.FINISHED, "", 10.0, 10.0, ""), ALLOWED)
    assert budget.blamed(TRIAL, NOT_BEGUN, None).crowded is crowded


def test_standing_in_line_for_own_threads_is_use() -> None:
    """Sixty threads on one processor: each waits for the others, and all of them compute."""
    budget = Budget(LIMITS, 102.0)
    spinning = Ending(Stop.FINISHED, "", 8.0, 8.0, "", delayed_seconds=7.4)
    for _ in range(6):
        budget.blamed(TRIAL, spinning, ALLOWED)
    assert not budget.blamed(TRIAL, NOT_BEGUN, None).crowded


def test_the_end_of_the_grade_cuts_who_used_it_up() -> None:
    """A worker that had a second left is judged by what all of them have used."""
    cut = Allowance(10.0, 1.0)
    sleeper = Budget(LIMITS, 100.0)
    for _ in range(PATIENCE):
        sleeper.blamed(TRIAL, late(0.1, 0.0), ALLOWED)
    ended = sleeper.blamed(TRIAL, late(0.1, 0.0, seconds=1.0), cut)
    assert not ended.crowded
    # How much was left is another number in each run, so no words name it.
    assert ended.detail == "stopped when the time for the whole submission was used up"
    assert sleeper.blamed(TRIAL, late(0.1, 0.0), ALLOWED).detail == "stopped"
    assert Budget(LIMITS, 100.0).blamed(TRIAL, late(0.1, 0.0, seconds=1.0), cut).crowded


def test_the_end_of_the_grade_may_come_after_the_limit_of_cpu_time() -> None:
    """Who loops for half of the grade on a busy machine has used it up, and had no 10 s."""
    cut = Allowance(10.0, 15.0)
    endless, starved = Budget(LIMITS, 40.0), Budget(LIMITS, 100.0)
    ending = late(6.0, 6.0, seconds=15.0)
    assert not endless.blamed(TRIAL, ending, cut).crowded
    assert starved.blamed(TRIAL, ending, cut).crowded


def test_after_many_time_outs_the_others_are_hurried() -> None:
    """But not after those that are nobody's fault."""
    blamed, starved = Budget(LIMITS, 1000.0), Budget(LIMITS, 1000.0)
    for _ in range(PATIENCE):
        blamed.blamed(TRIAL, late(10.0, 0.0), ALLOWED)
        starved.blamed(TRIAL, late(5.0, 24.0), ALLOWED)
    hurried, patient = blamed.allowance(TRIAL), starved.allowance(TRIAL)
    assert hurried
    assert patient
    assert (hurried.cpu_seconds, patient.cpu_seconds) == (HURRIED_SECONDS, LIMITS.small_seconds)


@pytest.mark.parametrize("stop", [each for each in Stop if each is not Stop.TIMED_OUT])
def test_other_ends_have_nothing_to_do_with_the_clock(stop: Stop) -> None:
    """A crash on a busy machine is a crash."""
    ending = Ending(stop, "", 1.0, 1.0, "", delayed_seconds=0.9)
    assert Budget(LIMITS, 60.0).blamed(TRIAL, ending, ALLOWED) == ending
