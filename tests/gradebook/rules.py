"""How Moodle and Canvas import a file of grades, written anew from their sources.

Sources: Moodle, mod/assign/feedback/offline/importgradeslib.php and locallib.php, and
grade/import/csv/classes/load_data.php; instructure/canvas-lms, lib/gradebook_importer.rb.
"""

import csv
import io
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta

HEADERS = {
    "en": ("Identifier", "Grade", "Last modified (grade)", "Feedback comments"),
    "de": ("ID", "Bewertung", "Zuletzt geändert (Bewertung)", "Feedback als Kommentar"),
    "fr": (
        "Identifiant",
        "Note",
        "Dernière modification (note)",
        "Feedback par commentaires",
    ),
    "es": (
        "Identificador",
        "Calificación",
        "Última modificación (calificación)",
        "Comentarios de retroalimentación",
    ),
    "it": ("Identificativo", "Valutazione", "Ultima modifica (valutazione)", "Commenti"),
}


class ImportAbortedError(Exception):
    """The host imports nothing."""


def read(data: bytes, delimiter: str, encoding: str = "utf-8-sig") -> list[list[str]]:
    """Read CSV as strictly as Python can."""
    text = data.decode(encoding)
    return list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True))


def moodle_number(text: str, language: str) -> float:
    """Read a number as `unformat_float` does: the language's comma, or a point."""
    return float(text if language == "en" else text.replace(",", "."))


@dataclass(frozen=True)
class Kept:
    """What Moodle's own data base says of a participant."""

    points: float | None = None
    modified: datetime = datetime(1970, 1, 1)
    locked: bool = False


UNGRADED = Kept()


def moodle_date(text: str) -> datetime:
    """Read a date as PHP's `strtotime` does: in English; what is none is the year 1970."""
    try:
        return datetime.strptime(text, "%A, %d %B %Y, %I:%M %p")
    except ValueError:
        return UNGRADED.modified


@dataclass(frozen=True)
class Site:
    """What Moodle knows when a worksheet is imported, and what the teacher ticks."""

    kept: Mapping[int, Kept] = field(default_factory=dict)
    """By the number of the participant."""

    ignore_modified: bool = False
    """Whether "Allow updating records that have been modified more recently" is ticked."""

    highest: float = 50


NEW = Site()


def moodle_worksheet(
    data: bytes, language: str, delimiter: str = ",", site: Site = NEW
) -> dict[int, tuple[float, str]]:
    """Import a grading worksheet: participant to points and feedback; others are skipped.

    Of a skipped row Moodle takes the feedback all the same, unless the grade is newer there.
    """
    header, *rows = read(data, delimiter)
    who, grade, modified, feedback = HEADERS[language]
    if not {who, grade, modified} <= set(header):
        raise ImportAbortedError("a column is missing")
    taken: dict[int, tuple[float, str]] = {}
    for row in rows:
        cell = dict(zip(header, row, strict=True))
        number = re.fullmatch(r"(?:Participante? |Partecipante |Teilnehmer/in)(\d+)", cell[who])
        if number is None or not cell[grade].strip():
            continue
        points = moodle_number(cell[grade], language)
        now = site.kept.get(int(number[1]), UNGRADED)
        is_stale = now.modified > moodle_date(cell[modified]) + timedelta(seconds=60)
        if points == now.points or now.locked or (is_stale and not site.ignore_modified):
            continue
        if 0 <= points <= site.highest:
            taken[int(number[1])] = (points, cell.get(feedback, ""))
    return taken


def moodle_gradebook(
    data: bytes, users: set[str], columns: tuple[str, str, str], highest: float = 100
) -> dict[str, tuple[float | None, str]]:
    """Import grades: one unknown user, or one grade that is none, and nothing is imported."""
    header, *rows = read(data, ",")
    who, grade, feedback = columns
    taken: dict[str, tuple[float | None, str]] = {}
    for row in rows:
        cell = dict(zip(header, row, strict=True))
        if not cell[who]:
            continue
        if cell[who] not in users:
            raise ImportAbortedError(f"unknown user {cell[who]}")
        points = None
        if cell[grade] not in ("", "-"):
            try:
                points = float(cell[grade])
            except ValueError as fault:
                raise ImportAbortedError(str(fault)) from fault
            if points > highest:
                raise ImportAbortedError("above the maximum")
        taken[cell[who]] = (points, cell[feedback])
    return taken


def canvas(data: bytes, users: dict[str, str], assignment: str) -> dict[str, float | None]:
    """Import a gradebook: the ID of a user to points; None is no change."""
    lines = data.decode("utf-8-sig").splitlines()[:3]
    text = "\n".join(lines)
    header, *rows = read(data, ";" if text.count(";") > text.count(",") else ",")
    if len(header) <= 3 or "Student" not in header[0] or header[1] != "ID":
        raise ImportAbortedError("this is no gradebook")
    if "Section" not in header:
        raise ImportAbortedError("no column Section")
    (column,) = (n for n, name in enumerate(header) if name.endswith(f"({assignment})"))
    possible = [row for row in rows if "Points Possible" in row[0]]
    if any("(read only)" in row[column].lower() for row in possible):
        # Canvas passes over the column without a word.
        return {}
    taken: dict[str, float | None] = {}
    for row in rows:
        if "Points Possible" in row[0]:
            continue
        if row[1] not in users:
            raise ImportAbortedError(f"{row[0]} would be offered as a new student")
        text = row[column].replace(",", ".")
        taken[row[1]] = None if text in ("", "EX", "N/A") else float(text)
    return taken
