"""One file, compiled again whenever it is saved; what ran last is kept until the next runs."""

import threading
from concurrent.futures import Executor, Future
from contextlib import ExitStack
from pathlib import Path

from grader.errors import GraderError
from grader.intake.saved import GLANCE_SECONDS, GONE, state_of
from grader.options import Options
from grader.run.session import Engine
from grader.sandbox.nursery import Nursery
from grader.sandbox.scratch import scratch_folder
from grader.view.aside import outcome
from grader.view.workshop import Product, built


class Builds:
    """The builds of one file."""

    engine: Engine | None = None
    """Of the last build that compiled; None as long as there is none."""

    def __init__(self, path: Path, options: Options, aside: Executor) -> None:
        """Begin to watch the file; nothing is compiled yet.

        Args:
            path: The submission.
            options: The rubric and the isolation.
            aside: Compiles.
        """
        self._path, self._options, self._aside = path, options, aside
        self._room, self._next_room = ExitStack(), ExitStack()
        """What that engine needs, and the build that is being made: a folder and boxes."""

        self._over = threading.Event()
        self._state = self._saved = GONE
        self._coming: Future[Product] | None = None
        threading.Thread(target=self._watch, daemon=True).start()

    @property
    def is_busy(self) -> bool:
        """Whether it is being compiled."""
        return self._coming is not None

    @property
    def is_stale(self) -> bool:
        """Whether something else was saved than is compiled."""
        return self._saved not in (GONE, self._state) and not self.is_busy

    def begin(self) -> None:
        """Compile what lies there now."""
        self._state = state_of(self._path)
        folder = self._next_room.enter_context(scratch_folder())
        nursery = self._next_room.enter_context(Nursery())
        self._coming = self._aside.submit(built, self._path, folder, nursery, self._options)

    def take(self) -> Product | GraderError | None:
        """Return what came of it, once; `engine` is its engine then, if it has one."""
        if self._coming is None or not self._coming.done():
            return None
        came, self._coming = outcome(self._coming), None
        if isinstance(came, GraderError) or came.engine is None:
            self._next_room.close()
        else:
            self.engine = came.engine
        return came

    def settle(self) -> None:
        """Let go of the engine before this one, of which nothing runs any more."""
        self._room.close()
        self._room, self._next_room = self._next_room, ExitStack()

    def end(self) -> None:
        """Watch no longer."""
        self._over.set()

    def close(self) -> None:
        """Let go of everything."""
        self._next_room.close()
        self._room.close()

    def _watch(self) -> None:
        """Look at the file until the end; what is the same for two looks counts as saved."""
        last = GONE
        while not self._over.wait(GLANCE_SECONDS):
            now = state_of(self._path)
            if now == last:
                self._saved = now
            last = now
