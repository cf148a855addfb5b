"""What is there of a picture that is being traced, from coarse to fine?

First one pixel of each block of 16 x 16 is traced, then of 4 x 4, then every one, row by row. A
ray that is traced paints its whole block. How many rays are asked for at a time follows from
how fast the last ones were, so that a new view need not wait for an old one.
"""

import time

import numpy as np

from grader.model.mesh import Indices, Integers, Mask
from grader.run.live import Live
from grader.view.camera import Orbit, frame_of, rays_of
from grader.view.levels import BLOCKS, Level, levels_of
from grader.view.shades import brightness

ROW_SECONDS = 0.008
"""How long one batch should take: a new view waits for so long at most."""

BATCH_PATIENCE = 2 * ROW_SECONDS
"""How long a new picture waits for the batch of the last one."""

AHEAD_SECONDS = 0.25
"""How much is asked for beforehand: so long nobody may have looked."""

FINE_SECONDS = 0.3
"""How long a view has to stay before every pixel of it is asked for: while somebody turns the
camera, the two coarser levels are all that is seen, and the processor is needed elsewhere."""

TOGETHER = 8
"""Batches whose rays are made at once."""

FIRST_RAYS = 32
MOST_RAYS = 8192
"""In one batch."""

PATIENCE = 3.0
"""Seconds without a single ray after which the submission is said to hang."""

LONGEST_LOOK = 0.25
"""Of the time between two looks so much counts: on a busy machine we wait in line, too."""


class Traced:
    """One picture by one living process; arrays are (H, W) and may be read at any time."""

    def __init__(self, live: Live) -> None:
        """Begin without a picture."""
        self._live = live
        self._wanted: tuple[Orbit, int, int] | None = None
        self._levels: tuple[Level, ...] = ()
        self._asked = self._seen = 0
        self._begun = self._rate = 0.0
        self._spent = live.trace_seconds
        self._unheard, self._looked = 0.0, time.monotonic()
        self.orbit: Orbit | None = None
        """The camera of the picture; None if there is none yet."""

        self.width = self.height = 0
        self.t = np.zeros((0, 0), np.float32)
        """(H, W) float32, where each ray hits; infinite for a miss."""

        self.bright = np.zeros((0, 0), np.uint8)
        """(H, W) uint8, as `shades.brightness` has it."""

        self.tests = np.zeros((0, 0), np.uint32)
        """(H, W) uint32: box tests and triangle tests of the ray that painted it."""

        self.seen = np.zeros((0, 0), np.bool_)
        """(H, W) bool, True where anything was painted."""

        self.fine = np.zeros((0, 0), np.bool_)
        """(H, W) bool, True for pixels that have their own ray."""

        self.seconds = 0.0
        """In `intersect`, for this picture, as the process says."""

        self.box_tests = self.triangle_tests = 0.0
        """Mean calls a ray of the finest level, so far."""

    @property
    def is_done(self) -> bool:
        """Whether every pixel has its own ray."""
        return (
            self._wanted is None and bool(self._levels) and self._seen == self._levels[-1].past
        )

    @property
    def share(self) -> float:
        """How much of the rays is done, 0 to 1."""
        return self._seen / self._levels[-1].past if self._levels else 0.0

    @property
    def block(self) -> int:
        """Side of the blocks that are being traced."""
        past = [one.block for one in self._levels if self._seen < one.past]
        return past[0] if past else 1 if self._levels else BLOCKS[0]

    def begin(self, orbit: Orbit, width: int, height: int) -> None:
        """Want another picture; the one before is dropped."""
        self._wanted = orbit, width, height
        self._live.turn()
        # The batch that is being traced ends soon; then the new picture can begin at once, also
        # for somebody who looks only now and then and goes on turning.
        end = time.monotonic() + BATCH_PATIENCE
        self._live.look()
        while self._live.is_ready and self._live.is_busy and time.monotonic() < end:
            time.sleep(0.001)
            self._live.look()
        self.advance()

    def advance(self) -> bool:
        """Ask for more, and take what came; tells whether anything was painted.

        How far the process is was looked at before, once for everything.
        """
        live = self._live
        now = time.monotonic()
        self._unheard += min(now - self._looked, LONGEST_LOOK)
        self._looked = now
        if not live.is_ready:
            self._unheard = 0.0
            return False
        if self._wanted is not None and not live.is_busy:
            self._start(*self._wanted)
            self._wanted = None
        painted = False
        if self._wanted is None and self._levels:
            painted = self._take()
        self._ask()
        return painted

    def hangs(self) -> bool:
        """Whether a ray is asked for, and for too long none came."""
        if not self._live.is_busy:
            self._unheard = 0.0
        return self._unheard > PATIENCE

    def pixel_of(self, place: int) -> tuple[int, int]:
        """Return column and row of the pixel whose ray has a place in the turn.

        Without a picture it is the first pixel.
        """
        if not self._levels:
            return 0, 0
        level = next((one for one in self._levels if place < one.past), self._levels[-1])
        row, column = divmod(min(place, level.past - 1) - level.first, level.columns)
        middle = level.block // 2
        return (
            min(column * level.block + middle, self.width - 1),
            min(row * level.block + middle, self.height - 1),
        )

    def now(self) -> tuple[int, int]:
        """Return column and row of the pixel that is being traced."""
        return self.pixel_of(self._live.rays_done())

    def _start(self, orbit: Orbit, width: int, height: int) -> None:
        self._live.clear()
        resized = (width, height) != (self.width, self.height)
        self.orbit, self.width, self.height = orbit, width, height
        self._levels = levels_of(width, height)
        self._asked = self._seen = 0
        self._begun = time.monotonic()
        self._spent, self.seconds = self._live.trace_seconds, 0.0
        self._boxes = self._triangles = 0
        if resized:
            self.t = np.full((height, width), np.inf, np.float32)
            self.bright = np.zeros((height, width), np.uint8)
            self.tests = np.zeros((height, width), np.uint32)
            self.seen = np.zeros((height, width), np.bool_)
            self.fine = np.zeros((height, width), np.bool_)
        self.fine[:] = False
        self._unheard = 0.0

    def _ask(self) -> None:
        """Keep the process busy for a while, level by level."""
        orbit = self.orbit
        if self._wanted is not None or orbit is None:
            return
        live = self._live
        stays = time.monotonic() - self._begun >= FINE_SECONDS
        past = self._levels[-1 if stays else -2].past
        while self._asked < past and live.may_ask():
            ahead = self._asked - live.rays_done()
            if ahead > max(2 * FIRST_RAYS, self._rate * AHEAD_SECONDS):
                return
            level = next(one for one in self._levels if self._asked < one.past)
            batch = self._batch()
            count = min(TOGETHER * batch, level.past - self._asked)
            pixels = self._pixels(level, self._asked, count)
            table = rays_of(orbit, self.width, self.height, pixels)
            for begin in range(0, count, batch):
                live.trace(table[begin : begin + batch], self._asked + begin)
            self._asked += count

    def _batch(self) -> int:
        """How many rays fit into one batch."""
        if not self._rate:
            return FIRST_RAYS
        return int(min(MOST_RAYS, max(1, self._rate * ROW_SECONDS)))

    def _pixels(self, level: Level, first: int, count: int) -> Integers:
        """(K,) int64, the pixels that stand for blocks."""
        places = np.arange(first - level.first, first - level.first + count)
        row, column = np.divmod(places, level.columns)
        middle = level.block // 2
        row = np.minimum(row * level.block + middle, self.height - 1)
        column = np.minimum(column * level.block + middle, self.width - 1)
        return np.asarray(row * self.width + column)

    def _take(self) -> bool:
        done = min(self._live.rays_done(), self._asked)
        if done <= self._seen:
            return False
        spent = self._live.trace_seconds
        self.seconds = max(spent - self._spent, 0.0)
        if self.seconds > 0:
            self._rate = done / self.seconds
        for level in self._levels:
            first, past = max(self._seen, level.first), min(done, level.past)
            if first < past:
                self._paint(level, first, past)
        self._seen, self._unheard = done, 0.0
        return True

    def _paint(self, level: Level, first: int, past: int) -> None:
        hits, tests = self._live.hits(first, past)
        if level.block == 1:
            self._count(tests, past - level.first)
        orbit = self.orbit
        if orbit is None:
            return
        painted = (
            (self.t, hits[:, 3]),
            (self.bright, brightness(hits, frame_of(orbit))),
            (self.tests, tests.sum(axis=1, dtype=np.uint32)),
            (self.seen, np.ones(past - first, np.bool_)),
            (self.fine, np.full(past - first, level.block == 1)),
        )
        for whole, values in painted:
            level.paint(whole, values, first)

    def _count(self, tests: Indices, rays: int) -> None:
        """Keep the mean of what the finest level costs."""
        boxes, triangles = tests.sum(axis=0, dtype=np.int64)
        self._boxes += int(boxes)
        self._triangles += int(triangles)
        self.box_tests, self.triangle_tests = self._boxes / rays, self._triangles / rays


def agreement(one: Mask, other: Mask) -> float:
    """Share of pixels on which two masks agree, both (...) bool."""
    return float((one == other).mean()) if one.size else 1.0
