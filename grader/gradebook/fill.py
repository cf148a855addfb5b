"""How does a result get into a row? Points as the file writes numbers, and words as one cell.

What Moodle would pass over without a word is told instead, and so is every row that is left as
it was. Nothing is scaled: an assignment out of 100 would turn 50 points into half of them.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from grader.errors import UsageError
from grader.gradebook.columns import NO, Asked, Columns, columns_of, listed
from grader.gradebook.feedback import feedback_cell
from grader.gradebook.matching import Matches, matched
from grader.gradebook.results import Marked
from grader.gradebook.table import Line, Table, read_table, written
from grader.language import Words

_DECIMAL = re.compile(r"\d+([.,])\d+")
_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
_POSSIBLE = "Points Possible"
"""Stands in the first cell of a row of Canvas that is no student."""

_READ_ONLY = "(read only)"
"""Stands in that row where Canvas passes over a column, without a word."""


@dataclass(frozen=True, slots=True)
class Filled:
    """A file with results in it, and what is to be said about that."""

    data: bytes
    filled: int
    """Rows that got their result."""

    rows: int
    empty: tuple[str, ...]
    """Rows without a result: nothing was handed in."""

    problems: tuple[str, ...]
    """Results that are in no row, and what nobody could look at; each with the reason."""


def filled(
    data: bytes, host: str, asked: Asked, given: Sequence[Marked], words: Words
) -> Filled:
    """Fill a teacher's file.

    Raises:
        UsageError: It is not such a file, its assignment has another maximum, or the host would
            pass over its column.
    """
    table = read_table(data)
    columns = columns_of(table.header, host, asked)
    lines = list(table.lines)
    require_writable(table, host, columns)
    rows = students(table, host, columns)
    found = matched(rows, columns, given)
    require_some(found, given)
    comma = writes_commas(table, columns)
    problems = list(found.problems)
    possible = [line.value(columns.grade) for line in lines if _POSSIBLE in line.value(0)]
    for place, marked in found.pairs:
        if not marked.why:
            same_maximum([*maximum_in(lines[place], columns), *possible], marked)
        if reason := untouched(lines[place], host, columns, marked):
            problems.append(f"{marked.student}: row {place + 1} is left as it was: {reason}")
            continue
        points = grade_cell(marked.result["score"], comma, table.delimiter)
        lines[place] = lines[place].changed(columns.grade, points)
        if columns.feedback is not None:
            said = feedback_cell(marked.result, host, words)
            lines[place] = lines[place].changed(columns.feedback, said)
    taken = {place for place, _ in found.pairs}
    empty = [name_of(place, line) for place, line in rows if place not in taken]
    kept = len(problems) - len(found.problems)
    return Filled(
        written(replace(table, lines=tuple(lines))),
        len(found.pairs) - kept,
        len(rows),
        tuple(empty),
        (*problems, *unknown(table, host, columns)),
    )


def require_some(found: Matches, given: Sequence[Marked]) -> None:
    """Accept a file in which somebody is found.

    Raises:
        UsageError: Nobody is.
    """
    if not found.pairs:
        many = sum(not marked.is_nobody_s for marked in given)
        raise UsageError("\n".join([f"no row has any of the {many} students", *found.problems]))


def unknown(table: Table, host: str, columns: Columns) -> Iterator[str]:
    """Say what could not be looked at, or filled: Moodle's word for it is not known here."""
    if host != "moodle":
        return
    among = f"row 1: among {listed(table.header)} is no known column"
    if columns.feedback is None:
        yield f"{among} for feedback, so nobody has any; name it with --feedback-column"
    if table.header[columns.grade].endswith(")"):
        # The gradebook's "Exercise 3 (Real)": only a worksheet tells about its assignment.
        return
    if columns.maximum is None:
        yield (
            f"{among} of the maximum, so nothing was compared with it; see that it is the "
            "results' own before you upload the file"
        )
    if columns.changeable is None:
        yield (
            f"{among} that says whether a grade can be changed, so locked rows may be filled, "
            "which Moodle passes over; look for them before you upload the file"
        )


def students(table: Table, host: str, columns: Columns) -> list[tuple[int, Line]]:
    """List the rows that are students, with their index."""
    ids = [number for _, numbers in columns.ids for number in numbers]
    return [
        (place, line)
        for place, line in enumerate(table.lines)
        if place
        and any(line.value(number).strip() for number in ids)
        and not (host == "canvas" and _POSSIBLE in line.value(0))
    ]


def require_writable(table: Table, host: str, columns: Columns) -> None:
    """Look whether Canvas takes what is in the column for points.

    Raises:
        UsageError: It does not.
    """
    for place, line in enumerate(table.lines if host == "canvas" else ()):
        cell = line.value(columns.grade)
        if _POSSIBLE in line.value(0) and _READ_ONLY in cell.casefold():
            raise UsageError(
                f"row {place + 1}: the column {table.header[columns.grade]!r} is read only, so "
                "Canvas would pass over all points in it; name another column with "
                "--grade-column"
            )


def writes_commas(table: Table, columns: Columns) -> bool:
    """Tell whether the file's numbers have a comma in them.

    Those of the assignment decide, else those of other columns. If there are none, semicolons
    between cells are of a country whose numbers have a comma.
    """
    own = {number for number in (columns.grade, columns.maximum) if number is not None}
    others = set(range(len(table.header))) - own
    if signs := signs_in(table, own):
        return "," in signs
    signs = signs_in(table, others)
    return "," in signs if len(signs) == 1 else table.delimiter == ";"


def signs_in(table: Table, columns: Iterable[int]) -> set[str]:
    """List what stands before the decimals of numbers in some columns."""
    cells = (line.value(number).strip() for line in table.lines for number in columns)
    return {found[1] for cell in cells if (found := _DECIMAL.fullmatch(cell))}


def maximum_in(line: Line, columns: Columns) -> list[str]:
    """Read the maximum in a student's row, if the file has one there."""
    return [] if columns.maximum is None else [line.value(columns.maximum)]


def same_maximum(said: Iterable[str], marked: Marked) -> None:
    """Compare the maximum of the assignment with that of the result.

    Raises:
        UsageError: They differ, so the points would mean something else there.
    """
    for text in said:
        there = number_in(text)
        if there is not None and there != marked.result["max_score"]:
            raise UsageError(
                f"the assignment is out of {there:g} points, but results are out of "
                f"{marked.result['max_score']:g}; change it there and download the file again"
            )


def number_in(text: str) -> float | None:
    """Read a number as the file writes it; None if there is none."""
    found = _NUMBER.fullmatch(text.strip())
    return float(found[0].replace(",", ".")) if found else None


def untouched(line: Line, host: str, columns: Columns, marked: Marked) -> str:
    """Say why a row has to stay as it is; empty if it has not."""
    if marked.why:
        return marked.why
    if marked.result["score"] is None:
        return "the score is withheld, since the grader itself failed"
    changeable = "" if columns.changeable is None else line.value(columns.changeable)
    if changeable.strip().casefold() in NO:
        return "its grade cannot be changed there"
    there = line.value(columns.grade).strip().casefold()
    if there == "ex":
        return "this student is excused"
    if there == "n/a" and host == "canvas":
        return "the assignment is not this student's (N/A), so Canvas would drop the points"
    return ""


def grade_cell(score: float, comma: bool, delimiter: str) -> str:
    """Write points."""
    text = f"{score:.10g}"
    text = text.replace(".", ",") if comma else text
    return f'"{text}"' if delimiter in text else text


def name_of(place: int, line: Line) -> str:
    """Name a row for people: its first two cells say who it is in every one of these files."""
    return f"row {place + 1}: {', '.join(filter(None, (line.value(0), line.value(1))))}"
