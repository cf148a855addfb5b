"""How many small trials share one process, when it is only asked which of them fail.

A grade gives every trial a process of its own. Looking for a smaller case that fails is another
matter: nothing is decided by it, and what it finds is tried again alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from grader.model.cases import Case
from grader.model.stages import Ending, Stop
from grader.run.job import Job
from grader.run.requests import Single, asked
from grader.run.session import Allowance, Engine, carried_out, rows_done


@dataclass(frozen=True, slots=True)
class Delivery:
    """What a shared process brought."""

    cases: tuple[tuple[Case, ...], ...]
    """Of the trials that were finished: the first ones, in order."""

    ending: Ending
    """Of the process; it concerns the first trial without cases."""


def run_batch(trials: Sequence[Single], engine: Engine, allowed: Allowance) -> Delivery:
    """Run trials one after the other in one process, until one of them ends it.

    Raises:
        WorkerFault: As `run_job`.
        MissingTool: As `run_job`.
    """
    job, readers, last_rows = Job(), [], []
    for trial in trials:
        readers.append(asked(job, trial))
        last_rows.append(job.row_count)
    ending, result = carried_out(job, engine, allowed)
    done = job.row_count if ending.stop is Stop.FINISHED else rows_done(job, result)
    finished = [read for read, last in zip(readers, last_rows, strict=True) if last <= done]
    if ending.stop is not Stop.FINISHED:
        # A process that claims to have done all and yet did not end well has not done the last.
        finished = finished[: len(trials) - 1]
    return Delivery(tuple(read(result, ending) for read in finished), ending)
