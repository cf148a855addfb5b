"""The command that brings results into a course's gradebook."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.options import language_option
from grader.cli.progress import shown
from grader.cli.status import FULL_MARKS, LOST_POINTS
from grader.errors import UsageError
from grader.language import translator, usual_language
from grader.output import write_bytes_whole
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.gradebook.fill import Filled

LARGEST = 32 << 20
"""Bytes of a worksheet; one of 10,000 students with feedback has less."""


@click.command(short_help="Bring the results of a class into a gradebook.")
@click.argument("host", type=click.Choice(["moodle", "canvas", "csv"]))
@click.argument("folder", metavar="DIR", type=click.Path(exists=True, path_type=Path))
@click.option(
    "--worksheet",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="The teacher's own file; only points and feedback change.",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Where to write (default: the worksheet, else grades.csv).",
)
@click.option("--grade-column", default="", metavar="NAME", help="Where the points go.")
@click.option("--feedback-column", default="", metavar="NAME", help="Where the words go.")
@click.option("--id-column", default="", metavar="NAME", help="What says who a row is.")
@language_option
def export(host: str, folder: Path, output: Path | None, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Bring the results below DIR, one folder a student, into a gradebook.

    Moodle: a grading worksheet or a gradebook's CSV. Canvas: the exported gradebook.

    Exit status: 0 every result is in the file, 1 some are not, 2 nothing was written.
    """
    sheet: Path | None = given["worksheet"]
    with shown("reading the results"):
        table = exported(host, folder, sheet, given)
    target = output or sheet or Path("grades.csv")
    write_bytes_whole(target.resolve(), table.data, "name another file with -o")
    tell(table, target)
    raise Exit(LOST_POINTS if table.problems else FULL_MARKS)


def exported(host: str, folder: Path, sheet: Path | None, given: Mapping[str, Any]) -> "Filled":
    """Make the file.

    Raises:
        UsageError: The results or the teacher's file cannot be used.
    """
    from grader.batch.unfinished import unfinished
    from grader.gradebook.columns import Asked
    from grader.gradebook.fill import filled
    from grader.gradebook.results import results_in
    from grader.gradebook.scratch import made
    from grader.report.spoken import in_language

    language = given["language"] or usual_language()
    words = translator(language)
    waiting = unfinished(folder)
    results = [
        *(
            replace(each, result=in_language(each.result, language))
            for each in results_in(folder, {one.student for one in waiting})
        ),
        *waiting,
    ]
    asked = Asked(given["grade_column"], given["feedback_column"], given["id_column"])
    if sheet is None:
        return made(host, results, words)
    try:
        return filled(content(sheet), host, asked, results, words)
    except UsageError as fault:
        raise UsageError(f"{sheet}: {fault}") from fault


def content(sheet: Path) -> bytes:
    """Read the teacher's file.

    Raises:
        UsageError: It cannot be read, or is too large to be one.
    """
    try:
        with sheet.open("rb") as file:
            data = file.read(LARGEST + 1)
    except OSError as fault:
        raise UsageError(fault.strerror or "it cannot be read") from fault
    if len(data) > LARGEST:
        raise UsageError(f"it has more than {LARGEST:,} bytes, so it is no gradebook")
    return data


def tell(table: "Filled", target: Path) -> None:
    """Say what was filled, and on standard error everything that was not."""
    for row in table.empty:
        click.echo(f"no result: {line_for_terminal(row)}", err=True)
    for problem in table.problems:
        click.echo(f"look at this: {line_for_terminal(problem)}", err=True)
    name = line_for_terminal(str(target))
    click.echo(f"{table.filled} of {table.rows} rows filled: {name}")
