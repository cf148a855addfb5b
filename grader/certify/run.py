"""How are many rows graded, some at a time, so that a killed run can go on?"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from grader.certify.corpus import digest_of, name_of
from grader.certify.fates import Studied
from grader.certify.ledger import Ledger
from grader.certify.mutants import Mutant
from grader.certify.row import Row, graded_rows
from grader.certify.study import study_or_none
from grader.sandbox.crew import mapped

ATTEMPTS = 3
"""A machine that is too busy decides nothing; the later attempts run one at a time."""


@dataclass(frozen=True, slots=True)
class Work:
    """What is to be graded."""

    paths: Sequence[Path]
    seeds: Sequence[int]
    jobs: int
    again: bool
    """Grade also what the ledger knows, to compare two runs."""


@dataclass(frozen=True, slots=True)
class MutantWork:
    """What is to be studied."""

    mutants: Sequence[Mutant]
    seed: int
    """What they are graded with."""

    jobs: int


def certified_rows(work: Work, ledger: Ledger, tell: Callable[[Row], None]) -> list[Row]:
    """Grade what is missing in the ledger, and return every row of this work.

    Args:
        work: Which submissions, which seeds.
        ledger: Where results are kept.
        tell: Called with each new row, at once; a row that it refuses is not kept.
    """
    orders = [(path, seed) for path in work.paths for seed in work.seeds]
    waiting = orders if work.again else _undecided(orders, ledger)
    for attempt in range(ATTEMPTS):
        for rows in mapped(graded_rows, _by_file(waiting), 1 if attempt else work.jobs):
            for row in rows:
                tell(row)
                ledger.add(row)
        waiting = _undecided(waiting, ledger)
        if not waiting:
            break
    wanted = {_key(*order) for order in orders}
    return [row for row in ledger.rows() if (row.name, row.digest, row.seed) in wanted]


def _by_file(orders: Iterable[tuple[Path, int]]) -> list[tuple[Path, tuple[int, ...]]]:
    """Put the seeds of each file together, so that it is compiled once."""
    seeds: dict[Path, tuple[int, ...]] = {}
    for path, seed in orders:
        seeds[path] = (*seeds.get(path, ()), seed)
    return list(seeds.items())


def studied_mutants(
    work: MutantWork, ledger: Ledger, tell: Callable[[Studied], None]
) -> list[Studied]:
    """Study the mutants that are missing in the ledger, and return all of this work."""
    wanted = {mutant.digest for mutant in work.mutants}

    def known() -> dict[str, Studied]:
        every = (one for one in ledger.studied() if one.seed == work.seed)
        return {one.digest: one for one in every if one.digest in wanted}

    done = known()
    waiting = [(one, work.seed) for one in work.mutants if one.digest not in done]
    for studied in mapped(study_or_none, waiting, work.jobs):
        if studied:
            tell(studied)
            ledger.add_studied(studied)
    done = known()
    return [done[mutant.digest] for mutant in work.mutants if mutant.digest in done]


def _undecided(orders: Iterable[tuple[Path, int]], ledger: Ledger) -> list[tuple[Path, int]]:
    decided = {(row.name, row.digest, row.seed) for row in ledger.rows() if not row.broken}
    return [order for order in orders if _key(*order) not in decided]


def _key(path: Path, seed: int) -> tuple[str, str, int]:
    return name_of(path), digest_of(path), seed
