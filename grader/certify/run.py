"""How are many rows graded, some at a time, so that a killed run can go on?"""

import signal
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from grader.certify.corpus import digest_of, name_of
from grader.certify.ledger import Ledger
from grader.certify.row import Row, graded_row

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


def certified_rows(work: Work, ledger: Ledger, tell: Callable[[Row], None]) -> list[Row]:
    """Grade what is missing in the ledger, and return every row of this work.

    Args:
        work: Which submissions, which seeds.
        ledger: Where results are kept.
        tell: Called with each new row, at once.
    """
    orders = [(path, seed) for seed in work.seeds for path in work.paths]
    waiting = orders if work.again else _undecided(orders, ledger)
    for attempt in range(ATTEMPTS):
        for row in _graded(waiting, 1 if attempt else work.jobs):
            ledger.add(row)
            tell(row)
        waiting = _undecided(waiting, ledger)
        if not waiting:
            break
    wanted = {_key(*order) for order in orders}
    return [row for row in ledger.rows() if (row.name, row.digest, row.seed) in wanted]


def _graded(orders: Sequence[tuple[Path, int]], jobs: int) -> Iterator[Row]:
    if not orders:
        return
    # Processes of ours: grading keeps more than one thread of Python busy.
    with ProcessPoolExecutor(min(jobs, len(orders)), initializer=_let_the_parent_stop) as pool:
        try:
            yield from pool.map(graded_row, *zip(*orders, strict=True))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _let_the_parent_stop() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _undecided(orders: Iterable[tuple[Path, int]], ledger: Ledger) -> list[tuple[Path, int]]:
    decided = {(row.name, row.digest, row.seed) for row in ledger.rows() if not row.broken}
    return [order for order in orders if _key(*order) not in decided]


def _key(path: Path, seed: int) -> tuple[str, str, int]:
    return name_of(path), digest_of(path), seed
