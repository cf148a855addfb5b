"""What does a class have in common? Rows, made from results, and what is counted over them."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from statistics import fmean, median
from typing import Any

from grader.report.hints import misconception
from grader.report.people import told_apart

Json = Mapping[str, Any]

FEWEST = 2
"""Students that have a misconception in common before it is one of the class."""

BINS = 10
"""Bars of the histogram below full marks, which have a bar of their own."""


@dataclass(frozen=True, slots=True)
class Row:
    """One student of a class."""

    name: str
    link: str
    """Of the report, relative to the page; empty if there is none."""

    score: float | None
    """None if it is withheld."""

    max_score: float
    seconds: float
    """Wall time of the grade."""

    verdicts: tuple[tuple[str, str], ...]
    """Id of each check and its verdict: `pass`, `fail`, `blocked` or `broken`."""

    causes: tuple[tuple[str, str], ...]
    """Likely misconceptions, each in a sentence, and the check that shows it best."""

    note: str
    """Why there is nothing to see, if so: the file does not compile, or was refused."""

    id: str = ""
    """What the platform calls the student, if that is known."""


@dataclass(frozen=True, slots=True)
class Bar:
    """One bar of the histogram."""

    begin: float
    end: float
    students: int


def row_of(result: Json, link: str, id: str = "") -> Row:
    """Take from a `result.json` what a class needs.

    Args:
        result: Its values, which validate against the schema.
        link: Where the student's report lies, relative to the page of the class.
        id: What the platform calls the student.
    """
    checks = result["checks"]
    # How many places it explains differs from student to student; what is believed does not.
    causes: dict[str, str] = {}
    for one in checks:
        if one["verdict"] == "fail" and one["hint"]:
            causes.setdefault(misconception(one["hint"])[0], one["id"])
    build = result["build"]
    return Row(
        name=result["submission"]["name"],
        link=link,
        score=result["score"],
        max_score=result["max_score"],
        seconds=result["timing"]["total"],
        verdicts=tuple((one["id"], one["verdict"]) for one in checks),
        causes=tuple(causes.items()),
        note="" if build["ok"] else _first_error(build["diagnostics"]),
        id=id,
    )


def _first_error(diagnostics: Sequence[Json]) -> str:
    errors = [one for one in diagnostics if one["severity"] == "error"]
    if not errors:
        return ""
    line, text = errors[0]["line"], str(errors[0]["text"])
    return f"line {line}: {text}" if line else text


def scores(rows: Iterable[Row]) -> list[float]:
    """Return the scores that are known."""
    return [row.score for row in rows if row.score is not None]


def averages(rows: Sequence[Row]) -> tuple[float, float] | None:
    """Return mean and median of the known scores; None if there are none."""
    known = scores(rows)
    return (fmean(known), median(known)) if known else None


def histogram(rows: Sequence[Row]) -> list[Bar]:
    """Count the known scores in bars of equal width; full marks stand alone."""
    most = max((row.max_score for row in rows), default=0.0)
    if not most:
        return []
    width = most / BINS
    places = Counter(min(int(score / width), BINS) for score in scores(rows))
    inner = [Bar(place * width, (place + 1) * width, places[place]) for place in range(BINS)]
    return [*inner, Bar(most, most, places[BINS])]


def most_failed(rows: Iterable[Row]) -> list[tuple[str, int]]:
    """Return the checks that somebody failed, and by how many, the most failed first."""
    failed = Counter(
        check for row in rows for check, verdict in row.verdicts if verdict == "fail"
    )
    return sorted(failed.items(), key=lambda one: (-one[1], one[0]))


def names_of(rows: Iterable[Row]) -> list[str]:
    """Return what each row is called, so that no two are called the same."""
    return told_apart([(row.name, row.id, PurePosixPath(row.link).parent.name) for row in rows])


def misconceptions(rows: Sequence[Row]) -> list[tuple[str, str, list[str]]]:
    """Return likely misconceptions of several students: sentence, check, and whose they are."""
    whose: dict[str, list[str]] = {}
    checks: dict[str, str] = {}
    for row, name in zip(rows, names_of(rows), strict=True):
        for cause, check in row.causes:
            whose.setdefault(cause, []).append(name)
            checks.setdefault(cause, check)
    shared = [
        (cause, checks[cause], names) for cause, names in whose.items() if len(names) >= FEWEST
    ]
    return sorted(shared, key=lambda one: (-len(one[2]), one[0]))


def check_names(rows: Iterable[Row]) -> list[str]:
    """Return the ids of all checks, in the order in which results name them."""
    return list(dict.fromkeys(check for row in rows for check, _ in row.verdicts))
