"""How does a whole class look on one page?"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from grader.language import Words, translator
from grader.report.class_row import (
    Bar,
    Row,
    averages,
    check_names,
    histogram,
    misconceptions,
    most_failed,
    names_of,
)
from grader.report.counts import teller
from grader.report.escape import for_csv
from grader.report.hints import told
from grader.report.html.page import SIGNS, page

WIDTH, HEIGHT, LEFT, BELOW, ABOVE = 760, 200, 36, 22, 10
"""Of the histogram, in pixels; and the room at its left, below and above."""

GAP = 3
COLUMNS = ("student", "score", "max_score", "seconds")
"""Of the table for a spreadsheet, before the checks."""

AT_LINE = re.compile(r"(?s)line (\d+): (.*)")
"""A note of what a compiler said."""

LINES = 4
"""Of the histogram's grid, the lowest one not counted."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """A bar, in pixels."""

    x: float
    y: float
    width: float
    height: float
    label: str
    told: str


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the grid."""

    y: float
    students: int


def to_class_page(rows: Sequence[Row], footer: str, language: str) -> str:
    """Write `class.html`.

    Args:
        rows: The students, in the order of the table.
        footer: With what they were graded.
        language: `en` or `de`.
    """
    words, checks = translator(language), check_names(rows)
    noted = [note(row.note, words, teller(language)) for row in rows]
    failed = [
        {"check": check, "students": count, "percent": round(100 * count / len(rows))}
        for check, count in most_failed(rows)
    ]
    values = {
        "title": words("BVH exercise: the class"),
        "lead": lead(rows, words),
        "withheld": withheld(rows, words),
        **chart(histogram(rows), words),
        "failed": failed,
        "misconceptions": [
            (words(cause), comment(cause, check, words), whose)
            for cause, check, whose in misconceptions(rows)
        ],
        "checks": checks,
        "rows": [
            _row(row, name, checks, words) | {"note": remark}
            for row, name, remark in zip(rows, names_of(rows), noted, strict=True)
        ],
        "footer": footer,
    }
    return page("class", language, values, {"csv": csv_parts(rows)})


def comment(cause: str, check: str, words: Words) -> str:
    """Word what can be told to all who believe the same; it holds no solution."""
    question = told().get(check, {}).get("question", "")
    return " ".join(filter(None, (words(cause), words(question))))


def lead(rows: Sequence[Row], words: Words) -> str:
    """Say how many there are and how they did."""
    average = averages(rows)
    if average is None:
        return words("{students} submissions").format(students=len(rows))
    most = max(row.max_score for row in rows)
    sentence = words("{students} submissions, mean {mean}, median {median} of {most} points")
    mean, middle = (f"{value:.1f}" for value in average)
    return sentence.format(students=len(rows), mean=mean, median=middle, most=f"{most:g}")


def withheld(rows: Sequence[Row], words: Words) -> str:
    """Say how many scores are withheld; empty if none is."""
    count = sum(row.score is None for row in rows)
    sentence = words(
        "Withheld scores: {count}. The grader itself failed there; grade these again. They "
        "are in no average."
    )
    return sentence.format(count=count) if count else ""


def note(written: str, words: Words, told: Words) -> str:
    """Tell in a language why nothing could be graded; what a compiler said stays as it is."""
    found = AT_LINE.fullmatch(written)
    if found is None:
        return told(written)
    return words("line {line}: {text}").format(line=found[1], text=found[2])


def chart(bars: Sequence[Bar], words: Words) -> dict[str, object]:
    """Lay the histogram out."""
    if not bars:
        return {"bars": [], "chart": {}}
    most = max(bar.students for bar in bars)
    step = max(1, -(-most // LINES))
    top = step * LINES
    ground, room = HEIGHT - BELOW, HEIGHT - BELOW - ABOVE
    width = (WIDTH - LEFT) / len(bars)
    drawn = [
        Drawn(
            x=round(LEFT + place * width + GAP, 1),
            y=round(ground - room * bar.students / top, 1),
            width=round(width - 2 * GAP, 1),
            height=round(room * bar.students / top, 1),
            label=_label(bar),
            told=words("{range} points: {students}").format(
                range=_label(bar), students=bar.students
            ),
        )
        for place, bar in enumerate(bars)
    ]
    lines = [Line(round(ground - room * n / LINES, 1), n * step) for n in range(LINES + 1)]
    every = "; ".join(one.told for one in drawn)
    shape = {"width": WIDTH, "height": HEIGHT, "left": LEFT, "lines": lines, "told": every}
    return {"bars": drawn, "chart": shape}


def _label(bar: Bar) -> str:
    return f"{bar.begin:g}" if bar.begin == bar.end else f"{bar.begin:g}\N{EN DASH}{bar.end:g}"


def _row(row: Row, name: str, checks: Sequence[str], words: Words) -> dict[str, object]:
    known = dict(row.verdicts)
    return {
        "name": name,
        "link": row.link,
        "withheld": row.score is None,
        "points": words("withheld") if row.score is None else f"{row.score:g}",
        "seconds": f"{row.seconds:.1f}",
        # What was not run at all looks like what could not be decided.
        "signs": [SIGNS[known.get(check, "blocked")] for check in checks],
    }


def csv_parts(rows: Sequence[Row]) -> dict[str, object]:
    """Return what the page's script puts together to `to_csv`: verdicts are in the table."""
    checks = check_names(rows)
    return {
        "head": _line([*COLUMNS, *checks]),
        "first": [_line(_cells(row)) for row in rows],
        "words": {letter: for_csv(verdict) for verdict, (letter, _) in SIGNS.items()},
    }


def to_csv(rows: Sequence[Row]) -> str:
    """Write the table for a spreadsheet: a line for each student."""
    checks = check_names(rows)
    lines = [_line([*COLUMNS, *checks])]
    for row in rows:
        known = dict(row.verdicts)
        lines.append(_line([*_cells(row), *(known.get(one, "blocked") for one in checks)]))
    return "\r\n".join(lines) + "\r\n"


def _cells(row: Row) -> list[str]:
    score = "" if row.score is None else f"{row.score:g}"
    return [row.name, score, f"{row.max_score:g}", f"{row.seconds:.1f}"]


def _line(cells: Sequence[str]) -> str:
    return ",".join(map(for_csv, cells))
