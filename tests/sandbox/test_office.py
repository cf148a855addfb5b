"""Clerks do orders, and the death of one is news of its own order only."""

import errno
import os
import signal

import pytest

from grader.errors import MissingTool
from grader.sandbox.office import Done, Gone, News, Office


def answer(order: str, tell: object) -> int:
    """Say which process it is; die if that is the order."""
    if order == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    return os.getpid()


def told(office: Office) -> News:
    """The next piece of news."""
    while True:
        for news in office.news():
            return news


def test_a_clerk_for_whom_there_is_no_room_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """As whatever keeps a process from being started; the next try may have it."""

    def full(**_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with Office(f"{__name__}:answer", 1, 60.0) as office:
        with monkeypatch.context() as patch:
            patch.setattr("tempfile.TemporaryFile", full)
            with pytest.raises(MissingTool, match="No space left on device"):
                office.give(1, "who")
        office.give(2, "who")
        assert isinstance(told(office), Done)


def test_a_clerk_that_died_without_an_order_costs_none() -> None:
    """The next order gets a living clerk."""
    with Office(f"{__name__}:answer", 1, 60.0) as office:
        office.give(1, "who")
        first = told(office)
        assert isinstance(first, Done)
        os.kill(first.result, signal.SIGKILL)
        os.waitid(os.P_PID, first.result, os.WEXITED | os.WNOWAIT)
        office.give(2, "who")
        second = told(office)
        assert isinstance(second, Done)
        assert second.ticket == 2
        office.give(3, "die")
        assert isinstance(told(office), Gone)


def test_a_clerk_that_is_still_starting_gets_its_first_order(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What no buffer holds waits for it longer than a letter of a running one may take."""
    monkeypatch.setattr("grader.sandbox.office.PATIENCE_SECONDS", 0.05)
    with Office(f"{__name__}:answer", 1, 60.0) as office:
        office.give(1, "x" * (4 << 20))
        assert isinstance(told(office), Done)
