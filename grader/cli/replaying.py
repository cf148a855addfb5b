"""What `check --replay FILE` does: one counterexample, shown again."""

from pathlib import Path
from typing import TYPE_CHECKING

from grader.cli.interrupts import interruptible
from grader.cli.output import patient_stdout
from grader.cli.progress import shown_progress
from grader.cli.status import FULL_MARKS, LOST_POINTS

if TYPE_CHECKING:
    from grader.cli.grading import Order


def replayed(order: "Order", file: Path) -> int:
    """Run the submission on the input of a file, tell what comes of it, return the status."""
    from rich.console import Console

    from grader.options import Options
    from grader.replay import replay
    from grader.report.replayed import print_replay

    with shown_progress() as progress, interruptible():
        progress("building", 0, 0)
        options = Options(order.seed, order.rubric, (), progress, isolated=order.isolated)
        told = replay(order.path, file, options)
    with patient_stdout():
        print_replay(Console(), told)
    return LOST_POINTS if told.found or told.undecided else FULL_MARKS
