"""A subject, the process that made a tree of it and traces it, and how both are doing."""

import math
import time
from enum import Enum

from grader.model.mesh import Bvh, Floats
from grader.model.stages import Stop
from grader.run.job import Job
from grader.run.live import Live
from grader.run.protocol import Op
from grader.run.session import Engine
from grader.run.transfer import give_mesh, give_tree, read_tree
from grader.view.camera import Orbit
from grader.view.subject import Subject
from grader.view.traced import Traced

CONSTRUCT_PATIENCE = 30.0
"""Seconds that making a tree may take."""

MOST_PIXELS = 1 << 20
"""Of one picture; with its coarser levels it has 7 % more rays."""

MOST_RAYS = MOST_PIXELS + (MOST_PIXELS >> 3)


def fitting(width: int, height: int) -> tuple[int, int]:
    """Shrink a picture to at most `MOST_PIXELS`, in the same shape."""
    scale = min(1.0, math.sqrt(MOST_PIXELS / (width * height)))
    return max(1, int(width * scale)), max(1, int(height * scale))


class State(Enum):
    """How a process is doing."""

    CONSTRUCTING = "constructing"
    TRACING = "tracing"
    ENDED = "ended"


class Stage:
    """One subject on one library."""

    def __init__(self, subject: Subject, engine: Engine, before: str = "") -> None:
        """Start the process.

        Args:
            subject: What is looked at.
            engine: The library.
            before: What the submission did before, so that a tree of ours is needed.
        """
        self.subject = subject
        self.state = State.CONSTRUCTING
        self.tree: Bvh | None = subject.tree
        """The tree that rays are traced on; None as long as it is not there."""

        self.trouble = before
        """What the submission did, if it ended; no message of ours is in it."""

        self.in_construct = False
        """Whether it ended before there was a tree."""

        self._rays: dict[int, str] = {}
        """Names of the rays whose way is asked for, by the number of their row."""

        self._begun = time.monotonic()
        self._hung = False
        job = Job()
        slot = give_mesh(job, subject.mesh)
        if subject.tree is not None:
            give_tree(job, slot, subject.tree)
        for mesh in subject.before:
            job.do(Op.CONSTRUCT, slot, give_mesh(job, mesh))
        if subject.tree is None:
            job.do(Op.CONSTRUCT, slot, slot)
        self._read = read_tree(job, slot, subject.mesh)
        self.live = Live(job, slot, engine, MOST_RAYS)
        self.traced = Traced(self.live)

    def advance(self) -> bool:
        """Look how far it is; tells whether the picture changed.

        Raises:
            GraderError: Our own fault: the process could not be run.
        """
        if self.live.fault is not None:
            raise self.live.fault
        if self.state is State.ENDED:
            return False
        self.live.look()
        if self.state is State.CONSTRUCTING:
            self._wait()
        painted = self.traced.advance()
        if self.live.ending is not None:
            self._note_end()
        elif self.traced.hangs():
            self._hung = True
            self.live.end()
        return painted

    def show(self, orbit: Orbit, width: int, height: int) -> None:
        """Trace another picture; one that is too large is traced in fewer pixels."""
        if self.state is not State.ENDED:
            self.traced.begin(orbit, *fitting(width, height))

    def record(self, ray: Floats, name: str) -> int:
        """Ask for the way of one ray.

        Args:
            ray: (8,) float32.
            name: What it is called, should the submission end in it.

        Returns:
            Its row, as `Live.record` has it.
        """
        row, done = self.live.record(ray), self.live.rows_done
        # It can end in none of those that are done.
        self._rays = {one: told for one, told in self._rays.items() if one >= done}
        self._rays[row] = name
        return row

    @property
    def is_tracing(self) -> bool:
        """Whether more of the picture is to come soon."""
        return self.state is State.TRACING and not self.traced.is_done

    def close(self) -> None:
        """End the process."""
        self.live.close()

    @property
    def construct_seconds(self) -> float:
        """How long `construct` took, as the process says; 0 if the tree is ours."""
        return self.live.construct_seconds

    def _wait(self) -> None:
        if self.live.is_ready:
            self._take_tree()
        elif time.monotonic() - self._begun > CONSTRUCT_PATIENCE:
            self._hung = True
            self.live.end()

    def _take_tree(self) -> None:
        if self.subject.tree is None:
            self.tree = self._read(self.live.result)
        self.state = State.TRACING

    def _note_end(self) -> None:
        ending = self.live.ending
        if ending is None:
            return
        # Since the last look it may have come further.
        self.live.look()
        if self.state is State.CONSTRUCTING and self.live.is_ready:
            self._take_tree()
        self.in_construct = self.state is State.CONSTRUCTING
        self.state = State.ENDED
        # Nobody asked it to end, however well it did.
        what = ending.detail or "the program ended itself"
        if self._hung or ending.stop is Stop.TIMED_OUT:
            what = "did not come back and was stopped"
        if self.in_construct:
            self.trouble = f"construct: {what}"
            return
        self.trouble = f"intersect, {self._last_ray()}: {what}"

    def _last_ray(self) -> str:
        """Name the ray in which it ended: one that is followed, or the picture's next."""
        column, row = self.traced.now()
        return self._rays.get(self.live.rows_done, f"pixel ({column}, {row})")
