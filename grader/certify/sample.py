"""Which submissions tell most for the time that they take, and do they still tell the same?"""

import math
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from grader.certify.corpus import Wrong, name_of, right_submissions, wrong_submissions
from grader.certify.holes import told
from grader.certify.matrix import FAILED, SEED, Line, line_of, row_of, stored_lines
from grader.certify.row import Row


def sampled() -> list[Path]:
    """All right submissions, and one wrong one for each check."""
    return [*right_submissions(), *(one.path for one in killers().values())]


def killers() -> dict[str, Wrong]:
    """For each check the wrong submission of its own that the fewest other checks see."""
    lines = stored_lines()
    chosen: dict[str, Wrong] = {}
    for one in sorted(wrong_submissions(), key=lambda one: _failures(one, lines)):
        chosen.setdefault(one.checks[0], one)
    return chosen


def differences(rows: Iterable[Row]) -> Iterator[str]:
    """Tell in which rows of the matrix's seed something else is seen than is stored."""
    lines = stored_lines()
    for row in rows:
        if row.seed != SEED or row.broken or line_of(row) == lines.get(row.name):
            continue
        yield f"{row.name}: {told(row)}; stored is {_stored(row, lines)}"


def _failures(one: Wrong, lines: Mapping[str, Line]) -> float:
    """Count the checks that fail; a file that was never graded comes last."""
    line = lines.get(name_of(one.path))
    return sum(letter == FAILED for letter in line.values()) if line else math.inf


def _stored(row: Row, lines: Mapping[str, Line]) -> str:
    line = lines.get(row.name)
    if line is None:
        return "nothing"
    stored = row_of(line)
    return told(stored) if stored.digest == row.digest else "a row of another file of that name"
