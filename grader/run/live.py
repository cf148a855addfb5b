"""A worker that stays: it makes a tree, then traces one batch of rays after the other.

Theory of operation. The process is confined as every worker is, by the same box. Rays, hits and
counts lie in its result file, whose size is sealed; what is to be traced is said on a pipe, row
by row, and the process counts the rays that it has done. So nobody has to wait: whoever looks
now and then sees how far it came, and if it dies, at which ray. The rows of a turn that is over
are skipped. All that is read is the submission's word, copied before it is looked at; nothing
is decided by it.
"""

import mmap
import os
import threading
import time
from collections import deque
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from grader.errors import GraderError
from grader.model.mesh import Floats, Indices
from grader.model.path import Path as Walk
from grader.model.stages import Ending, Stop
from grader.run.job import Job, Result
from grader.run.protocol import CONSTRUCT_NS, ROW, TRACE_NS, TURN, Op
from grader.run.session import MODULES, PLAIN, Allowance, Engine, bounds_of, ending_of
from grader.run.transfer import HIT_BYTES, MOST_STEPS, RAY_BYTES, STEP_WORDS, path_of
from grader.sandbox.box import Box
from grader.sandbox.confine import confined
from grader.sandbox.stage import staged
from grader.sandbox.target import Target

TRACER = (*MODULES, Path(__file__).with_name("tracer.py"))
FOR_LONG = Allowance(1e9, 1e9)
"""Whoever looks at it ends it; its own limits are those of memory and the like."""

MOST_ROWS = 512
"""Rows on their way; a pipe has room for 1,024."""


@dataclass(frozen=True, slots=True)
class _Room:
    """Where things lie in the result: byte offsets."""

    rays: int
    hits: int
    tests: int
    done: int
    ray: int
    hit: int
    steps: int
    step_count: int


class Live:
    """One living process; use it from one thread at a time."""

    rows_done = 0
    """How many rows it says it has done, as of the last `look`."""

    def __init__(self, job: Job, slot: int, engine: Engine, most_rays: int) -> None:
        """Start it.

        Args:
            job: What it does first: it makes a mesh and its tree.
            slot: Of that mesh.
            engine: The library, and what it may use.
            most_rays: How many rays one turn may have.
        """
        self.most_rays = most_rays
        self._job, self._slot, self._engine = job, slot, engine
        self._first_rows = job.row_count
        self._room = _Room(
            rays=job.reserve(most_rays * RAY_BYTES),
            hits=job.reserve(most_rays * HIT_BYTES),
            tests=job.reserve(most_rays * 8),
            done=job.reserve(MOST_ROWS * 8),
            ray=job.reserve(MOST_ROWS * RAY_BYTES),
            hit=job.reserve(HIT_BYTES),
            steps=job.reserve(MOST_STEPS * STEP_WORDS * 4),
            step_count=job.reserve(8),
        )
        self._held = ExitStack()
        self._given, self._file = self._held.enter_context(job.files())
        self._memory = mmap.mmap(self._file, job.result_size)
        self.result = Result(self._file, job.result_size)
        """What the job's own readers read, once `is_ready`."""

        self._orders, self._ask = os.pipe()
        self._until = os.eventfd(0, os.EFD_CLOEXEC)
        os.set_blocking(self._ask, False)
        self._begin_turn()
        self._asked = 0
        self._rows: deque[tuple[int, int]] = deque()
        """Number and rays of each row that is on its way."""

        self._whole = 0
        """Rays of this turn whose rows are done."""

        self.ending: Ending | None = None
        """How the process ended; None while it lives."""

        self.fault: GraderError | None = None
        """Our own fault, if it could not be run."""

        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _begin_turn(self) -> None:
        self._turn = getattr(self, "_turn", 0) + 1
        self._memory[TURN : TURN + 8] = self._turn.to_bytes(8, "little")

    @property
    def is_ready(self) -> bool:
        """Whether it has done its job, and waits for rays."""
        return self.rows_done >= self._first_rows

    def look(self) -> None:
        """Read how far it is.

        The submission can write this number at any time. So it is read here alone, only grows,
        and never beyond what was asked for: between two looks all answers fit together.
        """
        said = min(self.result.number(16), self._first_rows + self._asked)
        self.rows_done = max(self.rows_done, said)

    @property
    def is_busy(self) -> bool:
        """Whether it still has rows to do."""
        return self.rows_done < self._first_rows + self._asked

    @property
    def is_running(self) -> bool:
        """Whether anything of it is still there."""
        return self._thread.is_alive()

    @property
    def construct_seconds(self) -> float:
        """How long `construct` took, as it says."""
        return self.result.number(CONSTRUCT_NS) * 1e-9

    @property
    def trace_seconds(self) -> float:
        """How long all calls of `intersect` took so far, as it says."""
        return self.result.number(TRACE_NS) * 1e-9

    def turn(self) -> None:
        """Let go of everything that was asked for; what is on its way is skipped."""
        self._begin_turn()

    def clear(self) -> None:
        """Begin to count anew.

        Raises:
            AssertionError: It is still busy with the turn before.
        """
        if self.is_busy:
            raise AssertionError("what was asked for before is done, or skipped")
        self._rows.clear()
        self._whole = 0

    def may_ask(self) -> bool:
        """Whether there is room for half as many rows as there may be."""
        self._count()
        return self.ending is None and len(self._rows) < MOST_ROWS // 2

    def trace(self, rays: Floats, first: int) -> None:
        """Ask for the hits of some rays.

        Args:
            rays: (K, 8) float32, as `ray_table` lays them out.
            first: Their place in the turn, right behind those that were asked for before.
        """
        room, count = self._room, len(rays)
        at = room.rays + first * RAY_BYTES
        self._memory[at : at + count * RAY_BYTES] = rays.tobytes()
        number = self._first_rows + self._asked
        done = room.done + number % MOST_ROWS * 8
        self._memory[done : done + 8] = bytes(8)
        hits, tests = room.hits + first * HIT_BYTES, room.tests + first * 8
        self._send(Op.TRACE, self._slot, at, count, hits, tests, done, self._turn)
        self._rows.append((number, count))

    def record(self, ray: Floats) -> int:
        """Ask for the way of one ray, (8,) float32.

        Returns:
            Once `rows_done` is larger than this, `walk` reads it.
        """
        room, number = self._room, self._first_rows + self._asked
        # Each has a place of its own: the one before may still wait, and is not to become this.
        at = room.ray + number % MOST_ROWS * RAY_BYTES
        self._memory[at : at + RAY_BYTES] = ray.tobytes()
        self._memory[room.step_count : room.step_count + 8] = bytes(8)
        self._send(Op.RECORD, self._slot, at, room.hit, room.steps, MOST_STEPS, room.step_count)
        return number

    def walk(self) -> Walk:
        """Read the way that was asked for last."""
        room = self._room
        return path_of(self.result, room.hit, room.steps, room.step_count)

    def _send(self, *row: int) -> None:
        self._asked += 1
        try:
            os.write(self._ask, ROW.pack(*row, *[0] * (8 - len(row))))
        except OSError:
            # It ended; the thread will say how.
            return

    def rays_done(self) -> int:
        """How many rays of this turn have been traced; they are the first ones."""
        self._count()
        if not self._rows:
            return self._whole
        number, count = self._rows[0]
        done = self.result.number(self._room.done + number % MOST_ROWS * 8)
        return self._whole + min(done, count)

    def _count(self) -> None:
        done = self.rows_done
        while self._rows and self._rows[0][0] < done:
            self._whole += self._rows.popleft()[1]

    def hits(self, first: int, past: int) -> tuple[Floats, Indices]:
        """Copy what came of rays.

        Returns:
            (K, 7) float32 point, t and normal; (K, 2) uint32 box tests and triangle tests.
        """
        count, room = past - first, self._room
        table = self.result.array(room.hits + first * HIT_BYTES, count * 7, np.float32)
        tests = self.result.array(room.tests + first * 8, count * 2, np.uint32)
        return table.reshape(-1, 7), tests.reshape(-1, 2)

    def end(self) -> None:
        """Have the process killed, if it still lives; does not wait."""
        if self._thread.is_alive():
            os.eventfd_write(self._until, 1)

    def close(self) -> None:
        """End it, and wait until it is gone."""
        self.end()
        self._thread.join()
        if self._ask >= 0:
            for descriptor in (self._ask, self._orders, self._until):
                os.close(descriptor)
            self._ask = -1
            self._held.close()

    def _run(self) -> None:
        """Start the process and wait for its end, in a thread of its own."""
        begun = time.monotonic()
        engine = self._engine
        try:
            entry = staged(TRACER)
            target = Target(
                program="tracer",
                arguments=[str(engine.library)],
                seconds=FOR_LONG.wall_seconds,
                output_bytes=engine.limits.output_kib << 10,
                descriptors=(self._given, self._file, self._orders),
                environment=PLAIN,
                until=self._until,
            )
            box = Box((entry.parent, engine.library), bounds_of(engine, FOR_LONG))
            outcome = confined(target, box, entry, engine.isolation, engine.nursery)
            self.ending = ending_of(outcome, self._job, self.result, FOR_LONG)
        except GraderError as fault:
            self.fault = fault
            lasted = time.monotonic() - begun
            self.ending = Ending(Stop.FAILED_TO_START, str(fault), lasted, 0.0, "")
