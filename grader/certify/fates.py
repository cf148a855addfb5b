"""What became of the mutants: how many were caught, and which were not?"""

import csv
import tomllib
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from grader.certify.corpus import corpus_folder


class Fate(Enum):
    """What became of a mutant."""

    INVALID = "invalid"
    """It does not compile."""

    SAME_CODE = "same code"
    """The compiler makes the same machine code of it: it is no other program."""

    CAUGHT = "caught"
    """It loses points."""

    SAME_RESULTS = "same results"
    """It keeps all points, and returns what the original returns, bit by bit and count by
    count, in every trial of seeds that it was not graded with."""

    SURVIVED = "survived"
    """It keeps all points, and returns something else than the original somewhere."""


@dataclass(frozen=True, slots=True)
class Studied:
    """A mutant that was looked at, as the ledger keeps it."""

    digest: str
    seed: int
    """The seed that it was graded with."""

    original: str
    kind: str
    line: int
    change: str
    fate: str
    by: str
    """Of CAUGHT what saw it first, of SURVIVED the trial that shows a difference."""


EXPLAINED = "explained"
"""A survivor that is known to be right, and why."""

FATES = (*(fate.value for fate in Fate), EXPLAINED)

Counts = dict[str, int]


def counts_file() -> Path:
    """Where the counts are stored."""
    return corpus_folder() / "mutants.csv"


def explained_changes() -> dict[tuple[str, str], str]:
    """Read `equivalents.toml`: of an original and a change, why the mutant is right."""
    text = (corpus_folder() / "equivalents.toml").read_text()
    return {
        (entry["original"], change): entry["why"]
        for entry in tomllib.loads(text)["equivalent"]
        for change in entry["changes"]
    }


def survivors(found: Iterable[Studied]) -> list[Studied]:
    """Mutants that keep all points, are another program, and that nobody has explained."""
    kept = {Fate.SURVIVED.value, Fate.SAME_RESULTS.value}
    known = explained_changes()
    return [
        one for one in found if one.fate in kept and (one.original, one.change) not in known
    ]


def counts_of(found: Sequence[Studied]) -> dict[str, Counts]:
    """Count the fates of the mutants of each original; explained ones only as such."""
    known = explained_changes()
    counts: dict[str, Counts] = {}
    for one in found:
        line = counts.setdefault(one.original, dict.fromkeys(FATES, 0))
        kept = one.fate in {Fate.SURVIVED.value, Fate.SAME_RESULTS.value}
        line[EXPLAINED if kept and (one.original, one.change) in known else one.fate] += 1
    return counts


def share_caught(counts: Iterable[Counts]) -> float:
    """The share of the mutants that are other programs, and not known to be right.

    Same results prove nothing as long as nobody has explained them.
    """
    caught = kept = 0
    for line in counts:
        caught += line[Fate.CAUGHT.value]
        kept += line[Fate.SURVIVED.value] + line[Fate.SAME_RESULTS.value]
    return caught / max(1, caught + kept)


def store_counts(counts: dict[str, Counts], seed: int, grader: str) -> None:
    """Write the counts of these originals, and keep those of others.

    A larger sample that this grader has studied stays, too.

    Args:
        counts: By original.
        seed: What the mutants were drawn with.
        grader: State of the grader, as `grader_digest` says.
    """
    lines = _stored_lines()
    for name, line in counts.items():
        last = lines.get(name)
        if last is None or last["grader"] != grader or _size(last) <= _size(line):
            lines[name] = {"original": name, "seed": seed, "grader": grader, **line}
    with counts_file().open("w", newline="") as file:
        columns = ("original", "seed", "grader", *FATES)
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines[name] for name in sorted(lines))


def stored_counts() -> dict[str, Counts]:
    """Read the stored counts of each original."""
    lines = _stored_lines().items()
    return {name: {fate: int(line[fate]) for fate in FATES} for name, line in lines}


def stored_mutants() -> Counter[str]:
    """How many mutants each state of the grader studied; an empty one is unknown."""
    states: Counter[str] = Counter()
    for line in _stored_lines().values():
        states[str(line["grader"])] += _size(line)
    return states


def _stored_lines() -> dict[str, Mapping[str, str | int]]:
    if not counts_file().exists():
        return {}
    with counts_file().open(newline="") as file:
        return {line["original"]: line for line in csv.DictReader(file)}


def _size(line: Mapping[str, str | int]) -> int:
    return sum(int(line[fate]) for fate in FATES)
