"""Who had to wait too long runs again, and then alone."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import cast

import pytest

from grader.model.cases import SurvivalCase
from grader.model.stages import Ending, Stop
from grader.model.trials import WorkTrial
from grader.run import trials as module
from grader.run.session import Engine
from grader.run.trials import Budget, Engines, run_trials
from grader.sandbox.turns import Turns
from tests.run.test_trials_blame import LIMITS, TRIAL

PATIENCE = 60.0
"""Seconds for another thread to begin."""

LATE = Ending(Stop.TIMED_OUT, "", 1.0, 0.0, "")


class Tried:
    """Notes who ran beside whom, and how the first try of a trial ended."""

    def __init__(self, first: Ending) -> None:
        self.first = first
        self.running: list[str] = []
        self.seen: list[tuple[str, int]] = []
        self.lock = threading.Lock()

    def __call__(self, trial: WorkTrial, *_: object) -> tuple[SurvivalCase, ...]:
        """Stand in for a worker."""
        with self.lock:
            self.running.append(trial.name)
        time.sleep(0.02)
        with self.lock:
            self.seen.append((trial.name, len(self.running)))
            self.running.remove(trial.name)
            again = [name for name, _ in self.seen].count(trial.name) > 1
        end = replace(LATE, stop=Stop.FINISHED) if again else self.first
        return (SurvivalCase(trial.name, trial, end),)


@pytest.mark.parametrize("crowded", [True, False])
def test_who_was_crowded_is_tried_alone(crowded: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second try has the machine for itself; who used up its time has no second one."""
    tried = Tried(replace(LATE, crowded=crowded))
    monkeypatch.setattr(module, "_tried", tried)
    monkeypatch.setattr(module, "at_once", lambda: 2)
    monkeypatch.setattr(Engines, "of", lambda *_: object())
    trials = [replace(TRIAL, name=str(number)) for number in range(6)]
    engines = Engines(cast(Engine, None))
    cases = run_trials(trials, engines, Budget(LIMITS, 100.0), lambda *_: None)
    stops = [case.ending.stop for (case,) in cases if isinstance(case, SurvivalCase)]
    assert stops == [Stop.FINISHED if crowded else Stop.TIMED_OUT] * 6
    names = [name for name, _ in tried.seen]
    assert len(names) == (12 if crowded else 6)
    second = [n for k, (name, n) in enumerate(tried.seen) if name in names[:k]]
    assert set(second) <= {1}


def test_nobody_begins_while_one_wants_to_be_alone() -> None:
    """The one that waits comes next, however many others there are."""
    turns, told = Turns(), list[str]()

    def alone() -> None:
        with turns.alone():
            told.append("alone")

    def beside() -> None:
        with turns.shared():
            told.append("beside")

    with ThreadPoolExecutor(2) as pool:
        with turns.shared():
            first = pool.submit(alone)
            end = time.monotonic() + PATIENCE
            while turns.wanted == 0:
                assert time.monotonic() < end, "nobody wants to be alone"
                time.sleep(0.001)
            second = pool.submit(beside)
            time.sleep(0.05)
            assert told == []
        first.result(5)
        second.result(5)
    assert told == ["alone", "beside"]
