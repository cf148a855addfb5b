"""How does the grader end early, with everything that it started?"""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Stopped(KeyboardInterrupt):
    """A signal asked the grader to end; an interrupt, so that nobody handles it on the way."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.status = 128 + number
        """What a shell calls this end."""


@contextmanager
def interruptible() -> Iterator[None]:
    """Let a signal end all processes of submissions at once, and then the grader.

    Without this the grader would wait for workers that run, each up to its own limit.

    Raises:
        Stopped: A signal came.
    """
    from grader.sandbox.launch import stop_everything

    def end(number: int, _: FrameType | None) -> NoReturn:
        stop_everything()
        raise Stopped(number)

    before = {number: signal.signal(number, end) for number in SIGNALS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
