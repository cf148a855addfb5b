"""What the commands on a class have in common: what they refuse, and how they end."""

from typing import TYPE_CHECKING

import click

from grader.cli.status import FULL_MARKS, INTERRUPTED, OUR_FAULT
from grader.errors import UsageError, WorkerFault
from grader.output import STUDENTS
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.batch.job import Job
    from grader.batch.store import Store
    from grader.batch.table import Totals
    from grader.cli.live import Lines


def ended_early(watch: "Lines", fault: WorkerFault | KeyboardInterrupt) -> int:
    """Say why not all was graded, and what is kept; the exit status."""
    kept = "what was graded is kept, and the same command goes on"
    if isinstance(fault, WorkerFault):
        watch.say(f"bvhgrade: {fault}")
        watch.say(kept)
        return OUR_FAULT
    watch.say(f"interrupted; {kept}")
    status: int = getattr(fault, "status", INTERRUPTED)
    return status


def require_same(store: "Store", job: "Job") -> None:
    """Keep results of different rubrics, seeds and graders apart.

    Raises:
        UsageError: The folder holds results of other settings.
    """
    current = store.current()
    if current is not None and current != job.settings:
        changes = "; ".join(current.changes(job.settings))
        raise UsageError(
            f"{job.folder} holds results of other settings ({changes}); add --regrade to see "
            "what that changes, or name another folder"
        )
    store.know(job.settings)


def told(job: "Job", totals: "Totals", troubles: int) -> int:
    """Say how it ended; the exit status."""
    from grader.batch.table import CLASS

    say(f"{totals.graded:,} graded, {totals.withheld:,} withheld, {totals.waiting:,} waiting")
    say(f"{job.folder / CLASS}, and a folder for each in {job.folder / STUDENTS}")
    return OUR_FAULT if totals.withheld or totals.waiting or troubles else FULL_MARKS


def say(line: str) -> None:
    """Print one line."""
    click.echo(line_for_terminal(line))
