"""Does a submission still fail on a counterexample? One trial of one check, from a file."""

import time
from pathlib import Path

import numpy as np

from grader.counterexample.describe import described
from grader.counterexample.probe import Effort, Probe, TooLate, decided, steady
from grader.counterexample.reading import read
from grader.counterexample.revived import trial_of
from grader.counterexample.search import model_passes
from grader.errors import GraderError, UsageError
from grader.faults import noted
from grader.model.cases import MemoryCase, SurvivalCase
from grader.model.counterexample import Replay
from grader.model.trials import Trial
from grader.model.verdict import Verdict
from grader.options import Options
from grader.pipeline import engines_for
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.solution import Solution
from grader.verify import every_check
from grader.verify.check import Check
from grader.verify.planned import kinds_of

PATIENCE = 30.0
"""Wall seconds, and CPU seconds, that showing one counterexample may take."""

CHANGED = "the model solution fails on this input, too: the file was changed"


def replay(path: Path, file: Path, options: Options) -> Replay:
    """Run a submission on the input of a file.

    Raises:
        UsageError: The file is no counterexample, or of a check that does not exist.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    content = read(file)
    checks = {each.id: each for each in every_check()}
    if content.check not in checks:
        raise UsageError(f"{file}: there is no check {content.check}")
    check, trial = checks[content.check], trial_of(content)
    if check.kind not in kinds_of(trial) or not check.when(trial):
        raise UsageError(f"{file}: {check.id} has nothing to say of such an input")
    with scratch_folder() as folder, Nursery() as nursery:
        engines = engines_for(path, folder, nursery, options, trial)
        if isinstance(engines, str):
            return Replay(check.id, check.title, None, engines)
        probe = Probe(check, engines, Effort(time.monotonic() + PATIENCE, PATIENCE), None)
        with np.errstate(all="ignore"):
            try:
                return _judged(check, probe, trial)
            except TooLate:
                # A sleep and a machine that is too busy look alike here.
                late = f"it did not come back within {PATIENCE:g} s"
                return Replay(check.id, check.title, None, late, is_ours=True)


def _judged(check: Check, probe: Probe, trial: Trial) -> Replay:
    """Decide the check on what the trial delivers; only what was decided can be a pass.

    Whatever speaks against a submission is told only if the model solution passes.

    Raises:
        TooLate: The clock ended it.
        GraderError: The check itself failed.
    """
    cases = probe.cases(trial)
    findings = [one for case in cases if (one := decided(check, steady(case)))]
    first = {one.verdict: one for one in reversed(findings)}
    failed = first.get(Verdict.FAIL)
    if not failed and (broken := first.get(Verdict.BROKEN)):
        raise GraderError(f"{check.id}: {broken.reason}\n{noted(broken.traceback)}")
    if not failed and Verdict.PASS in first:
        return Replay(check.id, check.title, None)
    if not model_passes(check, Solution(), trial):
        # Anybody may have edited the tree or the mesh in the file.
        return Replay(check.id, check.title, None, CHANGED, is_ours=True)
    if failed:
        found = described(probe, trial, trial.name, failed.evidence)
        return Replay(check.id, check.title, found)
    if blocked := first.get(Verdict.BLOCKED):
        why = f"it cannot be decided, because {blocked.reason} fails on this input"
        return Replay(check.id, check.title, None, why)
    details = [one.ending.detail for one in cases if isinstance(one, SurvivalCase | MemoryCase)]
    why = details[0] if details else "the build that this check runs could not be made"
    return Replay(check.id, check.title, None, why or "there is nothing here to decide it by")
