"""What somebody looks at more closely: one node, or one ray and the nodes that it visits."""

from dataclasses import replace

import numpy as np

from grader.language import Words
from grader.run.transfer import ray_table
from grader.view.camera import rays_of, within
from grader.view.desk import Desk, Mode
from grader.view.following import Following, Place, again
from grader.view.inspector import Judgement, NodeFacts
from grader.view.nodes import Nodes
from grader.view.overlay import Stroke, of_both
from grader.view.picture import (
    Comparison,
    compared,
    comparison,
    is_old,
    next_wrong,
    remark_of,
)
from grader.view.stage import Stage, State
from grader.view.subject import told_of
from grader.view.walking import Followed, Judged, Walk, deepest_known, unanswered
from grader.view.workshop import Product


class Study:
    """A selected node and a selected ray of what is on a desk."""

    def __init__(self, desk: Desk, words: Words = str, told: Words = str) -> None:
        """Select nothing.

        Args:
            desk: What is shown.
            words: Translates our own texts.
            told: Translates messages of checks, and what a submission did.
        """
        self._desk, self.words, self.told = desk, words, told
        self._nodes, self._following = Nodes(desk, words, told), Following()
        self._stage: Stage | None = None
        self._product: Product | None = None
        self._place: Place | None = None
        """To be looked at again, once the new process traces."""

        self._hunting = False
        """Whether to go to the next pixel that differs, once there is one."""

        self._failing = False
        """Whether to go on to the next given ray, if the one that is asked for is right."""

        self._wished = False
        """Whether somebody wished for that, and is told if there is none."""

        self._begun = False
        self._index = -1
        self.walk: Walk | None = None
        self.step = 0
        self.pixel = (-1, -1)
        """Of the ray, in the right pane; negative if it is not a pixel's."""

        self.remark = ""
        """What came of the last wish, if that cannot be seen."""

    def close(self) -> None:
        """End the thread."""
        self._nodes.close()

    @property
    def facts(self) -> NodeFacts | None:
        """The node that is looked at; None if there is none."""
        return self._nodes.facts

    @property
    def judgement(self) -> Judgement | None:
        """What is wrong with the tree; None if nobody has looked yet."""
        return self._nodes.known

    def advance(self) -> bool:
        """Take what is finished; tells whether anything is to be shown anew."""
        stage = self._desk.stage
        if stage is not self._stage:
            self._renew(stage)
        if stage is None:
            return False
        changed = self._judge(stage) | self._take_walk(stage)
        return changed | self._return(stage) | self._begin(stage) | self._hunt()

    @property
    def is_busy(self) -> bool:
        """Whether something that was asked for is still to come."""
        stage = self._desk.stage
        begins = stage is not None and bool(stage.subject.check) and not self._begun
        waits = self._following.pending is not None or self._nodes.is_busy
        return begins or waits or self._hunting

    def select(self, node: int) -> None:
        """Look at a node, if it exists."""
        self._nodes.select(self._stage, node)

    def pick(self, pixel: tuple[int, int]) -> None:
        """Look at the node whose box lies under a pixel of the left pane."""
        self._nodes.pick(self._stage, pixel)

    def next_node(self) -> None:
        """Look at the next node that is wrong, or say why there is none."""
        self.remark = self._nodes.next_wrong(self._stage)

    def follow(self, pixel: tuple[int, int]) -> None:
        """Follow the ray of a pixel of the right pane."""
        desk = self._desk
        self.remark, self._hunting = "", False
        if desk.orbit is None:
            return
        if is_old(desk):
            self.remark = self.words("the picture is of an earlier view: no ray is followed")
            return
        self.pixel = within(pixel, desk.size)
        column, row = self.pixel
        ray = rays_of(desk.orbit, *desk.size, np.array([row * desk.size[0] + column]))[0]
        title = self.words("pixel ({column}, {row})").format(column=column, row=row)
        expected, note = compared(desk, self.pixel, self.words)
        self._ask(Followed(ray, title, expected=expected, note=note), failing=False)

    def next_ray(self) -> None:
        """Follow the next ray whose result is wrong."""
        self.remark = ""
        stage = self._stage
        if stage is None:
            return
        if stage.subject.rays is not None:
            self._next_given(stage)
            return
        if self._desk.mode is not Mode.DIFFERENCE:
            self._desk.compare(Mode.DIFFERENCE)
        self._hunting = True
        self.remark = remark_of(Comparison.GOES_ON, self.words)
        self._hunt()

    def walk_to(self, step: int) -> None:
        """Show the steps of the ray up to one."""
        if self.walk is not None:
            self.step = min(max(step, 0), len(self.walk.steps))
            node = self.walk.steps[self.step - 1].node if self.step else -1
            if node >= 0:
                self.select(node)

    def strokes(self) -> list[Stroke]:
        """What is to be drawn over the left pane, in space."""
        return of_both(self._stage, self.facts, self.walk, self.step)

    def _renew(self, stage: Stage | None) -> None:
        """Forget what another process told; keep where one was, if it has the same mesh."""
        old, product = self._stage, self._desk.product
        ray = self.walk.of if self.walk else None
        # What was asked for, if it was not only on the way to a wrong one.
        ray = ray if self._failing else self._following.pending or ray
        if self.walk is not None and not self.walk.came_back and product is self._product:
            # The same build would only end in it again.
            ray = None
        node = self.facts.node if self.facts else -1
        if old is not None and (ray is not None or node >= 0):
            self._place = Place(old.subject.mesh, node, ray)
        self._stage, self._product = stage, product
        if self._place and (stage is None or self._place.mesh is not stage.subject.mesh):
            self._place = None
        self._nodes.forget()
        self._following.forget()
        self._begun = self._hunting = False
        self.walk, self.step, self.remark = None, 0, ""
        if self._place is None:
            self.pixel, self._index = (-1, -1), -1

    def _return(self, stage: Stage) -> bool:
        """Look at what one looked at before."""
        place = self._place
        if place is None or stage.tree is None or stage.state is State.CONSTRUCTING:
            return False
        self._place, self._begun = None, True
        self.remark = told_of(stage.subject, self.words, self.told)
        if place.node >= 0:
            self.select(place.node)
        if place.ray is not None:
            self._index = place.ray.index
            self._ask(again(place.ray), failing=False)
        return True

    def _judge(self, stage: Stage) -> bool:
        """Have the tree judged aside."""
        judged = self._nodes.advance(stage)
        if judged and self._nodes.goes_on:
            self.next_node()
        return judged

    def _begin(self, stage: Stage) -> bool:
        """Show at once what a counterexample is about."""
        if self._begun or not stage.subject.check or stage.state is State.CONSTRUCTING:
            return False
        if stage.subject.rays is not None:
            self._wished = False
            self._follow_given(stage, 0, failing=True)
        elif stage.tree is not None:
            if self.judgement is None and not self._nodes.failed:
                return False
            if not self._nodes.to_wrong(stage):
                self.select(0)
        self._begun = True
        self.remark = told_of(stage.subject, self.words, self.told)
        return True

    def _hunt(self) -> bool:
        """Follow the next pixel that differs, once there is one."""
        if not self._hunting:
            return False
        desk = self._desk
        pixel = next_wrong(desk, self.pixel)
        if pixel is not None:
            self.follow(pixel)
            return True
        state = comparison(desk)
        if state is Comparison.GOES_ON:
            return False
        self._hunting = False
        self.remark = remark_of(state, self.words)
        return True

    def _next_given(self, stage: Stage) -> None:
        """Follow the next wrong ray of a counterexample; of unknown ones simply the next."""
        known = isinstance(stage.subject.trial, Judged)
        self._wished = True
        if not self._follow_given(stage, self._index + 1, failing=known):
            self._pass_last(known)
            if not known:
                self._follow_given(stage, 0, failing=False)

    def _pass_last(self, known: bool) -> None:
        """Begin with the first ray the next time."""
        self._index = -1
        if known and self._wished:
            self.remark = self.words("no further ray is wrong")

    def _follow_given(self, stage: Stage, index: int, failing: bool) -> bool:
        """Follow a ray of the counterexample; tells whether there is one."""
        if stage.subject.rays is None:
            return False
        table = ray_table(stage.subject.rays)
        if index >= len(table):
            return False
        self._index, self.pixel = index, (-1, -1)
        title = self.words("ray {index}").format(index=index)
        self._ask(Followed(table[index], title, stage.subject.trial, index), failing)
        return True

    def _ask(self, of: Followed, failing: bool) -> None:
        stage = self._stage
        if stage is None:
            return
        self._failing = failing
        if not self._following.ask(stage, of) and stage.state is State.ENDED:
            self.remark = self.words("your program has ended, so no ray can be followed")
            self.walk, self.step = unanswered(of), 0

    def _take_walk(self, stage: Stage) -> bool:
        came = self._following.take(stage)
        if came is None:
            return False
        of, walk = came
        onward = self._failing and walk.wrong is False
        if onward and not self._follow_given(stage, of.index + 1, failing=True):
            self._pass_last(known=True)
        # Until a wrong one is found, the first is better than none.
        if onward and self.walk is not None:
            return True
        self.walk = replace(walk, sentence=self.told(walk.sentence))
        self.walk_to(deepest_known(walk) + 1)
        if walk.lost >= 0:
            self.select(walk.lost)
        return True
