"""Does a submission still fail on a counterexample? One trial of one check, from a file."""

import time
from pathlib import Path

import numpy as np

from grader.counterexample.describe import described
from grader.counterexample.probe import Effort, Probe
from grader.counterexample.reading import read
from grader.counterexample.revived import trial_of
from grader.errors import UsageError
from grader.model.counterexample import Replay
from grader.options import Options
from grader.pipeline import engines_for
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.solution import Solution
from grader.verify import every_check
from grader.verify.planned import kinds_of

PATIENCE = 30.0
"""Wall seconds, and CPU seconds, that showing one counterexample may take."""


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
        effort = Effort(time.monotonic() + PATIENCE, PATIENCE)
        probe = Probe(check, engines, effort, None)
        with np.errstate(all="ignore"):
            evidence = probe.alone(trial)
            if evidence is None:
                return Replay(check.id, check.title, None)
            found = described(probe, Solution(), trial, trial.name, evidence)
        return Replay(check.id, check.title, found)
