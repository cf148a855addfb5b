"""Which check sees which mistake? Reads and writes the stored kill matrix.

The matrix is what one seed says of every submission: F for a failed check. A blocked check sees
nothing: the matrix tells who kills, not who waits.
"""

import csv
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from grader.certify.corpus import corpus_folder, digest_of, name_of
from grader.certify.row import Row
from grader.model.stages import PARTS
from grader.verify import every_check

SEED = 41
"""The seed of the stored matrix."""

FAILED, BROKEN = "F", "!"

GRADER = "grader"
"""Column of the state of the grader that graded a line, as `grader_digest` says."""

Line = dict[str, str]


def matrix_file() -> Path:
    """Where the matrix is stored."""
    return corpus_folder() / "kill-matrix.csv"


def line_of(row: Row) -> Line:
    """Word a row as the matrix stores it."""
    letters = dict.fromkeys((each.id for each in every_check()), "")
    letters |= dict.fromkeys(row.failed, FAILED) | dict.fromkeys(row.broken, BROKEN)
    scores = dict(zip(PARTS, (f"{score:g}" for score in row.scores), strict=True))
    return {"submission": row.name, "sha256": row.digest, **scores, **letters}


def row_of(line: Line) -> Row:
    """Read a line of the matrix back."""
    ids = [each.id for each in every_check()]
    return Row(
        line["submission"],
        line["sha256"],
        SEED,
        tuple(float(line[part]) for part in PARTS),
        tuple(id for id in ids if line.get(id) == FAILED),
        tuple(id for id in ids if line.get(id) == BROKEN),
    )


def stored_lines() -> dict[str, Line]:
    """The stored matrix, by submission."""
    lines = _read()
    for line in lines.values():
        line.pop(GRADER, None)
    return lines


def stored_states() -> Counter[str]:
    """How many lines each state of the grader graded."""
    return Counter(line.get(GRADER) or "unknown" for line in _read().values())


def _read() -> dict[str, Line]:
    if not matrix_file().exists():
        return {}
    with matrix_file().open(newline="") as file:
        return {line["submission"]: line for line in csv.DictReader(file)}


def stored_rows(paths: Iterable[Path]) -> list[Row]:
    """Read what the stored matrix says of some files, as they are now.

    A file without a row of its own is undecided: nobody knows what the grader says of it.
    """
    lines = stored_lines()
    return [_stored_row(name_of(path), digest_of(path), lines) for path in paths]


def _stored_row(name: str, digest: str, lines: dict[str, Line]) -> Row:
    row = row_of(lines[name]) if name in lines else None
    if row is not None and row.digest == digest:
        return row
    why = "no row of it is stored" if row is None else "the stored row is of an older file"
    return Row(name, digest, SEED, (), (), (why,))


def store(rows: Iterable[Row], known: Iterable[str], grader: str) -> None:
    """Write these rows into the matrix: a line a submission, a column a check.

    Args:
        rows: What the matrix's seed says of some submissions.
        known: Names of all submissions there are; lines of others are dropped.
        grader: The state of the grader that graded these rows.
    """
    lines = _read() | {row.name: line_of(row) | {GRADER: grader} for row in rows}
    columns = ["submission", "sha256", *PARTS, *(each.id for each in every_check()), GRADER]
    with matrix_file().open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(lines[name] for name in sorted(set(lines) & set(known)))
