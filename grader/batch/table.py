"""How does a whole class look in a spreadsheet?"""

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from grader.batch.files import Results
from grader.batch.job import Job
from grader.batch.records import Student
from grader.batch.store import Store
from grader.output import CLASS_PAGE, PAGE, STUDENTS, write_whole
from grader.report.class_row import Row, row_of
from grader.report.escape import for_csv
from grader.report.html.classroom import to_class_page

CLASS = "class.csv"

COLUMNS = ("name", "id", "email", "folder", "score", "max_score", "needs_review", "note")
LONGEST_NOTE = 300

Json = dict[str, Any]
Known = dict[tuple[str, str], tuple[str, str]]


@dataclass(slots=True)
class Totals:
    """How many students there are."""

    graded: int = 0
    withheld: int = 0
    """Whose points are withheld, because we failed."""

    waiting: int = 0
    """Who have no result yet."""


def write_table(job: Job, store: Store, results: Results) -> Totals:
    """Write a row for each student with a result into a table, and into a page.

    Raises:
        OutputFault: It could not be written.
    """
    totals, shown = Totals(), list[Row]()
    rows = _rows(store, results, totals, shown)
    write_whole(job.folder / CLASS, "".join(f"{row}\r\n" for row in rows))
    page = to_class_page(shown, f"bvhgrade {job.settings.grader}", job.language)
    write_whole(job.folder / CLASS_PAGE, page)
    return totals


def _rows(store: Store, results: Results, totals: Totals, shown: list[Row]) -> Iterator[str]:
    is_first, known = True, Known()
    for student in store.students():
        found = results.of(student)
        if found is None:
            totals.waiting += 1
            continue
        result: Json = json.loads(found.text)
        if result["needs_review"]:
            totals.withheld += 1
        else:
            totals.graded += 1
        if is_first:
            is_first = False
            # A byte order mark, without which Excel takes the file for Latin-1.
            yield "\ufeff" + _row([*COLUMNS, *(f"part {one['id']}" for one in result["parts"])])
        row = row_of(result, f"{STUDENTS}/{student.slug}/{PAGE}", student.id)
        shown.append(shared(row, known))
        yield _row(_cells(student, result))


def shared(row: Row, known: Known) -> Row:
    """Take from earlier rows what a row has in common with them, to be kept only once.

    Args:
        row: Of a student; its checks and sentences are read anew from each result.
        known: Every pair of an earlier row, once; gets those that are new.
    """
    verdicts, causes = (
        tuple(known.setdefault(pair, pair) for pair in pairs)
        for pairs in (row.verdicts, row.causes)
    )
    return replace(row, verdicts=verdicts, causes=causes)


def _cells(student: Student, result: Json) -> list[object]:
    return [
        student.name,
        student.id,
        student.email,
        f"{STUDENTS}/{student.slug}",
        result["score"],
        result["max_score"],
        "yes" if result["needs_review"] else "no",
        _note(student, result),
        *(part["score"] for part in result["parts"]),
    ]


def _note(student: Student, result: Json) -> str:
    """Say why there is nothing to count, if so."""
    if student.fault:
        return f"not graded: {student.fault}"[:LONGEST_NOTE]
    if student.reason:
        return student.reason[:LONGEST_NOTE]
    if not result["build"]["ok"]:
        return "it does not compile"
    return ""


def _row(cells: list[object]) -> str:
    return ",".join(_cell(cell) for cell in cells)


def _cell(value: object) -> str:
    """A number is ours and stays one; everything else may be a stranger's."""
    if isinstance(value, int | float):
        return f"{value:g}"
    return "" if value is None else for_csv(str(value))
