"""How are boxes kept, so that the next case need not start one?

A box is kept for one library (or module) with one set of bounds, and only where the filter of
system calls keeps its targets from reaching the process that waits in it. Two threads that ask
at once get two boxes.
"""

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from subprocess import Popen
from types import TracebackType
from typing import Self

from grader.errors import WorkerFault
from grader.sandbox.box import Box, Isolation, Level
from grader.sandbox.kept import BoxLost, KeptBox, NotReached
from grader.sandbox.launch import Order, Outcome, begin
from grader.sandbox.target import ATTEMPTS, Target

_Key = tuple[object, ...]


class Nursery:
    """Boxes that wait for the next case; all of them end with the block that it heads."""

    def __init__(self) -> None:
        """Keep nothing yet."""
        self._idle: dict[_Key, list[KeptBox]] = {}
        self._lock = threading.Lock()
        self._starter = ThreadPoolExecutor(1)

    def __enter__(self) -> Self:
        """Begin the block."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        fault: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End every box; nothing runs in one any more."""
        with ExitStack() as ending:
            ending.callback(self._starter.shutdown)
            for kept in (kept for idle in self._idle.values() for kept in idle):
                ending.callback(kept.close)
            self._idle.clear()

    def run(self, target: Target, box: Box, entry: Path, isolation: Isolation) -> Outcome:
        """Run a module in a box; see `confined`.

        Raises:
            MissingTool: The interpreter or bubblewrap cannot be started.
            WorkerFault: A process cannot be ended or confined, or there is no user for it.
            Interrupted: The grader is being stopped.
        """
        seconds = box.bounds.cpu_seconds
        box = replace(box, bounds=replace(box.bounds, cpu_seconds=0))
        lost, said = None, ""
        for attempt in range(ATTEMPTS):
            try:
                with self._lent(target, box, entry, isolation, fresh=attempt > 0) as kept:
                    return kept.run(target, seconds)
            except NotReached as fault:
                said = str(fault)
            except BoxLost as fault:
                lost = fault.outcome
        if lost and not said:
            # What ended two boxes is the target after all: a machine without memory ends who
            # takes most of it.
            return lost
        raise WorkerFault(f"a process could not be confined ({isolation.level.value}): {said}")

    @contextmanager
    def _lent(
        self, target: Target, box: Box, entry: Path, isolation: Isolation, *, fresh: bool
    ) -> Iterator[KeptBox]:
        """Give a box that waits, or a new one; it is kept if it still waits afterwards."""
        environment = tuple(sorted((target.environment or {}).items()))
        key = (target.program, target.folder, environment, box, entry, isolation)
        with self._lock:
            idle = self._idle.setdefault(key, [])
            kept = idle.pop() if idle and not fresh else None
        if kept is None:
            kept = KeptBox(target, box, entry, isolation, self._start)
        well = False
        try:
            yield kept
            well = kept.alive and _is_kept(box, isolation)
        finally:
            if well:
                with self._lock:
                    self._idle[key].append(kept)
            else:
                kept.close()

    def _start(self, order: Order) -> Popen[bytes]:
        """Start a process from a thread that lives as long as this."""
        return self._starter.submit(begin, order).result()


def _is_kept(box: Box, isolation: Isolation) -> bool:
    """Whether a target cannot do anything to the process that waits."""
    return isolation.level is not Level.NONE and not box.starts_programs and not box.writable
