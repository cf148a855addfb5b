"""Our own programs, run as anybody runs them: `bvhgrade`, and one that watches its memory."""

import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from grader.bench.record import Cost, Peak
from grader.errors import WorkerFault
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, Outcome, launch

SECONDS = 1800.0

OWN = {
    **PLAIN_ENVIRONMENT,
    # Else pytest also loads whatever other tools brought along.
    "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
    "PYTHONPATH": str(Path(__file__).parents[2]),
    **{
        name: os.environ[name]
        for name in ("BVHGRADE_CACHE", "HOME", "CXX")
        if name in os.environ
    },
}
"""Where a program finds this package and its cache, whatever the caller's folder."""


def grader_cost(*words: str | Path, folder: Path | None = None) -> Cost:
    """Run `bvhgrade` with some words, in a folder.

    Raises:
        WorkerFault: It failed.
    """
    outcome = program([sys.executable, "-m", "grader", *map(str, words)], folder)
    return Cost(outcome.cpu_seconds, outcome.seconds)


def grader_peak(what: str, *words: str | Path) -> Peak:
    """Run `bvhgrade` and return how much memory was resident at most.

    Raises:
        WorkerFault: It failed.
    """
    command = [sys.executable, "-m", "grader.bench.peers.memory", *map(str, words)]
    outcome = program(command)
    own, child = json.loads(outcome.out.splitlines()[-1])
    return Peak(what, own / 1024, child / 1024)


def program(command: Sequence[str], folder: Path | None = None) -> Outcome:
    """Run a program of ours to its end.

    Raises:
        WorkerFault: It failed.
    """
    outcome = launch(Order(command, SECONDS, folder=folder, environment=OWN))
    if outcome.code != 0:
        said = (outcome.err or outcome.out).decode(errors="replace").strip()[-500:]
        raise WorkerFault(f"{' '.join(command[1:4])} ended with {outcome.code}: {said}")
    return outcome
