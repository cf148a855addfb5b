"""What does a clerk do? One order after the other, until its office is gone."""

import os
import select
import signal
import socket
import sys
import threading
from contextlib import suppress
from importlib import import_module
from types import FrameType
from typing import Any, NoReturn

from grader.sandbox.launch import stop_everything
from grader.sandbox.letters import Ended, post, received


def main() -> None:
    """Do orders in the main thread, which lives as long as the boxes that it starts."""
    entry, number = sys.argv[1:]
    module, _, name = entry.partition(":")
    with socket.socket(fileno=int(number)) as desk:
        os.set_inheritable(desk.fileno(), False)
        signal.signal(signal.SIGTERM, _end)
        threading.Thread(target=_watch, args=(desk.fileno(),), daemon=True).start()
        work = getattr(import_module(module), name)

        def tell(what: Any) -> None:  # noqa: ANN401 - whatever the function says
            post(desk, ("told", what))

        with suppress(Ended, BrokenPipeError, ConnectionResetError):
            while True:
                post(desk, ("done", work(received(desk), tell)))


def _watch(desk: int) -> None:
    """Wait for the end of the office; a grading would see it only when it is done."""
    poll = select.poll()
    poll.register(desk, select.POLLRDHUP)
    poll.poll()
    os.kill(os.getpid(), signal.SIGTERM)


def _end(number: int, _: FrameType | None) -> NoReturn:
    """End all boxes at once, and then unwind, so that their folders are removed."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    stop_everything()
    raise SystemExit(128 + number)


if __name__ == "__main__":
    main()
