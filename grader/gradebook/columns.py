"""Which column of a teacher's file is which? By the words of each host, in five languages.

Source: Moodle, mod/assign/lang/en/assign.php and the German, French, Spanish and Italian ones,
with moodle.php, grades.php and assignfeedback_comments.php of these language packs;
mod/assign/gradingtable.php and grade/export/lib.php; instructure/canvas-lms,
lib/gradebook_importer.rb.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from grader.errors import UsageError

NO = {"no", "nein", "non"}
"""Said of a grade that cannot be changed; in Spanish and Italian as in English."""


@dataclass(frozen=True, slots=True)
class Words:
    """What a host calls its columns: patterns of whole headers, whatever their case."""

    ids: tuple[tuple[str, str], ...]
    """Field of `Ids`, and the headers under which it stands."""

    grade: str
    feedback: str = ""
    """Empty if the host takes none."""

    maximum: str = ""
    changeable: str = ""
    own: tuple[str, int] = ("", -1)
    """Field of `Ids` with the host's own number, and its column, whatever the language."""

    never: str = (
        "course total.*|kurs gesamt.*|total du cours.*|total del curso.*|totale corso.*"
        "|.*\\(read only\\)"
    )
    """Looks like a grade's column and is the host's own."""


HOSTS: Mapping[str, Words] = {
    "moodle": Words(
        ids=(
            ("participant", "identifier|id|kennung|identifiant|identificador|identificativo"),
            (
                "account",
                "e-?mail address|username|id number"
                "|e-mail-adresse|anmeldename|id-nummer|matrikelnr\\.?|matrikelnummer"
                "|adresse de courriel|nom d.utilisateur|numéro d.identification"
                "|dirección de correo(?: electrónico)?|nombre de usuario|número de id"
                "|indirizzo email|codice identificativo",
            ),
            # In Italian it is called as the first name is in a gradebook.
            ("full_name", "full name|vollständiger name|nom complet|nombre completo"),
        ),
        grade="grade|bewertung|note|calificación|valutazione"
        "|.*\\((?:real|punkte|brut|punteggio)\\)",
        feedback="feedback comments|feedback als kommentar|feedback par commentaires"
        "|comentarios de retroalimentación|commenti|.*\\((?:feedback|retroalimentación)\\)",
        maximum="maximum grade|bestwertung|note maximale|calificación máxima"
        "|valutazione massima",
        changeable="grade can be changed|bewertung kann geändert werden"
        "|la note peut être modifiée|la calificación (?:puede ser cambiada|puede cambiarse)"
        "|la valutazione può essere cambiata",
        own=("participant", 0),
    ),
    "canvas": Words(
        ids=(
            ("canvas", "id"),
            ("account", "sis user id|sis login id|integration id"),
            ("full_name", "student"),
        ),
        grade=".+ \\(\\d+\\)",
        own=("canvas", 1),
        never=".*(current|final|override) (score|points|grade)|.*\\(read only\\)",
    ),
    "csv": Words(
        ids=(
            (
                "account",
                "student|id|e-?mail|e-?mail address|e-mail-adresse|user ?name|login|account"
                "|kennung|benutzername|anmeldename|matrikelnr\\.?|matrikelnummer"
                "|student number",
            ),
            ("full_name", "name|full name|vollständiger name"),
        ),
        grade="score|grade|points|punkte|punktzahl|bewertung",
        feedback="feedback|comments?|kommentar|rückmeldung",
        maximum="max_score|maximum|maximum grade|bestwertung",
    ),
}


@dataclass(frozen=True, slots=True)
class Asked:
    """What a teacher said about the columns; empty where nothing was."""

    grade: str = ""
    feedback: str = ""
    id: str = ""


@dataclass(frozen=True, slots=True)
class Columns:
    """Where everything stands."""

    ids: tuple[tuple[str, tuple[int, ...]], ...]
    """Field of `Ids`, and its columns."""

    grade: int
    feedback: int | None
    maximum: int | None
    changeable: int | None


def columns_of(header: Sequence[str], host: str, asked: Asked) -> Columns:
    """Find the columns of a file.

    Raises:
        UsageError: One that is needed is not there, or there are several.
    """
    words = HOSTS[host]
    grade = grade_column(header, words, asked.grade)
    return Columns(
        id_columns(header, words, asked.id, grade),
        grade,
        feedback_column(header, words, asked.feedback, grade),
        next(iter(called(header, words.maximum)), None),
        next(iter(called(header, words.changeable)), None),
    )


def called(header: Sequence[str], pattern: str) -> list[int]:
    """Find the columns whose header is one of those."""
    return [
        number
        for number, name in enumerate(header)
        if pattern and re.fullmatch(pattern, name, re.IGNORECASE)
    ]


def id_columns(
    header: Sequence[str], words: Words, asked: str, grade: int
) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """Find the columns that say who a row is.

    Raises:
        UsageError: There are none, or the one that was asked for is not there.
    """
    if asked:
        column = named(header, asked)
        return tuple((field, (column,)) for field in fields_in(column, header, words))
    found = [(field, tuple(called(header, pattern))) for field, pattern in words.ids]
    ids = tuple((field, columns) for field, columns in found if columns)
    if not ids:
        others = [name for number, name in enumerate(header) if number != grade]
        raise UsageError(
            f"no column says who a row is, only {listed(others)}; name it with --id-column"
        )
    return ids


def fields_in(column: int, header: Sequence[str], words: Words) -> list[str]:
    """List which fields of `Ids` may stand in a column that a teacher named."""
    known = [field for field, pattern in words.ids if column in called(header, pattern)]
    own, place = words.own
    # Not under a known header: a user name may end with somebody else's number.
    if not known and column == place:
        known = [own]
    return list(dict.fromkeys([*known, "account", "full_name"]))


def grade_column(header: Sequence[str], words: Words, asked: str) -> int:
    """Find the one column that the points go into.

    Raises:
        UsageError: None or several may be it, or the one that was asked for is not there.
    """
    own = called(header, words.never)
    if asked:
        number = named(header, asked)
        if number in own and words.own[0]:
            raise UsageError(
                f"{header[number]!r} is a column of the host's own, which it does not read; "
                "name that of the assignment with --grade-column"
            )
        return number
    found = [number for number in called(header, words.grade) if number not in own]
    if len(found) == 1:
        return found[0]
    there = [header[number] for number in found] or list(header)
    raise UsageError(
        f"{len(found) or 'no'} columns may be the one for points, of {listed(there)}; "
        "name it with --grade-column"
    )


def feedback_column(header: Sequence[str], words: Words, asked: str, grade: int) -> int | None:
    """Find the column for words: of several, the one that belongs to the grade's."""
    if asked:
        return named(header, asked)
    found = called(header, words.feedback)
    item = header[grade].rpartition(" (")[0]
    same = [number for number in found if item and header[number].startswith(f"{item} (")]
    if same or len(found) == 1:
        return (same or found)[0]
    return None


def named(header: Sequence[str], name: str) -> int:
    """Find a column by its name, or by the beginning of it if no other begins so.

    Raises:
        UsageError: There is none, or there are several.
    """
    found = [n for n, each in enumerate(header) if each == name] or [
        n for n, each in enumerate(header) if each.startswith(name)
    ]
    if len(found) != 1:
        raise UsageError(
            f"{len(found) or 'no'} columns are called {name!r}, of {listed(header)}"
        )
    return found[0]


def listed(names: Sequence[str]) -> str:
    """List the names of columns."""
    return ", ".join(repr(name) for name in names) or "nothing"
