"""The command that writes pages anew from stored results."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from grader.cli.options import language_option
from grader.cli.progress import shown_progress
from grader.language import usual_language
from grader.output import CLASS_PAGE, PAGE, RESULT, STORE, STUDENT, VIEWS, write_whole
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.report.class_row import Row

LARGEST_VIEWS = 8 << 20
"""Bytes of a `views.json`; what the grader writes has less than a tenth of that."""


@click.command(short_help="Write report.html and class.html anew.")
@click.argument(
    "folder", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path)
)
@language_option
def report(folder: Path, language: str | None) -> None:
    """Write report.html anew for every result in DIR, and class.html over all.

    DIR holds a result.json, or one folder a student with a result.json in it.

    Exit status: 0 written, 2 a stored result cannot be used, 3 nothing could be written.
    """
    from grader.batch.table import Known, shared
    from grader.gradebook.paths import result_paths

    spoken = language or usual_language()
    paths = result_paths(folder)
    with shown_progress() as progress:
        rows: list[Row] = []
        known = Known()
        for number, path in enumerate(paths):
            progress("writing reports", number, len(paths))
            rows.append(shared(page_of(path, folder, spoken), known))
    if paths == [folder / RESULT]:
        click.echo(f"written: {line_for_terminal(str(folder / PAGE))}")
        return
    write_class(folder, rows, spoken)
    name = line_for_terminal(str(folder / CLASS_PAGE))
    click.echo(f"written: {name}, and the reports of {len(rows)} submissions")


def page_of(path: Path, folder: Path, language: str) -> "Row":
    """Write the page of one result; returns the student's row in the table of the class.

    Raises:
        UsageError: A stored file cannot be used.
        OutputFault: The page cannot be written.
    """
    from grader.gradebook.results import read_json, read_result
    from grader.kept import write_page
    from grader.report.class_row import row_of
    from grader.report.views import SCHEMA_VERSION

    result, views = read_result(path), path.with_name(VIEWS)
    seen = read_json(views, LARGEST_VIEWS, SCHEMA_VERSION) if views.is_file() else None
    page = write_page(path.parent, result, seen, language)
    return row_of(result, page.relative_to(folder).as_posix(), id_of(path, folder))


def id_of(path: Path, folder: Path) -> str:
    """Find what the platform calls a student of a class that `batch` graded.

    Raises:
        UsageError: What `batch` wrote about the student cannot be used.
    """
    from grader.gradebook.results import LARGEST_NAMES, read_json

    known = path.with_name(STUDENT)
    if not (folder / STORE).is_file() or not known.is_file():
        return ""
    return str(read_json(known, LARGEST_NAMES, 1).get("id", ""))


def write_class(folder: Path, rows: Sequence["Row"], language: str) -> None:
    """Write the page of a class.

    Raises:
        OutputFault: It cannot be written.
    """
    from grader import __version__
    from grader.report.html.classroom import to_class_page

    page = to_class_page(rows, f"bvhgrade {__version__}", language)
    write_whole(folder / CLASS_PAGE, page)
