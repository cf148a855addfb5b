"""What `check --replay FILE` does: one counterexample, shown again."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from grader.cli.interrupts import interruptible
from grader.cli.output import patient_stdout
from grader.cli.progress import shown_progress
from grader.cli.status import FULL_MARKS, LOST_POINTS, OUR_FAULT
from grader.errors import UsageError

if TYPE_CHECKING:
    from grader.cli.order import Order

WITHOUT_REPLAY = ("only", "watch", "quick", "hints", "time_limit")
"""Options that say nothing of one input of one check."""


def replayed(order: "Order", file: Path) -> int:
    """Run the submission on the input of a file, tell what comes of it, return the status.

    Raises:
        UsageError: The file is no counterexample, or of a check that is not run here.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    from rich.console import Console

    from grader.counterexample.reading import read
    from grader.options import Options
    from grader.replay import replay
    from grader.report.replayed import print_replay

    require_shown(order.rubric, read(file).check, str(file))
    with shown_progress() as progress, interruptible():
        progress("building", 0, 0)
        options = Options(
            order.seed,
            order.rubric,
            (),
            progress,
            isolated=order.isolated,
            for_student=order.for_student,
        )
        told = replay(order.path, file, options)
    with patient_stdout():
        print_replay(Console(), told, order.language)
    if told.is_ours:
        return OUR_FAULT
    return LOST_POINTS if told.found or told.undecided else FULL_MARKS


def require_shown(rubric: Path | None, check: str, named: str) -> None:
    """Refuse a check that the rubric hides: anybody can write a file of one.

    Args:
        rubric: The instructor's rubric; None for the shipped one.
        check: Its id.
        named: What named it, for the message.

    Raises:
        UsageError: It is hidden.
    """
    from grader.selection import select

    if check in select(rubric, (), for_student=True).hidden:
        raise UsageError(f"{named}: the rubric hides {check}, so it is not run here")


def require_alone() -> None:
    """Refuse options that `--replay` would ignore.

    Raises:
        UsageError: One of them was given.
    """
    source = click.get_current_context().get_parameter_source
    for name in WITHOUT_REPLAY:
        if source(name) is ParameterSource.COMMANDLINE:
            option = f"--{name.replace('_', '-')}"
            raise UsageError(f"--replay runs one check on one input; leave out {option}")
