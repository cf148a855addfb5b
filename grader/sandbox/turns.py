"""Which workers of a submission run beside each other, and which alone?"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Turns:
    """Lets workers run side by side, or one of them alone."""

    def __init__(self) -> None:
        """Begin with nobody at work."""
        self._changed = threading.Condition()
        self._running = 0
        self.wanted = 0
        """How many want to be alone, or are."""

    @contextmanager
    def shared(self) -> Iterator[None]:
        """Run beside others, once nobody wants to be alone."""
        with self._changed:
            self._changed.wait_for(lambda: self.wanted == 0)
            self._running += 1
        try:
            yield
        finally:
            with self._changed:
                self._running -= 1
                self._changed.notify_all()

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Run when nobody else does."""
        with self._changed:
            self.wanted += 1
            self._changed.wait_for(lambda: self._running == 0)
            self._running += 1
        try:
            yield
        finally:
            with self._changed:
                self._running -= 1
                self.wanted -= 1
                self._changed.notify_all()
