"""How does our own work use several processors? Processes of ours, which no box needs.

They run this very program, so they hold what it holds; only the sandbox starts processes, so
that there is one place to look at.
"""

import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import Any, TypeVar

T = TypeVar("T")


def mapped(task: Callable[..., T], orders: Sequence[tuple[Any, ...]], jobs: int) -> Iterator[T]:
    """Call a task with the arguments of each order, and yield what it returns, in order.

    Args:
        task: A function of a module.
        orders: The arguments of each call.
        jobs: How many processes.
    """
    if not orders:
        return
    with ProcessPoolExecutor(min(jobs, len(orders)), initializer=_let_the_parent_stop) as pool:
        try:
            yield from pool.map(task, *zip(*orders, strict=True))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _let_the_parent_stop() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
