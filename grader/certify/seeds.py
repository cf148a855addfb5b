"""With how many seeds was the whole corpus graded, and what spoke against the grader then?"""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from grader.certify.corpus import corpus_folder
from grader.certify.holes import Hole, Kind, ran_twice
from grader.certify.row import Row


@dataclass(frozen=True, slots=True)
class Tried:
    """One run over the whole corpus."""

    seeds: Sequence[int]
    files: int
    grades: int
    grader: str
    """State of the grader, as `grader_digest` says."""

    found: dict[str, int]
    """How many holes there are of each kind that was looked for, by its name."""


def tried_file() -> Path:
    """Where the last run is stored."""
    return corpus_folder() / "seeds.json"


def tried(rows: Sequence[Row], found: Iterable[Hole], grader: str) -> Tried:
    """Sum up a run over the whole corpus."""
    decided = {(row.name, row.seed) for row in rows if not row.broken}
    counts = Counter(hole.kind.name for hole in found)
    # That no two runs differ is worth nothing where there were no two.
    kinds = (kind for kind in Kind if kind is not Kind.UNSTEADY or ran_twice(rows))
    return Tried(
        sorted({row.seed for row in rows}),
        len({row.name for row in rows}),
        len(decided),
        grader,
        {kind.name: counts[kind.name] for kind in kinds},
    )


def store_tried(run: Tried) -> None:
    """Keep a run with several seeds; one seed is what the matrix tells.

    Fewer seeds do not replace more of the same grader, but they do replace those of another
    one: what it found does not hold any more, with however many seeds.
    """
    last = stored_tried()
    more = last is None or last.grader != run.grader or len(last.seeds) <= len(run.seeds)
    if more and len(run.seeds) > 1:
        tried_file().write_text(json.dumps(asdict(run), indent=1) + "\n")


def stored_tried() -> Tried | None:
    """Read the last run; None if there is none."""
    if not tried_file().exists():
        return None
    return Tried(**json.loads(tried_file().read_text()))


def tried_lines(run: Tried | None) -> list[str]:
    """Word a run for the certificate."""
    if run is None:
        return ["The whole corpus was graded with no other seed yet.\n"]
    first, last = run.seeds[0], run.seeds[-1]
    lines = [
        f"All {run.files} files were graded with {len(run.seeds)} seeds ({first} to {last}): "
        f"{run.grades} grades,\nby state `{run.grader}` of the grader.\n\n",
        "| what could be wrong | found |\n|---|---:|\n",
    ]
    looked = (kind for kind in Kind if kind.name in run.found)
    return [*lines, *(f"| {kind.value} | {run.found[kind.name]} |\n" for kind in looked)]
