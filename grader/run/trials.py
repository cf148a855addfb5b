"""How all trials of a submission are run, two workers at a time, within one budget."""

import os
import threading
import time
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

from grader.model.cases import Case, MemoryCase, SurvivalCase
from grader.model.grade import Limits
from grader.model.stages import Ending, Further, Stop
from grader.model.trials import (
    ConstructTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    part_of,
)
from grader.run.requests import request
from grader.run.session import Allowance, Engine, run_job
from grader.sandbox.turns import Turns
from grader.tolerances import LARGE_MESH

HUGE_MESH = 1_000_000
"""Beyond this the time limit grows with the faces."""

WORKERS = 2
"""More at once would take memory and time from each other."""

HURRIED_SECONDS = 1.0
OWN_SHARE = 0.4
"""Who used less of the grade's time than this, all workers together, did not use it up.

Two workers at a time can use 2; right submissions use about 0.1.
"""

_SHARES = (("a", 2), ("b", 1))
"""What is left of the time, by part: a half of it, and all."""

_CUT = "stopped when the time for the whole submission was used up"

PATIENCE = 3
"""After this many time-outs in one part the other trials of it get `HURRIED_SECONDS`."""


@dataclass(frozen=True, slots=True)
class Engines:
    """The builds of one submission; a missing one leaves out its trials."""

    graded: Engine
    sanitized: Engine | None = None
    """For part a, with a small depth limit."""

    deep: Engine | None = None
    """For part b, sanitized too, with the real depth limit: trees there are deeper."""

    def of(self, trial: Trial) -> Engine | None:
        """Choose the build that a trial runs on."""
        match build_of(trial):
            case Further.SANITIZED:
                return self.sanitized
            case Further.DEEP:
                return self.deep
        return self.graded


def build_of(trial: Trial) -> Further | None:
    """Name the build that a trial runs on; None for the graded one."""
    if not is_sanitized(trial):
        return None
    return Further.SANITIZED if part_of(trial) == "a" else Further.DEEP


def is_sanitized(trial: Trial) -> bool:
    """Whether a trial runs on the build with sanitizers."""
    kinds = ConstructTrial | RebuildTrial | TraceTrial | RepeatTrial
    return isinstance(trial, kinds) and trial.sanitized


class Budget:
    """How long the next worker may take, given what the others used."""

    def __init__(self, limits: Limits, seconds: float, whole: float = 0.0) -> None:
        """Begin now.

        Args:
            limits: Of each worker.
            seconds: Wall time that is left for all of them together; may be negative.
            whole: What there was of it when the grade began, without what the submission used
                for itself since then, if that is more.
        """
        self._limits = limits
        begun = time.monotonic()
        # What compiling and planning took on a busy machine is nobody's use of time: a share of
        # the rest, which may be nothing, would blame whoever ran at all.
        self._enough = {part: OWN_SHARE * max(seconds, whole) / n for part, n in _SHARES}
        # What part a uses up must not be missing in part b.
        self._deadline = {part: begun + seconds / n for part, n in _SHARES}
        self._used = {"a": 0.0, "b": 0.0}
        self._timeouts = {"a": 0, "b": 0}
        self._lock = threading.Lock()

    def allowance(self, trial: Trial) -> Allowance | None:
        """How long a trial may take; None if no time is left."""
        mesh = trial.first if isinstance(trial, RebuildTrial) else trial.mesh
        faces = len(mesh.faces)
        allowed = self._limits.small_seconds
        if faces > LARGE_MESH:
            allowed = self._limits.large_seconds * max(1.0, faces / HUGE_MESH)
        with self._lock:
            if self._timeouts[part_of(trial)] >= PATIENCE:
                allowed = HURRIED_SECONDS
        left = self._deadline[part_of(trial)] - time.monotonic()
        wall = min(allowed * self._limits.wall_factor, left)
        return Allowance(allowed, wall) if left > 0 else None

    def blamed(self, trial: Trial, ending: Ending, allowed: Allowance | None) -> Ending:
        """Remember how a trial ended, and tell whether a time-out is the submission's.

        Args:
            trial: What was to be done.
            ending: How that ended.
            allowed: What it was given; None if it was not even begun.
        """
        # Sleeping counts as use; standing in line does not, but for one's own other threads.
        own = max(ending.seconds - ending.delayed_seconds, ending.cpu_seconds)
        part = part_of(trial)
        enough = self._enough[part]
        with self._lock:
            self._used[part] += own
            if ending.stop is not Stop.TIMED_OUT:
                return ending
            if allowed is None:
                return replace(ending, crowded=self._used[part] < enough)
            cut = allowed.wall_seconds < allowed.cpu_seconds * self._limits.wall_factor
            if ending.by_clock and cut:
                # What was left is another number in each run.
                ending = replace(ending, detail=_CUT)
            if ending.by_clock and max(own, ending.cpu_seconds) < allowed.cpu_seconds:
                # The wall limit is a multiple of the CPU limit, so it did not get its time;
                # or the end of the whole grade came first.
                late = cut and self._used[part] >= enough
                return replace(ending, crowded=not late)
            self._timeouts[part] += 1
        return ending


def at_once() -> int:
    """How many processes of a submission run at the same time."""
    return min(WORKERS, len(os.sched_getaffinity(0)))


def run_trials(
    trials: Sequence[Trial],
    engines: Engines,
    budget: Budget,
    progress: Callable[[int, int], None],
) -> Iterable[tuple[Case, ...]]:
    """Run every trial in a process of its own; yields their cases in the order of `trials`."""
    runnable = [trial for trial in trials if engines.of(trial)]
    turns = Turns()
    with ThreadPoolExecutor(at_once()) as pool:
        futures = [pool.submit(_run, trial, engines, budget, turns) for trial in runnable]
        try:
            for number, future in enumerate(futures):
                progress(number, len(futures))
                yield future.result()
        finally:
            for future in futures:
                future.cancel()


def _run(trial: Trial, engines: Engines, budget: Budget, turns: Turns) -> tuple[Case, ...]:
    """Run a trial; once more and alone if it had to wait too long.

    For whom it waited may have been the other worker of the same submission.
    """
    with turns.shared():
        cases = _tried(trial, engines, budget)
    ends = [case.ending for case in cases if isinstance(case, SurvivalCase | MemoryCase)]
    if not any(ending.crowded for ending in ends):
        return cases
    with turns.alone():
        return _tried(trial, engines, budget)


def _tried(trial: Trial, engines: Engines, budget: Budget) -> tuple[Case, ...]:
    engine = engines.of(trial)
    if engine is None:
        return ()
    allowed = budget.allowance(trial)
    if allowed is None:
        detail = "not run: the time for the whole submission was used up"
        late = Ending(Stop.TIMED_OUT, detail, 0.0, 0.0, "")
        return _ended(trial, budget.blamed(trial, late, None))
    asked = request(trial)
    results = []
    for job in asked.jobs:
        ending, result = run_job(job, engine, allowed)
        if result is None:
            return _ended(trial, budget.blamed(trial, ending, allowed))
        results.append(result)
        budget.blamed(trial, ending, allowed)
    return (*_ended(trial, ending), *asked.read(results, ending))


def _ended(trial: Trial, ending: Ending) -> tuple[Case, ...]:
    kind = MemoryCase if is_sanitized(trial) else SurvivalCase
    return (kind(trial.name, trial, ending),)
