"""A worker's clerk does one order after the other, and does not outlive what it is for."""

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from grader.batch import branch
from grader.batch.parcel import Terms, packed_order, read_answer
from grader.batch.work import Order
from grader.kept import Result
from grader.sandbox.office import Done
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
