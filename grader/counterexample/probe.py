"""Does a check still fail on this smaller trial, too? Many of them in one round trip.

Trials that share a process are only candidates: what a submission keeps from one to the next
may mislead. Whoever takes one asks `alone` before it is shown to anybody.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from grader.counterexample.cutting import cut_case
from grader.model.cases import (
    Case,
    HitCase,
    ImageCase,
    MemoryCase,
    RepeatCase,
    SurvivalCase,
    WorkCase,
)
from grader.model.path import Path
from grader.model.stages import Ending, Stop
from grader.model.trials import (
    AlteredTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
)
from grader.model.verdict import Evidence, Finding, Verdict
from grader.run.batches import run_batch
from grader.run.job import Job
from grader.run.requests import Single, request
from grader.run.session import Allowance, run_job
from grader.run.transfer import on_tree, record
from grader.run.trials import Engines, is_sanitized
from grader.verify import every_check
from grader.verify.check import Check
from grader.verify.engine import Examiner

TRIP_SECONDS = 1.0
"""CPU seconds of one process; honest candidates take 0.02."""

TRIPS = 40
"""Processes that one check may use. This bounds a reduction, and not the clock: it is the same
however busy the machine is."""

RESTARTS = 3
"""Candidates of one round that may end their process before the others are given up."""


class TooLate(Exception):
    """The clock ended a reduction; how far it came depends on the machine, so it is dropped."""


@dataclass(slots=True)
class Effort:
    """What one check may still use: processes, computing time, and behind both the clock."""

    deadline: float
    """Of `time.monotonic`."""

    seconds: float
    """CPU seconds of this thread and of the processes, which a busy machine does not change."""

    trips: int = TRIPS
    begun: float = field(default_factory=time.thread_time)

    def allowance(self) -> Allowance | None:
        """Take one process; None if none is left.

        Raises:
            TooLate: There is no time for it.
        """
        left = self.deadline - time.monotonic()
        if left <= 0 or time.thread_time() - self.begun > self.seconds:
            raise TooLate
        if not self.trips:
            return None
        self.trips -= 1
        return Allowance(TRIP_SECONDS, left)

    def spent(self, ending: Ending) -> None:
        """Take note of how a process ended.

        Raises:
            TooLate: The clock ended it, and not what it computed.
        """
        self.seconds -= ending.cpu_seconds
        if ending.stop is Stop.TIMED_OUT:
            if ending.by_clock:
                raise TooLate
            # There is no time to wait for a second one that does not come back.
            self.trips = 0


class Probe:
    """One check, and the builds on which it is tried."""

    def __init__(
        self, check: Check, engines: Engines, effort: Effort, stop: Stop | None
    ) -> None:
        """Prepare to ask.

        Args:
            check: It has failed somewhere.
            engines: The builds of the submission.
            effort: How much may be used.
            stop: How the worker ended in the case that failed; another end is another mistake.
                None takes any.
        """
        self.check_id = check.id
        self._check = check
        self._engines = engines
        self._effort = effort
        self._stop = stop
        self.dies = check.kind in (SurvivalCase, MemoryCase)
        """Whether the end of a worker is what fails, and not what it delivered."""
        self._seen: Evidence | None = None

    def first_failing(self, trials: Sequence[Single]) -> int | None:
        """Return the index of the first trial that fails, or None; they share processes."""
        begin = 0
        for _ in range(1 + RESTARTS):
            allowed = self._effort.allowance()
            engine = self._engines.of(trials[begin]) if begin < len(trials) else None
            if allowed is None or engine is None:
                return None
            delivery = run_batch(trials[begin:], engine, allowed)
            self._effort.spent(delivery.ending)
            for number, cases in enumerate(delivery.cases):
                if any(self.fails(case) for case in cases):
                    return begin + number
            begin += len(delivery.cases)
            if begin >= len(trials):
                return None
            if found := self.evidence(self._ended(trials[begin], delivery.ending)):
                self._seen = found
                return begin
            begin += 1
        return None

    def proof(self, trial: Trial) -> Evidence | None:
        """Ask about the trial that was chosen in the end.

        What does not come back is not waited for a second time.
        """
        if self._stop is Stop.TIMED_OUT and self._seen:
            return self._seen
        return self.alone(trial)

    def alone(self, trial: Trial) -> Evidence | None:
        """Ask about one trial in fresh processes, as a grade does; None if it does not fail."""
        for case in self.cases(trial):
            if found := self.evidence(case):
                return found
        return None

    def cases(self, trial: Trial) -> tuple[Case, ...]:
        """What one trial delivers in fresh processes; its ending is always among it."""
        engine = self._engines.of(trial)
        results, asked = [], request(trial)
        for job in asked.jobs:
            allowed = self._effort.allowance()
            if allowed is None or engine is None:
                return ()
            ending, result = run_job(job, engine, allowed)
            self._effort.spent(ending)
            if result is None:
                return (self._ended(trial, ending),)
            results.append(result)
        return (*asked.read(results, ending), self._ended(trial, ending))

    def path(self, trial: TraceTrial | AlteredTrial | ImageTrial, ray: int) -> Path | None:
        """Have the tests of one ray recorded; None if it did not come back."""
        allowed, engine, job = self._effort.allowance(), self._engines.of(trial), Job()
        if allowed is None or engine is None:
            return None
        read = record(job, on_tree(job, trial.mesh, trial.tree), trial.rays, ray)
        ending, result = run_job(job, engine, allowed)
        self._effort.spent(ending)
        return None if result is None else read(result)

    def wrong_ray(self, trial: TraceTrial | ImageTrial) -> int | None:
        """Return the index of a ray that fails by itself, as far as one run tells."""
        allowed, engine = self._effort.allowance(), self._engines.of(trial)
        if allowed is None or engine is None:
            return None
        delivery = run_batch([trial], engine, allowed)
        self._effort.spent(delivery.ending)
        for case in (case for cases in delivery.cases for case in cases):
            if isinstance(case, HitCase | ImageCase) and self.fails(case):
                return self._halved(case)
        return None

    def _halved(self, case: HitCase | ImageCase) -> int | None:
        """Divide the rays in two, again and again, and go on with the half that fails."""
        rays = np.arange(case.hits.t.size)
        while rays.size > 1:
            halves = np.array_split(rays, 2)
            wrong = [half for half in halves if self.fails(cut_case(case, half))]
            if not wrong:
                return None
            rays = wrong[0]
        return int(rays[0])

    def fails(self, case: Case) -> bool:
        """Tell whether the check fails on a case in the way that was seen before."""
        return self.evidence(case) is not None

    def evidence(self, case: Case) -> Evidence | None:
        """What the check says against a case; None if it does not fail."""
        found = decided(self._check, steady(case))
        if found is None or found.verdict is not Verdict.FAIL or not found.evidence.wrong:
            return None
        meant = not self.dies or self._stop in (None, found.evidence.stop)
        return found.evidence if meant else None

    def _ended(self, trial: Trial, ending: Ending) -> Case:
        kind = MemoryCase if is_sanitized(trial) else SurvivalCase
        return kind(trial.name, trial, ending)


def decided(check: Check, case: Case) -> Finding | None:
    """Decide a check on one case, and before it what it needs."""
    wanted = [each for each in every_check() if each.id == check.id or each.id in check.needs]
    found = [one for one in Examiner(wanted).examine([case]) if one.check == check.id]
    return found[0] if found else None


def steady(case: Case) -> Case:
    """Take out of a case what another run could see otherwise: times, and threads that meet."""
    if isinstance(case, WorkCase):
        return replace(case, cpu_seconds=0.0, reference_cpu_seconds=0.0)
    if isinstance(case, RepeatCase):
        quiet = tuple((when, hits) for when, hits in case.again if "threads" not in when)
        return replace(case, again=quiet)
    return case


def sizes(trial: Trial) -> tuple[int, int]:
    """Return how many faces and rays a trial has, those of both meshes if there are two."""
    if isinstance(trial, RebuildTrial):
        return len(trial.first.faces) + len(trial.second.faces), 0
    faces = len(trial.mesh.faces)
    if isinstance(trial, RepeatTrial):
        faces += len(trial.other_mesh.faces)
    rays = getattr(trial, "rays", None)
    return faces, 0 if rays is None else len(rays.t_min)
