"""How is a class graded by a Dask cluster? As an office does it, with clerks elsewhere.

Theory of operation. Few orders are under way at a time, twice as many as the cluster has
threads: so neither this process nor the scheduler ever holds a whole class, and no thread waits
for us. Dask gives what a lost worker was doing to another one, up to its `allowed-failures`;
after that, or if a clerk dies, it is news of this one order. Nothing is stored but here, by who
asks for the news. Whatever is wrong with the cluster as a whole ends the block: what was graded
is kept, and the same command goes on.
"""

import gc
import hashlib
import logging
import secrets
import time
import warnings
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from queue import Empty, SimpleQueue
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol, Self

from grader.batch.branch import done
from grader.batch.job import Job
from grader.batch.parcel import Terms, packed_files, packed_order, read_answer
from grader.batch.work import Order
from grader.errors import MissingTool, UsageError, WorkerFault
from grader.plain import as_name, printable
from grader.sandbox.office import Gone, News, Notice, Told

if TYPE_CHECKING:
    from distributed import Client, Future

PATIENCE_SECONDS = 30.0
"""How long a scheduler may take to answer."""

LOOK_SECONDS = 5.0
"""How often the threads of a cluster are counted, which may come and go."""

ORDERS_A_THREAD = 2
"""One that is being done, and one that waits for its end."""

LONGEST_FAULT = 400
"""Characters of what Dask says that are shown."""

PROTOCOLS = ("tcp://", "tls://")

TALKATIVE = ("distributed", "distributed.client", "tornado", "asyncio")
"""Loggers of lost connections, which we word ourselves. Dask gives each of its own a level."""


# An assertion: on a machine that stands still, Dask's own thread is not there within its 10 s.
_UNREACHABLE = (OSError, ValueError, TypeError, ImportError, RuntimeError, AssertionError)


class Versioned(Protocol):
    """Knows what is installed on the machines of a cluster; a client of Dask does."""

    def get_versions(self) -> Any:  # noqa: ANN401 - Dask's own shape
        """Ask all of them."""


class Cluster:
    """Machines that do one order after the other, for as long as the block lasts."""

    def __init__(self, job: Job, seconds: float) -> None:
        """Connect to nothing yet.

        Args:
            job: The class; its `clerks` limit how many orders are under way.
            seconds: Wall time of an order after which something is wrong with a clerk.

        Raises:
            UsageError: The address is none, or own files cannot travel.
        """
        self._address = job.scheduler or ""
        if not self._address.startswith(PROTOCOLS):
            raise UsageError(
                f"--scheduler {self._address}: an address begins with {' or '.join(PROTOCOLS)}"
            )
        self._most = job.clerks
        self._own = packed_files(job.wish.rubric)
        digest = hashlib.sha256(self._own).hexdigest() if self._own else ""
        self._terms = Terms(job.entry, seconds, digest, f"bvhgrade-{secrets.token_hex(8)}")
        self._orders: dict[int, tuple[Order, Future[bytes]]] = {}
        self._heard: SimpleQueue[int | Told | Notice] = SimpleQueue()
        self._threads, self._counted_at = -1, 0.0

    def __enter__(self) -> Self:
        """Connect to the scheduler.

        Raises:
            MissingTool: Dask is not installed.
            WorkerFault: The scheduler does not answer, or speaks another version.
        """
        self._client = _connected(self._address)
        try:
            require_versions(self._client, self._address)
            self._client.subscribe_topic(self._terms.topic, self._hear)
            self._files = self._sent()
            self._count()
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        fault: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Take back every order that has not begun, and leave the cluster as it was."""
        self._orders.clear()
        self._close()

    @property
    def is_full(self) -> bool:
        """Enough orders are under way."""
        return self.busy >= (self._most or max(1, ORDERS_A_THREAD * self._threads))

    @property
    def busy(self) -> int:
        """How many orders are under way."""
        return len(self._orders)

    def give(self, ticket: int, order: Order) -> None:
        """Let some worker do an order.

        Args:
            ticket: What the news of it are known by.
            order: The submission, and how to grade it.

        Raises:
            WorkerFault: The scheduler is gone.
        """
        from distributed.client import ClosedClientError

        letter = packed_order(order, self._terms)
        try:
            future = self._client.submit(done, ticket, letter, self._files, pure=False)
        except ClosedClientError as fault:
            raise self._useless(fault) from fault
        self._orders[ticket] = order, future
        future.add_done_callback(lambda _: self._heard.put(ticket))

    def news(self) -> Iterator[News]:
        """Wait until something happens, and tell it.

        Raises:
            WorkerFault: The scheduler is gone, or cannot use what we sent.
        """
        with suppress(Empty):
            heard = self._heard.get(timeout=LOOK_SECONDS)
            if isinstance(heard, int):
                yield self._ended(heard, *self._orders.pop(heard))
            elif isinstance(heard, Notice) or heard.ticket in self._orders:
                yield heard
        if time.monotonic() >= self._counted_at + LOOK_SECONDS:
            self._count()

    def _hear(self, event: tuple[float, object]) -> None:
        """Pass on, from another thread, how far a worker says it is."""
        match event[1]:
            case [int(ticket), str(what)]:
                self._heard.put(Told(ticket, as_name(what)))

    def _ended(self, ticket: int, order: Order, future: "Future[bytes]") -> News:
        from distributed.scheduler import KilledWorker

        try:
            fault = future.exception()
            answer = None if fault else future.result()
        except (CancelledError, KilledWorker, OSError) as late:
            fault = late
        if fault is None:
            return read_answer(answer, ticket, order)
        if isinstance(fault, KilledWorker):
            # Dask's own words are about its own ways; how often is all that matters here.
            times = fault.allowed_failures + 1
            return Gone(ticket, f"{times} workers of the cluster ended over it")
        raise self._useless(fault)

    def _sent(self) -> "bytes | Future[bytes]":
        """Send the instructor's own files once, and not with each order.

        A task like the others, so that Dask makes it anew if the worker that holds it dies.
        """
        with warnings.catch_warnings():
            # Dask finds it large.
            warnings.simplefilter("ignore")
            return self._client.submit(bytes, self._own) if self._own else self._own

    def _count(self) -> None:
        """Count threads, and say so if they have become more or fewer."""
        self._counted_at = time.monotonic()
        try:
            threads = self._client.nthreads()
        except (CancelledError, OSError, ValueError) as fault:
            raise self._useless(fault) from fault
        before, self._threads = self._threads, sum(threads.values())
        if before != self._threads:
            said = _worded(self._address, len(threads), self._threads)
            self._heard.put(Notice(said))

    def _useless(self, fault: BaseException) -> WorkerFault:
        """Say that nothing can be graded there any more."""
        if self._client.status != "running" or isinstance(fault, CancelledError | OSError):
            return WorkerFault(f"the cluster {self._address} does not answer any more")
        said = printable(f"{type(fault).__name__}: {fault}", LONGEST_FAULT)
        return WorkerFault(
            f"the cluster {self._address} cannot do what it is asked, perhaps because its "
            f"scheduler or a worker has no bvhgrade, or another one: {said}"
        )

    def _close(self) -> None:
        # What cannot be said any more need not be: the scheduler sees that we are gone.
        with suppress(CancelledError, OSError):
            self._client.close(timeout=PATIENCE_SECONDS)


def _connected(address: str) -> "Client":
    """Connect to a scheduler.

    Raises:
        MissingTool: Dask is not installed.
        WorkerFault: The scheduler does not answer.
    """
    try:
        from distributed import Client
    except ImportError as fault:
        raise MissingTool(
            f"{fault}; --scheduler needs Dask: pip install 'bvhgrade[cluster]'"
        ) from fault
    for name in TALKATIVE:
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        with warnings.catch_warnings(), _uncollected():
            # It warns of other versions of anything; we look at those that matter.
            warnings.simplefilter("ignore")
            return Client(address, timeout=PATIENCE_SECONDS, set_as_default=False)
    except _UNREACHABLE as fault:
        why = printable(str(fault) or type(fault).__name__, LONGEST_FAULT)
        raise WorkerFault(f"the cluster {address} cannot be reached: {why}") from fault


@contextmanager
def _uncollected() -> Iterator[None]:
    """Keep Python from collecting garbage meanwhile.

    A client that could not connect closes itself when it is collected, and waits for a lock
    that one that starts holds: for ever, if that is what is going on in the same thread.
    Source: distributed, `Client.__del__` and `LoopRunner.start`.
    """
    was_enabled = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def require_versions(client: Versioned, address: str) -> None:
    """Demand the same Dask everywhere, or it fails later, in words that nobody understands.

    Raises:
        WorkerFault: It is another one somewhere.
    """
    found = client.get_versions()
    ours = _version(found["client"])
    others = {address: found["scheduler"], **found["workers"]}
    for name, told in others.items():
        if _version(told) != ours:
            raise WorkerFault(
                f"{printable(name)} has {_version(told)}, but this machine has {ours}; install "
                "the same on all machines of the cluster"
            )


def _version(told: Any) -> str:  # noqa: ANN401 - Dask's own shape
    python = ".".join(str(part) for part in told["host"]["python"].split(".")[:2])
    return f"Python {python} with distributed {told['packages']['distributed']}"


def _worded(address: str, workers: int, threads: int) -> str:
    if not threads:
        return f"the cluster {address} has no worker; waiting for one"
    return f"the cluster {address}: workers {workers:,}, submissions at a time {threads:,}"
