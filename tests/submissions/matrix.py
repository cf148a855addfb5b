"""Which check sees which mistake? Writes and compares the kill matrix.

`python -m tests.submissions.matrix` grades the whole corpus and rewrites `kill-matrix.csv`;
with `--compare` it only says what differs; `--seed` may be repeated.
"""

import argparse
import csv
import io
import sys
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from grader.model.verdict import Verdict
from grader.pipeline import Options, grade_one
from grader.verify import every_check
from tests.submissions.corpus import HERE, right_submissions, wrong_submissions

MATRIX = HERE / "kill-matrix.csv"
SEED = 41
LETTERS = {Verdict.PASS: "", Verdict.FAIL: "F", Verdict.BLOCKED: "b", Verdict.BROKEN: "!"}


@dataclass(frozen=True, slots=True)
class Row:
    """What the grader says of one submission."""

    name: str
    """Folder and file: `wrong/axis-always-x.cpp`."""

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
        name=f"{path.parent.name}/{path.name}",
        scores=tuple(part.score for part in grade.parts),
        verdicts=tuple((one.check, one.verdict) for one in grade.checks),
    )


def matrix_text(rows: Iterable[Row]) -> str:
    """Word the matrix as CSV: a line a submission, a column a check."""
    checks = [each.id for each in every_check()]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["submission", "a", "b", *checks])
    for one in rows:
        letters = {check: LETTERS[verdict] for check, verdict in one.verdicts}
        scores = [f"{score:g}" for score in one.scores]
        writer.writerow([one.name, *scores, *(letters.get(check, "") for check in checks)])
    return out.getvalue()


def known_rows() -> dict[str, dict[str, str]]:
    """The stored matrix, by submission."""
    with MATRIX.open(newline="") as file:
        return {line["submission"]: line for line in csv.DictReader(file)}


def main(arguments: Sequence[str]) -> int:
    """Grade everything and write or compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, action="append")
    parser.add_argument("--compare", action="store_true")
    parser.add_argument("--match", default="", help="only files whose name contains this")
    options = parser.parse_args(arguments)
    paths = [*right_submissions(), *(wrong.path for wrong in wrong_submissions())]
    paths = [path for path in paths if options.match in f"{path.parent.name}/{path.name}"]
    text = ""
    for seed in options.seed or [SEED]:
        rows = []
        with ProcessPoolExecutor(2) as pool:
            for one in pool.map(row, paths, [seed] * len(paths)):
                rows.append(one)
                marks = sorted(one.failed) + [f"BROKEN {check}" for check in one.broken]
                print(seed, one.name, *one.scores, *marks, flush=True)  # noqa: T201 - a script
        text = matrix_text(rows)
    if options.compare or options.match:
        return 0
    MATRIX.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
