"""What do the rows of the corpus say against the grader?"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache

from grader.certify.corpus import Wrong, name_of
from grader.certify.row import Row
from grader.model.stages import PARTS
from grader.score.rubric import load_rubric


class Kind(Enum):
    """What is wrong with a grader; the value is the title of its list."""

    FALSE_REJECT = "false rejects: a right submission loses points"
    FALSE_ACCEPT = "false accepts: a wrong submission keeps all points"
    UNSEEN = "unseen mistakes: the check that should see it does not fail"
    LEAK = "leaks: a mistake in one part costs points in the other"
    UNDECIDED = "undecided: not graded yet, our own fault, or a machine that is too busy"
    UNSTEADY = "flaky: two runs of one seed differ"
    WITHOUT_KILLER = "checks without a killer: no wrong submission is theirs"


@dataclass(frozen=True, slots=True)
class Hole:
    """One thing that speaks against the grader."""

    kind: Kind
    sentence: str


def holes(rows: Sequence[Row], wrong: Iterable[Wrong]) -> list[Hole]:
    """Judge rows of the corpus, each with what its file promises.

    Args:
        rows: Of any seeds; several of one seed are compared with each other.
        wrong: The wrong submissions; every other one is right.
    """
    promises = {name_of(one.path): one for one in wrong}
    decided = [row for row in rows if not row.broken]
    found = [hole for row in decided for hole in _against(row, promises.get(row.name))]
    settled = {(row.name, row.seed) for row in decided}
    found += [
        Hole(Kind.UNDECIDED, f"{_named(row)}: {', '.join(row.broken)}")
        for row in rows
        if row.broken and (row.name, row.seed) not in settled
    ]
    return found + list(_unsteady(decided))


def without_killer(rows: Iterable[Row], wrong: Iterable[Wrong]) -> list[Hole]:
    """Name the checks of the rubric that own no mistake that they see in every row."""
    owners = {name_of(one.path): one.checks[0] for one in wrong}
    missed = {row.name for row in rows if owners.get(row.name) not in row.failed}
    killers = {
        owners[row.name] for row in rows if row.name in owners and row.name not in missed
    }
    return [
        Hole(Kind.WITHOUT_KILLER, criterion.check)
        for criterion in load_rubric(None).criteria
        if criterion.check not in killers
    ]


def ran_twice(rows: Iterable[Row]) -> bool:
    """Tell whether anything was graded, and decided, twice with one seed."""
    runs = [(row.name, row.seed) for row in rows if not row.broken]
    return len(set(runs)) < len(runs)


def differing_seeds(rows: Iterable[Row]) -> list[str]:
    """Name the submissions whose failed checks depend on the seed: no hole, but luck."""
    seen = defaultdict(set)
    for row in rows:
        if not row.broken:
            seen[row.name].add((row.scores, row.failed))
    return sorted(name for name, told in seen.items() if len(told) > 1)


def _against(row: Row, promise: Wrong | None) -> Iterator[Hole]:
    if promise is None:
        if sum(row.scores) < sum(full_marks().values()):
            yield Hole(Kind.FALSE_REJECT, f"{_named(row)}: {told(row)}")
        return
    if sum(row.scores) >= sum(full_marks().values()):
        yield Hole(Kind.FALSE_ACCEPT, _named(row))
    unseen = [check for check in promise.checks if check not in row.failed]
    if unseen:
        yield Hole(Kind.UNSEEN, f"{_named(row)}: {', '.join(unseen)}; but {told(row)}")
    scores = dict(zip(PARTS, row.scores, strict=True))
    kept = promise.untouched
    if kept in scores and scores[kept] < full_marks()[kept]:
        yield Hole(Kind.LEAK, f"{_named(row)}: part {kept} has {scores[kept]:g}; {told(row)}")


@cache
def full_marks() -> dict[str, float]:
    """Points of each part."""
    criteria = load_rubric(None).criteria
    return {part: sum(one.points for one in criteria if one.part == part) for part in PARTS}


def _unsteady(rows: Iterable[Row]) -> Iterator[Hole]:
    seen: dict[tuple[str, int], Row] = {}
    for row in rows:
        first = seen.setdefault((row.name, row.seed), row)
        if row != first:
            yield Hole(Kind.UNSTEADY, f"{_named(row)}: {told(first)}, and then {told(row)}")


def _named(row: Row) -> str:
    return f"{row.name} (seed {row.seed})"


def told(row: Row) -> str:
    """Word a row: points, failed checks, and what the first of them says."""
    scores = " + ".join(f"{score:g}" for score in row.scores)
    words = f"{scores} points, failed: {', '.join(row.failed) or 'nothing'} {row.because}"
    return words.rstrip()
