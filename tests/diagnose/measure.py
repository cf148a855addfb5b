"""How often is a wrong submission's misconception named rightly, how often wrongly?

`python -m tests.diagnose.measure` grades the wrong submissions with the checks that fail,
writes what is named into `tests/submissions/causes.csv`, and prints the shares. `--match`
grades some of them and writes their rows only; `--seed N` writes nothing.
"""

import argparse
import csv
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from grader.certify.corpus import corpus_folder, digest_of, name_of, wrong_submissions
from grader.certify.matrix import FAILED, SEED, stored_lines
from grader.options import Options
from grader.pipeline import grade_one
from tests.diagnose.table import misconceptions

CAUSES = corpus_folder() / "causes.csv"
RIGHTLY, WRONGLY, SILENT = "rightly", "wrongly", "not at all"

Row = dict[str, str]


def row(path: Path, seed: int = SEED) -> Row:
    """Grade one wrong submission and tell what it is said to misunderstand."""
    line = stored_lines()[name_of(path)]
    failed = tuple(check for check, letter in line.items() if letter == FAILED)
    grade = grade_one(path, Options(seed, None, failed, lambda *_: None))
    named = {score.cause.id for score in grade.checks if score.cause is not None}
    return {
        "submission": name_of(path),
        "sha256": digest_of(path),
        "causes": " ".join(sorted(named)),
    }


def stored() -> dict[str, Row]:
    """What was named at last, by submission."""
    if not CAUSES.exists():
        return {}
    with CAUSES.open(newline="", encoding="utf-8") as file:
        return {line["submission"]: line for line in csv.DictReader(file)}


def store(rows: Mapping[str, Row]) -> None:
    """Write what was named."""
    with CAUSES.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, ["submission", "sha256", "causes"], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[name] for name in sorted(rows))


def judged(named: str, right: str) -> str:
    """Tell whether everything that is named is right, given all names of the mistake."""
    if not named:
        return SILENT
    return RIGHTLY if set(named.split()) <= set(right.split()) else WRONGLY


def shares(rows: Mapping[str, Row]) -> dict[str, float]:
    """Share of all wrong submissions whose misconception is named rightly or wrongly."""
    known = misconceptions()
    count = Counter(judged(each["causes"], known.get(name, "")) for name, each in rows.items())
    every = sum(name.startswith("wrong/") for name in stored_lines())
    return {word: count[word] / every for word in (RIGHTLY, WRONGLY)}


def main(arguments: Sequence[str]) -> int:
    """Grade, print and store."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--match", default="", help="only files whose name contains this")
    options = parser.parse_args(arguments)
    paths = [one.path for one in wrong_submissions() if options.match in name_of(one.path)]
    known, rows = misconceptions(), {}
    with ProcessPoolExecutor(2) as pool:
        for one in pool.map(row, paths, [options.seed] * len(paths)):
            name = one["submission"]
            word = judged(one["causes"], known.get(name, ""))
            print(f"{word:<10}  {name}  {one['causes']}", flush=True)  # noqa: T201 - a script
            rows[name] = one
    if options.seed == SEED:
        rows = {**stored(), **rows}
        store(rows)
    for word, share in shares(rows).items():
        print(f"{share:.1%} named {word}")  # noqa: T201 - a script
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
