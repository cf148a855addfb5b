"""What somebody looks at more closely: one node, or one ray and the nodes that it visits."""

from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from grader.language import Words
from grader.model.mesh import Bvh
from grader.model.trials import Trial
from grader.run.transfer import ray_table
from grader.view.camera import rays_of
from grader.view.desk import Desk, Mode
from grader.view.inspector import Judgement, NodeFacts, facts_of, judgement, next_of, picked
from grader.view.overlay import Stroke, of_node, of_walk
from grader.view.picture import wrong_pixels
from grader.view.shades import differing
from grader.view.stage import Stage, State
from grader.view.walking import Followed, Walk, deepest_known, walk_of

JUDGED_AT_ONCE = 50_000
"""Faces of a mesh; the nodes of a larger tree are judged once somebody looks at one."""


@dataclass(frozen=True, slots=True)
class _Asked:
    """A ray whose way was asked for."""

    row: int
    of: Followed
    failing: bool
    """Whether to go on to the next one if this one is right."""


class Study:
    """A selected node and a selected ray of what is on a desk."""

    def __init__(self, desk: Desk, words: Words = str) -> None:
        """Select nothing.

        Args:
            desk: What is shown.
            words: Translates our own texts.
        """
        self._desk, self.words = desk, words
        self._aside = ThreadPoolExecutor(1)
        self._stage: Stage | None = None
        self._judging: Future[Judgement] | None = None
        self._judged: Bvh | None = None
        self._asked: _Asked | None = None
        self._onward = False
        self._begun = False
        self._index = -1
        self.judgement: Judgement | None = None
        self.facts: NodeFacts | None = None
        self.walk: Walk | None = None
        self.step = 0
        self.pixel = (-1, -1)
        """Of the ray, in the right pane; negative if it is not a pixel's."""

        self.remark = ""
        """What came of the last wish, if that cannot be seen."""

    def close(self) -> None:
        """End the thread."""
        self._aside.shutdown(wait=True, cancel_futures=True)

    def advance(self) -> bool:
        """Take what is finished; tells whether anything is to be shown anew."""
        stage = self._desk.stage
        if stage is not self._stage:
            self._stage = stage
            self._forget()
        if stage is None:
            return False
        return self._judge(stage) | self._take_walk(stage) | self._begin(stage)

    @property
    def is_busy(self) -> bool:
        """Whether something that was asked for is still to come."""
        stage = self._desk.stage
        begins = stage is not None and bool(stage.subject.check) and not self._begun
        return begins or self._asked is not None or self._judging is not None

    def select(self, node: int) -> None:
        """Look at a node, if it exists."""
        stage = self._stage
        if stage is None or stage.tree is None or not 0 <= node < len(stage.tree.end):
            self.facts = None
            return
        self.facts = facts_of(stage.subject.mesh, stage.tree, node, self.judgement)

    def pick(self, pixel: tuple[int, int]) -> None:
        """Look at the node whose box lies under a pixel of the left pane."""
        desk, stage = self._desk, self._stage
        if stage is None or stage.tree is None or desk.orbit is None:
            return
        level = min(desk.level, desk.deepest)
        self.select(picked(stage.tree, desk.orbit, desk.size, pixel, (level, desk.only)))

    def next_node(self) -> None:
        """Look at the next node that is wrong."""
        self.remark = ""
        if self.judgement is None:
            self._onward = True
            return
        if self.judgement.unreadable:
            self.remark = self.judgement.unreadable
            return
        node = next_of(self.judgement.every, self.facts.node if self.facts else -1)
        if node < 0:
            self.remark = self.words("no node is wrong")
            return
        self.select(node)
        if self.facts is not None:
            self._desk.level = max(self._desk.level, min(self.facts.level, self._desk.deepest))

    def follow(self, pixel: tuple[int, int]) -> None:
        """Follow the ray of a pixel of the right pane."""
        desk = self._desk
        self.remark = ""
        if desk.orbit is None:
            return
        width, height = desk.size
        column = min(max(pixel[0], 0), width - 1)
        row = min(max(pixel[1], 0), height - 1)
        ray = rays_of(desk.orbit, width, height, np.array([row * width + column]))[0]
        self.pixel = column, row
        self._ask(
            Followed(ray, self.words("pixel ({column}, {row})").format(column=column, row=row)),
            failing=False,
        )

    def next_ray(self) -> None:
        """Follow the next ray whose result is wrong."""
        self.remark = ""
        stage = self._stage
        if stage is None:
            return
        if stage.subject.rays is not None:
            self._follow_given(self._index + 1, failing=True)
            return
        desk = self._desk
        if desk.mode is not Mode.DIFFERENCE:
            desk.compare(Mode.DIFFERENCE)
        mask = wrong_pixels(desk)
        wrong = np.zeros(0, np.int64) if mask is None else np.flatnonzero(mask)
        column, row = self.pixel
        place = next_of(wrong, row * desk.size[0] + column if column >= 0 else -1)
        if place < 0:
            self.remark = self.words("no pixel differs so far")
            return
        self.follow((place % desk.size[0], place // desk.size[0]))

    def walk_to(self, step: int) -> None:
        """Show the steps of the ray up to one."""
        if self.walk is not None:
            self.step = min(max(step, 0), len(self.walk.steps))
            node = self.walk.steps[self.step - 1].node if self.step else -1
            if node >= 0:
                self.select(node)

    def strokes(self) -> list[Stroke]:
        """What is to be drawn over the left pane, in space."""
        stage = self._stage
        if stage is None or stage.tree is None:
            return []
        found: list[Stroke] = []
        mesh = stage.subject.mesh
        if self.facts is not None:
            found += of_node(mesh, self.facts)
        if self.walk is not None:
            size = stage.subject.home.size
            found += of_walk(mesh, stage.tree, self.walk, self.step, size)
        return found

    @property
    def _trial(self) -> Trial | None:
        return self._stage.subject.trial if self._stage else None

    def _forget(self) -> None:
        self._judging = self._judged = self._asked = None
        self._begun = False
        self._index = -1
        self.judgement, self.facts, self.walk, self.step = None, None, None, 0
        self.pixel, self.remark = (-1, -1), ""

    def _judge(self, stage: Stage) -> bool:
        """Judge the submission's own tree aside; ours needs no judge."""
        small = len(stage.subject.mesh.faces) <= JUDGED_AT_ONCE
        wanted = small or self._onward or self.facts is not None
        if stage.tree is not None and self._judged is not stage.tree and wanted:
            self._judged = stage.tree
            self._judging = self._aside.submit(judgement, stage.subject.mesh, stage.tree)
        if self._judging is None or not self._judging.done():
            return False
        judging, self._judging = self._judging, None
        self.judgement = judging.result()
        if self.facts is not None:
            self.select(self.facts.node)
        if self._onward:
            self._onward = False
            self.next_node()
        return True

    def _begin(self, stage: Stage) -> bool:
        """Show at once what a counterexample is about."""
        if self._begun or stage.state is not State.TRACING or not stage.subject.check:
            return False
        if stage.subject.rays is not None:
            self._begun = True
            self._follow_given(0, failing=True)
            return True
        if self.judgement is None:
            return False
        self._begun = True
        self.next_node()
        return True

    def _follow_given(self, index: int, failing: bool) -> bool:
        """Follow a ray of the counterexample; tells whether there is one."""
        stage = self._stage
        if stage is None or stage.subject.rays is None:
            return False
        table = ray_table(stage.subject.rays)
        if index >= len(table):
            self._index = -1
            self.remark = self.words("no further ray is wrong")
            return False
        self._index, self.pixel = index, (-1, -1)
        self._ask(
            Followed(
                table[index], self.words("ray {index}").format(index=index), self._trial, index
            ),
            failing,
        )
        return True

    def _ask(self, of: Followed, failing: bool) -> None:
        stage = self._stage
        if stage is None:
            return
        if stage.state is State.ENDED:
            self.remark = self.words("your program has ended, so no ray can be followed")
        if stage.state is not State.TRACING:
            return
        self._asked = _Asked(stage.live.record(of.ray), of, failing)

    def _take_walk(self, stage: Stage) -> bool:
        asked = self._asked
        if asked is None or stage.tree is None or stage.live.rows_done <= asked.row:
            return False
        self._asked = None
        walk = walk_of(stage.subject.mesh, stage.tree, stage.live.walk(), asked.of)
        rays = stage.subject.rays
        onward = asked.failing and rays is not None and not _is_wrong(walk)
        if onward and self._follow_given(asked.of.index + 1, failing=True):
            return False
        self.walk = walk
        self.walk_to(deepest_known(walk) + 1)
        if walk.lost >= 0:
            self.select(walk.lost)
        return True


def _is_wrong(walk: Walk) -> bool:
    if walk.expected is None:
        return False
    pair = np.array([[walk.found], [walk.expected]], np.float32)
    return bool(differing(pair[0], pair[1])[0])
