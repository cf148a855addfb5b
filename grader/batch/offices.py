"""Who grades a class: clerks on this machine, or a cluster? Whoever asks need not know."""

import os
from collections.abc import Iterator
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Protocol

from grader.sandbox.office import News, Office

if TYPE_CHECKING:
    from grader.batch.job import Job
    from grader.batch.work import Order


class Staff(Protocol):
    """Does many orders at once, and outlives whoever dies over one."""

    @property
    def is_full(self) -> bool:
        """It takes no further order now."""

    @property
    def busy(self) -> int:
        """How many orders are being done."""

    def give(self, ticket: int, order: "Order") -> None:
        """Let an order be done; the news of it are known by the ticket."""

    def news(self) -> Iterator[News]:
        """Wait until something happens, and tell it."""


def staff(job: "Job", seconds: float) -> AbstractContextManager[Staff]:
    """Choose who grades a class.

    Args:
        job: The class.
        seconds: Wall time of an order after which something is wrong with a clerk.

    Raises:
        GraderError: A cluster was asked for, and cannot be had.
    """
    if job.scheduler is None:
        return Office(job.entry, job.clerks or usual_clerks(), seconds)
    from grader.batch.cluster import Cluster

    return Cluster(job, seconds)


def usual_clerks() -> int:
    """A submission keeps about two processors busy."""
    return max(1, len(os.sched_getaffinity(0)) // 2)
