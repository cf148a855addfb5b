"""Which submissions tell most for the time that they take, and do they still tell the same?"""

import hashlib
import math
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from grader.certify.corpus import (
    Wrong,
    digest_of,
    name_of,
    right_submissions,
    wrong_submissions,
)
from grader.certify.holes import told
from grader.certify.matrix import FAILED, SEED, Line, line_of, row_of, stored_lines
from grader.certify.row import Row


def sampled(grader: str) -> list[Path]:
    """Half of the right submissions, and one wrong one for each check.

    Args:
        grader: A state of the grader, by `grader_digest`: with each other one another half is
            drawn. Files that the stored matrix does not hold as they are come always.
    """
    lines = stored_lines()
    drawn = (path for path in right_submissions() if _is_drawn(path, grader, lines))
    return [*drawn, *(one.path for one in killers().values())]


def _is_drawn(path: Path, grader: str, lines: Mapping[str, Line]) -> bool:
    line = lines.get(name_of(path))
    if line is None or row_of(line).digest != digest_of(path):
        return True
    return hashlib.sha256(f"{grader} {name_of(path)}".encode()).digest()[0] % 2 == 0


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
