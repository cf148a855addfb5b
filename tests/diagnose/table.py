"""Writes `grader/diagnose/patterns.csv`: `python -m tests.diagnose.table`.

The kill matrix says which checks see which wrong submission, `misconceptions.csv` what each of
them misunderstands. What a grader needs of both is small, and is shipped with it.
"""

import csv
from pathlib import Path

from grader.certify.corpus import corpus_folder
from grader.certify.matrix import stored_lines
from tests.own_files import ROOT

MISCONCEPTIONS = corpus_folder() / "misconceptions.csv"
PATTERNS = ROOT / "grader" / "diagnose" / "patterns.csv"


def misconceptions() -> dict[str, str]:
    """Map each wrong submission to its misconception; `` if none is looked for.

    Several, with a space between them, are names of the same mistake.
    """
    with MISCONCEPTIONS.open(newline="", encoding="utf-8") as file:
        return {line["submission"]: line["misconception"] for line in csv.DictReader(file)}


def table() -> str:
    """Write the table: a line a misconception and set of checks that fail together."""
    lines = stored_lines()
    rows = {
        (id, " ".join(check for check, letter in lines[name].items() if letter == "F"))
        for name, ids in misconceptions().items()
        for id in ids.split()
        if name in lines
    }
    words = [f"{id},{checks}" for id, checks in sorted(rows)]
    return "\n".join(["misconception,checks", *words]) + "\n"


def main(path: Path = PATTERNS) -> None:
    """Write the table anew."""
    path.write_text(table(), encoding="utf-8")


if __name__ == "__main__":
    main()
