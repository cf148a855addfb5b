"""The commands that grade: `check` for a student's own file, `grade` for somebody else's."""

from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click
from click.exceptions import Exit

from grader.cli.formats import format_option, ready_for, write_formats
from grader.cli.interrupts import interruptible
from grader.cli.options import (
    hints_option,
    language_option,
    rubric_option,
    seed_option,
    submission_type,
    time_option,
    unsafe_option,
)
from grader.cli.order import Order, call_of, is_whole, ordered, repetition
from grader.cli.output import patient_stdout
from grader.cli.progress import shown, shown_progress
from grader.cli.replaying import replayed, require_alone
from grader.cli.status import FULL_MARKS, INTERRUPTED, LOST_POINTS, OUR_FAULT, stop, tell_of
from grader.errors import Interrupted, UsageError
from grader.language import translator
from grader.model.grade import Grade
from grader.model.stages import SOURCE_PATH
from grader.model.verdict import Verdict
from grader.output import OUTPUT, ready
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.report.failure import Occasion

USUAL_PLACES = (SOURCE_PATH, f"student_stub/{SOURCE_PATH}")


@click.command()
@click.argument("submission", type=submission_type, required=False)
@click.option("--only", multiple=True, metavar="CHECK", help="Run this check; repeatable.")
@click.option(
    "--replay",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Run on the input of this counterexample only.",
)
@seed_option
@rubric_option
@time_option
@hints_option
@language_option
@unsafe_option
@click.option("--watch", is_flag=True, help="Run again at every save, until Ctrl-C.")
@click.option("--quick", is_flag=True, help="Run only what finds most mistakes: seconds.")
def check(submission: Path | None, watch: bool, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Grade your own code, explain what is wrong, write bvhgrade-out/.

    SUBMISSION is a .cpp file, a folder or an archive that holds one exercise03.cpp; by default
    exercise03.cpp in src or student_stub/src.

    Exit status: 0 full marks, 1 points lost, 2 wrong usage, 3 grader failed.
    """
    order = replace(ordered(submission or usual_place(), given), for_student=True)
    if given["replay"] is not None:
        require_alone()
        raise Exit(replayed(order, given["replay"]))
    folder = own_folder()
    if watch:
        watch_over(order, folder)
    result = graded(order)
    written = stored(folder, result, order)
    with patient_stdout():
        report(result, order, written)
        say_if_quick(order)
    raise Exit(status_of_check(result, order.only))


@click.command(short_help="Grade one submission and write result.json.")
@click.argument("submission", type=submission_type)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    default=OUTPUT,
    show_default=True,
    metavar="DIR",
    help="Folder for the result; created if needed.",
)
@format_option
@seed_option
@rubric_option
@time_option
@language_option
@unsafe_option
@click.option("--quiet", is_flag=True, help="Print the points only.")
def grade(submission: Path, output: Path, quiet: bool, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Grade one submission and write result.json, and other formats beside it.

    SUBMISSION is a .cpp file, a folder or an archive that holds one exercise03.cpp.

    Exit status: 0 a grade was produced, 2 wrong usage, 3 the grader failed.
    """
    order = ordered(submission, given)
    folder = ready(output, submission=submission)
    paths = ready_for(folder, given["formats"])
    result = graded(order)
    written = stored(folder, result, order)
    write_formats(paths, result, order.language)
    with patient_stdout():
        if quiet:
            click.echo(points_only(result))
        else:
            report(result, order, written)
    raise Exit(OUR_FAULT if is_withheld(result) else FULL_MARKS)


def usual_place() -> Path:
    """Find the student's file from where the command was typed.

    Raises:
        UsageError: It is at none of the usual places.
    """
    for place in USUAL_PLACES:
        if Path(place).is_file():
            return Path(place)
    places = " nor ".join(USUAL_PLACES)
    raise UsageError(f"neither {places} exists here; name the file: bvhgrade check FILE")


def own_folder() -> Path:
    """Choose a folder for a student's own result: here, else in the cache."""
    try:
        return ready(Path(OUTPUT))
    except UsageError:
        from grader.resources import cache_folder

        remedy = "call it in a folder that you may write, or set BVHGRADE_CACHE to one"
        return ready(cache_folder() / OUTPUT, remedy=remedy)


def graded(order: Order) -> Grade:
    """Run the pipeline with a bar that shows how far it is."""
    from grader.options import Options
    from grader.pipeline import grade_one
    from grader.selection import quickest

    only = order.only
    if order.quick and not only:
        only = quickest(order.rubric, order.for_student)
    with shown_progress() as progress, interruptible():
        options = Options(
            order.seed,
            order.rubric,
            only,
            progress,
            order.time_limit,
            counterexamples=not order.quick,
            isolated=order.isolated,
            for_student=order.for_student,
            views=order.views and not order.quick,
            quick=order.quick,
        )
        result = grade_one(order.path, options)
    tell_of(result.traceback)
    return result


def stored(folder: Path, result: Grade, order: Order) -> Path:
    """Write a result with everything that belongs to it, and say where the report lies."""
    from grader.kept import kept, write_result

    with shown("writing the report"):
        return write_result(folder, kept(result), order.language, hints=order.hints > 0)


def report(result: Grade, order: Order, written: Path) -> None:
    """Print what people read."""
    from rich.console import Console

    from grader.report.terminal import print_grade

    console = Console()
    print_grade(console, result, occasion(order, written))


def occasion(order: Order, written: Path) -> "Occasion":
    """Say how a report came to be printed."""
    from grader.report.failure import Occasion

    return Occasion(
        repetition(order), written, order.hints, order.language, call_of("view", order)
    )


def watch_over(order: Order, folder: Path) -> NoReturn:
    """Grade at every save, until Ctrl-C."""
    from rich.console import Console

    from grader.cli.watching import Watch, watch
    from grader.report.problem import print_problem

    def tell(result: Grade, order: Order) -> None:
        written = stored(folder, result, order)
        click.echo(f"\n--- {datetime.now().astimezone():%H:%M:%S} ---")
        print_problem(Console(), result, occasion(order, written), is_whole(order))
        say_if_quick(order)

    words = translator(order.language)
    path = line_for_terminal(str(order.path))
    click.echo(words("Watching {path}; Ctrl-C ends.").format(path=path))
    try:
        watch(replace(order, views=False), Watch(graded, tell))
    except (KeyboardInterrupt, Interrupted) as fault:
        # Each finished run was stored, so more changed than after other interruptions.
        status = getattr(fault, "status", INTERRUPTED)
        stop("interrupted; the last finished run is kept", status)


def say_if_quick(order: Order) -> None:
    """Say that more can be run."""
    if order.quick:
        words = translator(order.language)
        told = words("This was the quick run; without --quick every check is run.")
        click.echo(f"\n{told}")


def points_only(result: Grade) -> str:
    """Word the points in one line."""
    name = line_for_terminal(result.submission.student)
    earned = "withheld" if is_withheld(result) else f"{result.score:g}"
    return f"{earned} of {result.max_score:g}  {name}"


def is_withheld(result: Grade) -> bool:
    """Nobody knows the score, because the grader itself failed somewhere."""
    return result.needs_review or result.score is None


def status_of_check(result: Grade, only: tuple[str, ...]) -> int:
    """Tell full marks, lost points and our own fault apart.

    Args:
        result: The grade.
        only: The checks that were asked for; others that ran on the way do not count.
    """
    if is_withheld(result):
        return OUR_FAULT
    asked = [score for score in result.checks if not only or score.check in only]
    passed = asked and all(score.verdict is Verdict.PASS for score in asked)
    return FULL_MARKS if passed else LOST_POINTS
