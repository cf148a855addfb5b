"""What does a machine of a cluster do with an order? It lets a clerk of its own grade it.

Theory of operation. A thread of a Dask worker calls `done` with an order and waits for a clerk,
a process of its own, as it is on one machine: so nothing that happens over a submission reaches
the worker, and each thread of a worker is one submission at a time. The clerk compares what its
own installation would do with what the class is graded by, and refuses if anything differs.
A clerk that has nothing to do for a while is dismissed, so that a batch that is over, however
it ended, leaves nothing on a worker.
"""

import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from grader.batch.parcel import Terms, packed_answer, read_order, unpack_files
from grader.batch.work import Order, Refused
from grader.errors import GraderError
from grader.sandbox.office import Done, Gone, Office, Told
from grader.sandbox.scratch import scratch_folder

IDLE_SECONDS = 60.0
"""How long a clerk waits for the next order; hiring one costs a few seconds."""


@dataclass(slots=True)
class _Branch:
    """An office with one clerk, and the files that it grades with."""

    terms: Terms
    office: Office
    rubric: Path | None
    closing: ExitStack
    idle_since: float = 0.0

    def do(self, order: Order) -> Done | Gone:
        self.office.give(0, replace(order, wish=replace(order.wish, rubric=self.rubric)))
        while True:
            for news in self.office.news():
                if not isinstance(news, Told):
                    return news


_idle: list[_Branch] = []
_lock = threading.Lock()


def done(letter: bytes, own: bytes) -> bytes:
    """Do an order.

    Args:
        letter: The order.
        own: The instructor's own files, packed.

    Returns:
        What became of it.
    """
    order, terms = read_order(letter)
    try:
        with _lent(terms, own) as branch:
            news = branch.do(order)
    except GraderError as fault:
        news = Gone(0, str(fault))
    return packed_answer(_signed(news))


def _signed(news: Done | Gone) -> Done | Gone:
    """Say which worker has something to complain of."""
    from distributed import get_worker

    here = f"the worker {get_worker().address}"
    if isinstance(news, Gone):
        return replace(news, why=f"{here}: {news.why}")
    if isinstance(news.result, Refused):
        return replace(news, result=Refused(f"{here} refuses: {news.result.why}"))
    return news


@contextmanager
def _lent(terms: Terms, own: bytes) -> Iterator[_Branch]:
    """Give a branch that nobody uses, or a new one; it waits for the next order afterwards."""
    with _lock:
        branch = next((one for one in _idle if one.terms == terms), None)
        if branch is not None:
            _idle.remove(branch)
    if branch is None:
        branch = _opened(terms, own)
    try:
        yield branch
    except BaseException:
        branch.closing.close()
        raise
    branch.idle_since = time.monotonic()
    with _lock:
        _idle.append(branch)
    timer = threading.Timer(IDLE_SECONDS, _dismiss)
    timer.daemon = True
    timer.start()


def _opened(terms: Terms, own: bytes) -> _Branch:
    with ExitStack() as stack:
        rubric = unpack_files(own, stack.enter_context(scratch_folder()))
        office = stack.enter_context(Office(terms.entry, 1, terms.seconds))
        return _Branch(terms, office, rubric, stack.pop_all())


def _dismiss() -> None:
    """Close what has had nothing to do for too long."""
    oldest = time.monotonic() - IDLE_SECONDS
    with _lock:
        over = [one for one in _idle if one.idle_since <= oldest]
        for one in over:
            _idle.remove(one)
    for one in over:
        one.closing.close()
