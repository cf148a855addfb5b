"""Which row of a teacher's file belongs to which result? Never by a guess.

Where a platform says whose a result is, it is looked for under the strongest name that the file
has a column for; if it is not there, weaker names do not count, since two people may have one
name. Where a course named the folder, that name may be of any kind. What is there twice, in the
file or in the folder, or fits two rows, is matched with nothing.
"""

import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from grader.gradebook.columns import Columns
from grader.gradebook.results import Marked
from grader.gradebook.table import Line

_NUMBER_AT_END = re.compile(r"\D*(\d+)\s*")


@dataclass(frozen=True, slots=True)
class Matches:
    """What belongs together, and what does not."""

    pairs: tuple[tuple[int, Marked], ...]
    """Index of a row, and its result."""

    problems: tuple[str, ...]
    """Results that no row was found for, each with the reason."""


def matched(
    rows: Sequence[tuple[int, Line]], columns: Columns, given: Sequence[Marked]
) -> Matches:
    """Match rows with results."""
    known = index(rows, columns)
    wanted: dict[int, list[Marked]] = defaultdict(list)
    problems: list[str] = []
    for marked in given:
        if marked.is_nobody_s:
            problems.append(f"{marked.student}: {marked.why}")
            continue
        places = places_of(marked, columns, known)
        if len(places) == 1:
            wanted[next(iter(places))].append(marked)
        elif places:
            numbers = ", ".join(str(place + 1) for place in sorted(places))
            problems.append(f"{marked.student}: rows {numbers} may all be meant")
        else:
            problems.append(f"{marked.student}: no row has this student")
    for place, several in wanted.items():
        if len(several) > 1:
            names = ", ".join(marked.student for marked in several)
            problems.append(f"{names}: several results for row {place + 1}")
    pairs = [(place, ones[0]) for place, ones in sorted(wanted.items()) if len(ones) == 1]
    return Matches(tuple(pairs), tuple(problems))


def index(
    rows: Sequence[tuple[int, Line]], columns: Columns
) -> dict[tuple[str, str], set[int]]:
    """Find rows by what they call a student."""
    found: dict[tuple[str, str], set[int]] = defaultdict(set)
    for place, line in rows:
        for field, numbers in columns.ids:
            for number in numbers:
                if name := comparable(field, line.value(number)):
                    found[field, name].add(place)
    return found


def places_of(
    marked: Marked, columns: Columns, known: dict[tuple[str, str], set[int]]
) -> set[int]:
    """Find the rows that may be meant by a result."""
    return {place for name in names_of(marked, columns) for place in known.get(name, set())}


def names_of(marked: Marked, columns: Columns) -> Iterator[tuple[str, str]]:
    """List under which names a result is looked for."""
    decides: tuple[int, ...] | None = None
    for field, numbers in columns.ids:
        names = set(filter(None, (comparable(field, n) for n in marked.ids.called(field))))
        if not names or (decides not in (None, numbers) and not marked.ids.is_any_name):
            continue
        decides = numbers
        yield from ((field, name) for name in sorted(names))


def comparable(field: str, name: str) -> str:
    """Write a name so that equal ones are equal: accents, spaces and case aside."""
    if field == "participant":
        found = _NUMBER_AT_END.fullmatch(name)
        return str(int(found[1])) if found else ""
    return " ".join(unicodedata.normalize("NFC", name).casefold().split())
