"""Which check sees which mistake? Writes and compares the kill matrix.

`python -m tests.submissions.matrix` grades the whole corpus and rewrites `kill-matrix.csv`;
with `--match` it grades some files and writes their rows only; `--seed N`, repeatable, prints
what another seed says and writes nothing.
"""

import argparse
import csv
import hashlib
import sys
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from grader.model.stages import PARTS
from grader.model.verdict import Verdict
from grader.pipeline import Options, grade_one
from grader.verify import every_check
from tests.submissions.corpus import HERE, right_submissions, wrong_submissions

MATRIX = HERE / "kill-matrix.csv"
SEED = 41
LETTERS = {Verdict.PASS: "", Verdict.FAIL: "F", Verdict.BLOCKED: "", Verdict.BROKEN: "!"}
"""A blocked check sees nothing: the matrix tells who kills, not who waits."""


@dataclass(frozen=True, slots=True)
class Row:
    """What the grader says of one submission."""

    name: str
    """Folder and file: `wrong/axis-always-x.cpp`."""

    digest: str
    """Start of the file's SHA-256: a row says nothing of a file that has changed."""

    scores: tuple[float, ...]
    """Points of part a and part b."""

    verdicts: tuple[tuple[str, Verdict], ...]

    @property
    def failed(self) -> set[str]:
        """Checks that failed."""
        return {check for check, verdict in self.verdicts if verdict is Verdict.FAIL}

    @property
    def broken(self) -> set[str]:
        """Checks that our own fault kept from being decided."""
        return {check for check, verdict in self.verdicts if verdict is Verdict.BROKEN}


def row(path: Path, seed: int = SEED) -> Row:
    """Grade one submission of the corpus."""
    grade = grade_one(path, Options(seed, None, (), lambda *_: None))
    return Row(
        name=name_of(path),
        digest=digest_of(path),
        scores=tuple(part.score for part in grade.parts),
        verdicts=tuple((one.check, one.verdict) for one in grade.checks),
    )


def name_of(path: Path) -> str:
    """Folder and file."""
    return f"{path.parent.name}/{path.name}"


def digest_of(path: Path) -> str:
    """What ties a row to the file that was graded."""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:12]


def line_of(one: Row) -> dict[str, str]:
    """Word a row as the matrix stores it: F for a failed check."""
    letters = {check: LETTERS[verdict] for check, verdict in one.verdicts}
    scores = dict(zip(PARTS, (f"{score:g}" for score in one.scores), strict=True))
    return {"submission": one.name, "sha256": one.digest, **scores, **letters}


def stored_lines() -> dict[str, dict[str, str]]:
    """The stored matrix, by submission."""
    if not MATRIX.exists():
        return {}
    with MATRIX.open(newline="") as file:
        return {line["submission"]: line for line in csv.DictReader(file)}


def store(lines: Iterable[dict[str, str]]) -> None:
    """Write the matrix: a line a submission, a column a check."""
    columns = ["submission", "sha256", *PARTS, *(each.id for each in every_check())]
    with MATRIX.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def main(arguments: Sequence[str]) -> int:
    """Grade everything and write or compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, action="append")
    parser.add_argument("--match", default="", help="only files whose name contains this")
    options = parser.parse_args(arguments)
    every = [*right_submissions(), *(wrong.path for wrong in wrong_submissions())]
    paths = [path for path in every if options.match in name_of(path)]
    lines = stored_lines()
    for seed in options.seed or [SEED]:
        with ProcessPoolExecutor(2) as pool:
            for one in pool.map(row, paths, [seed] * len(paths)):
                marks = sorted(one.failed) + [f"BROKEN {check}" for check in one.broken]
                print(seed, one.name, *one.scores, *marks, flush=True)  # noqa: T201 - a script
                lines[one.name] = line_of(one)
    if not options.seed:
        known = {name_of(path) for path in every}
        store(lines[name] for name in sorted(lines) if name in known)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
