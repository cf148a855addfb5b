"""Whose fault is a stop by the clock?"""

import pytest

from grader.model.grade import Limits
from grader.model.mesh import Mesh
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial
from grader.run import load
from grader.run.load import MachineLoad
from grader.run.session import Allowance
from grader.run.trials import PATIENCE, Budget
from grader.score.rubric import load_rubric
from tests.verify.builder import soup

LIMITS: Limits = load_rubric().limits
MESH: Mesh = soup(9)
TRIAL = ConstructTrial("a mesh", MESH)
ALLOWED = Allowance(10.0, 30.0)


def late(cpu_seconds: float = 0.1) -> Ending:
    """A worker that the clock ended."""
    return Ending(Stop.TIMED_OUT, "stopped after 30 s", 30.0, cpu_seconds, "")


def budget(monkeypatch: pytest.MonkeyPatch, *, crowded: bool) -> Budget:
    """A budget on a machine that others use, or do not."""
    monkeypatch.setattr(MachineLoad, "crowded", lambda _: crowded)
    return Budget(LIMITS, 60.0)


@pytest.mark.parametrize("crowded", [True, False])
@pytest.mark.parametrize("allowed", [ALLOWED, None])
def test_waiting_is_ours_only_on_a_crowded_machine(
    monkeypatch: pytest.MonkeyPatch, crowded: bool, allowed: Allowance | None
) -> None:
    """Stopped or not even begun: on an idle machine it was the submission that waited."""
    here = budget(monkeypatch, crowded=crowded)
    assert here.blamed(TRIAL, late(), allowed).crowded is crowded


def test_who_used_its_own_time_is_to_blame(monkeypatch: pytest.MonkeyPatch) -> None:
    """An endless loop stays one, however busy the machine is."""
    here = budget(monkeypatch, crowded=True)
    assert not here.blamed(TRIAL, late(10.0), ALLOWED).crowded


def test_who_used_its_own_time_often_is_to_blame_for_the_rest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What is left out after many endless loops is left out because of them."""
    here = budget(monkeypatch, crowded=True)
    for _ in range(PATIENCE):
        here.blamed(TRIAL, late(10.0), ALLOWED)
    assert not here.blamed(TRIAL, late(), None).crowded


@pytest.mark.parametrize("stop", [each for each in Stop if each is not Stop.TIMED_OUT])
def test_other_ends_have_nothing_to_do_with_the_clock(
    monkeypatch: pytest.MonkeyPatch, stop: Stop
) -> None:
    """A crash on a busy machine is a crash."""
    ending = Ending(stop, "", 1.0, 1.0, "")
    assert budget(monkeypatch, crowded=True).blamed(TRIAL, ending, ALLOWED) == ending


def test_own_work_is_not_that_of_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of ten seconds on every processor, what the grader and its children used is its own."""
    machine, own, clock = iter([100.0, 160.0]), iter([5.0, 15.0]), iter([0.0, 50.0])
    monkeypatch.setattr(load, "_machine_seconds", lambda: next(machine))
    monkeypatch.setattr(load, "_own_seconds", lambda: next(own))
    monkeypatch.setattr(load.time, "monotonic", lambda: next(clock))
    monkeypatch.setattr(load.os, "cpu_count", lambda: 2)
    assert MachineLoad().others() == pytest.approx(0.5)


def test_a_kernel_that_does_not_tell_proves_no_crowd(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without figures a stop by the clock counts as it always did."""
    monkeypatch.setattr(load, "_machine_seconds", lambda: 0.0)
    assert not MachineLoad().crowded()


def test_this_machine_tells() -> None:
    """The figures are read, and grow."""
    first = load._machine_seconds()
    sum(range(2_000_000))
    assert 0 < first <= load._machine_seconds()
