"""Which node is looked at, what is wrong with it, and which one is the next wrong one?"""

from dataclasses import replace

from grader.language import Words
from grader.view.desk import Desk
from grader.view.inspector import Judgement, NodeFacts, facts_of, next_of, picked
from grader.view.judging import Judging
from grader.view.stage import Stage, State


class Nodes:
    """At most one selected node of what is on a desk, and what is known of all the others."""

    def __init__(self, desk: Desk, words: Words, told: Words) -> None:
        """Select nothing.

        Args:
            desk: What is shown.
            words: Translates our own texts.
            told: Translates messages of checks.
        """
        self._desk, self.words, self._told = desk, words, told
        self._judging = Judging()
        self.facts: NodeFacts | None = None
        self.goes_on = False
        """Whether to go to the next wrong node, once all are judged."""

    @property
    def known(self) -> Judgement | None:
        """What is wrong with the tree; None if nobody has looked yet."""
        return self._judging.known

    @property
    def failed(self) -> str:
        """Why that will not be known, which is our fault; empty if nothing is in the way."""
        return self._judging.failed

    @property
    def is_busy(self) -> bool:
        """Whether a judgement is still to come."""
        return self._judging.is_busy

    def close(self) -> None:
        """End the thread."""
        self._judging.close()

    def forget(self) -> None:
        """Know and select nothing any more."""
        self._judging.forget()
        self.facts, self.goes_on = None, False

    def advance(self, stage: Stage) -> bool:
        """Have the tree judged aside; tells whether it just was."""
        if not self._judging.advance(stage, self.goes_on or self.facts is not None):
            return False
        if self.facts is not None:
            self.select(stage, self.facts.node)
        return True

    def select(self, stage: Stage | None, node: int) -> None:
        """Look at a node, if it exists."""
        if stage is None or stage.tree is None or not 0 <= node < len(stage.tree.end):
            self.facts = None
            return
        facts = facts_of(stage.subject.mesh, stage.tree, node, self.known)
        self.facts = replace(facts, faults=tuple(map(self._told, facts.faults)))

    def pick(self, stage: Stage | None, pixel: tuple[int, int]) -> None:
        """Look at the node whose box lies under a pixel of the left pane."""
        desk = self._desk
        if stage is None or stage.tree is None or desk.orbit is None:
            return
        shown = min(desk.level, desk.deepest), desk.only
        self.select(stage, picked(stage.tree, desk.orbit, desk.size, pixel, shown))

    def next_wrong(self, stage: Stage | None) -> str:
        """Look at the next node that is wrong.

        Returns:
            Why there is none, or none yet; empty if there is one.
        """
        self.goes_on = False
        if stage is None or (stage.tree is None and stage.state is State.ENDED):
            return self.words("there is no tree")
        if stage.subject.tree is not None:
            return self.words("the tree is the model solution's")
        if self.known is None:
            self.goes_on = not self.failed
            return self.failed or self.words("looking at every node ...")
        if not self.known.unreadable and self.to_wrong(stage):
            return ""
        return self._told(self.known.unreadable) or self.words("no node is wrong")

    def to_wrong(self, stage: Stage) -> bool:
        """Look at the next wrong node; tells whether there is one."""
        node = -1
        if self.known is not None:
            node = next_of(self.known.every, self.facts.node if self.facts else -1)
        if node < 0:
            return False
        self.select(stage, node)
        if self.facts is not None:
            desk = self._desk
            desk.level = max(desk.level, min(self.facts.level, desk.deepest))
        return True
