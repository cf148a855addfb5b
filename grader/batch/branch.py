"""What does a machine of a cluster do with an order? It lets a clerk of its own grade it.

Theory of operation. A thread of a Dask worker calls `done` with an order and waits for a clerk,
a process of its own, as it is on one machine: so nothing that happens over a submission reaches
the worker, and each thread of a worker is one submission at a time. The clerk compares what its
own installation would do with what the class is graded by, and refuses if anything differs.
A clerk that has nothing to do for a while is dismissed, so that a batch that is over, however
it ended, leaves nothing on a worker.
"""

import atexit
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from grader.batch.parcel import Terms, packed_answer, read_order, unpack_files
from grader.batch.work import Order, Refused
from grader.errors import GraderError
from grader.sandbox.office import Done, Gone, Notice, Office, Told
from grader.sandbox.scratch import scratch_folder

IDLE_SECONDS = 60.0
"""How long a clerk waits for the next order; hiring one costs a few seconds."""


@dataclass(slots=True, eq=False)
class _Branch:
    """An office with one clerk, and the files that it grades with."""

    terms: Terms
    office: Office
    rubric: Path | None
    end: Callable[[], None]
    free_since: float | None = None
    """None while it does an order."""

    def do(self, order: Order, ticket: int, tell: Callable[[Told], None]) -> Done | Gone:
        wish = replace(order.wish, rubric=self.rubric)
        self.office.give(ticket, replace(order, wish=wish))
        while True:
            for news in self.office.news():
                if isinstance(news, Told):
                    tell(news)
                elif not isinstance(news, Notice):
                    return news


_branches: list[_Branch] = []
_lock = threading.Lock()


def done(ticket: int, letter: bytes, own: bytes) -> bytes:
    """Do an order, in a thread of a Dask worker.

    Args:
        ticket: What it is known by to whoever asked for it.
        letter: The order.
        own: The instructor's own files, packed.

    Returns:
        What became of it.
    """
    from distributed import get_worker

    worker = get_worker()
    order, terms = read_order(letter)
    try:
        with _lent(terms, own) as branch:
            news = branch.do(
                order,
                ticket,
                lambda news: worker.log_event(terms.topic, [news.ticket, str(news.what)]),
            )
    except GraderError as fault:
        news = Gone(ticket, str(fault))
    except OSError as fault:
        # Another worker may have room on its disk.
        news = Gone(ticket, f"no clerk could be hired: {fault.strerror or fault}")
    return packed_answer(_signed(news, worker.address))


def _signed(news: Done | Gone, address: str) -> Done | Gone:
    """Say which worker it is that complains."""
    if isinstance(news, Gone):
        return replace(news, why=f"worker {address}: {news.why}")
    if isinstance(news.result, Refused):
        return replace(news, result=Refused(f"worker {address} refuses: {news.result.why}"))
    return news


@contextmanager
def _lent(terms: Terms, own: bytes) -> Iterator[_Branch]:
    """Lend a branch that nobody uses, or a new one; afterwards it waits for the next order."""
    branch = _free(terms) or _opened(terms, own)
    try:
        yield branch
    except BaseException:
        _close([branch])
        raise
    branch.free_since = time.monotonic()
    timer = threading.Timer(IDLE_SECONDS, _dismiss)
    timer.daemon = True
    timer.start()


def _free(terms: Terms) -> _Branch | None:
    with _lock:
        for branch in _branches:
            if branch.terms == terms and branch.free_since is not None:
                branch.free_since = None
                return branch
    return None


def _opened(terms: Terms, own: bytes) -> _Branch:
    with ExitStack() as stack:
        rubric = unpack_files(own, stack.enter_context(scratch_folder()))
        office = stack.enter_context(Office(terms.entry, 1, terms.seconds))
        branch = _Branch(terms, office, rubric, stack.pop_all().close)
    with _lock:
        _branches.append(branch)
    return branch


def _dismiss() -> None:
    """Close what has had nothing to do for too long."""
    oldest = time.monotonic() - IDLE_SECONDS
    with _lock:
        over = [
            one for one in _branches if one.free_since is not None and one.free_since <= oldest
        ]
        for one in over:
            one.free_since = None
    _close(over)


@atexit.register
def _close_all() -> None:
    _close(list(_branches))


def _close(over: list[_Branch]) -> None:
    for branch in over:
        with _lock:
            if branch not in _branches:
                continue
            _branches.remove(branch)
        branch.end()
