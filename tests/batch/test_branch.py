"""A worker's clerk does one order after the other, and does not outlive what it is for."""

import errno
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from grader.batch import branch
from grader.batch.parcel import Terms, packed_order, read_answer
from grader.batch.work import Order
from grader.kept import Result
from grader.sandbox.office import Done, Gone
from tests.batch.stand_in import ENTRY, SETTINGS, WISH
from tests.batch.test_parcel import SUBMISSION
from tests.batch.test_processes import clerks_of, until

ORDER = Order(SUBMISSION, WISH, SETTINGS)


@dataclass
class Worker:
    """Stands in for Dask's worker, in whose threads orders are done."""

    address: str = "tcp://127.0.0.1:1"
    told: list[object] = field(default_factory=list)

    def log_event(self, topic: str, news: object) -> None:
        """Remember what is passed on."""
        assert topic == "topic"
        self.told.append(news)


def test_a_clerk_is_kept_for_the_next_order_and_then_dismissed(
    log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """However the command ended that asked for it."""
    worker = Worker()
    monkeypatch.setattr("distributed.get_worker", lambda: worker)
    terms = Terms(ENTRY, 300.0, "", "topic")
    for ticket in (3, 4):
        answer = branch.done(ticket, packed_order(ORDER, terms), b"")
        news = read_answer(answer, ticket, ORDER)
        assert isinstance(news, Done)
        assert isinstance(news.result, Result)
        assert len(clerks_of(log)) == 1
    assert worker.told == [[3, "[red]tracing[/red]"], [4, "[red]tracing[/red]"]]
    monkeypatch.setattr(branch, "IDLE_SECONDS", 0.1)
    branch.done(5, packed_order(ORDER, terms), b"")
    until(lambda: not clerks_of(log))


def test_a_worker_without_room_costs_a_try_and_not_the_class(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Another one may have room; what Dask gets is an answer, and no task that failed."""

    def full() -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("distributed.get_worker", Worker)
    monkeypatch.setattr("grader.sandbox.office.scratch_folder", full)
    answer = branch.done(3, packed_order(ORDER, Terms(ENTRY, 301.0, "", "topic")), b"")
    news = read_answer(answer, 3, ORDER)
    assert isinstance(news, Gone)
    assert "No space left on device" in news.why
    assert Worker.address in news.why
