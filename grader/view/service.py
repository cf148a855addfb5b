"""What a page asks of a desk, and what it is answered: plain values, one question at a time.

A desk is used from one thread. Whoever asks from another one puts the question into a line.
"""

import queue
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from typing import Any

import numpy as np

from grader.counterexample.shown import MOST_BOXES, boxes
from grader.errors import UsageError
from grader.gallery.coarse import coarsened
from grader.language import Words
from grader.model.mesh import Mesh
from grader.model.views import Model
from grader.plain import one_line
from grader.report.views import model_json
from grader.view.answers import Json, node_json, walk_json
from grader.view.aside import failed
from grader.view.asked import Unanswered, mode, number, numbers
from grader.view.camera import within
from grader.view.desk import Desk, Load
from grader.view.picture import Shown, shown
from grader.view.remote import home_of, orbit_at
from grader.view.stage import State
from grader.view.status import is_vain, status
from grader.view.study import Study
from grader.view.walking import deepest_known

PAUSE_SECONDS = 0.004
LARGEST_SIDE = 1024
MOST_FACES_SENT = 60_000
DEEPEST_SENT = MOST_BOXES.bit_length() - 1
"""The last level of boxes that a page is given."""


class Service:
    """Answers questions about a desk."""

    def __init__(self, desk: Desk, study: Study, words: Words) -> None:
        """Begin to listen; nothing is answered before `serve`.

        Args:
            desk: What is shown.
            study: What is looked at more closely.
            words: Translates our own texts.
        """
        self._desk, self._study, self._words = desk, study, words
        self._line: queue.Queue[tuple[Callable[[], Any], Future[Any]]] = queue.Queue()
        self._version = 0
        self._shown: Shown | None = None
        self._stale = True
        self._trees = 0
        self._tree: object = None
        self._sent: tuple[Mesh, Mesh] | None = None
        self._told = 0
        """Counts what was said, because a page may hear it in another order."""

        self._own_fault = ""
        self.is_over = False

    def ask(self, question: Callable[[], Any]) -> Any:  # noqa: ANN401 - whatever it returns
        """Have a question answered by the desk's own thread."""
        answer: Future[Any] = Future()
        self._line.put((question, answer))
        return answer.result()

    def serve(self) -> None:
        """Answer until it is over."""
        while not self.is_over and not is_vain(self._desk):
            begun: Future[Any] = Future()
            self._answer(self.advance, begun)
            fault = begun.exception()
            self._own_fault = str(fault) if fault is not None else self._own_fault
            try:
                question, answer = self._line.get(timeout=PAUSE_SECONDS)
            except queue.Empty:
                continue
            self._answer(question, answer)

    def _answer(self, question: Callable[[], Any], answer: Future[Any]) -> None:
        try:
            answer.set_result(question())
        except UsageError as fault:
            answer.set_exception(fault)
        except Exception as fault:  # noqa: BLE001 - one question is lost, not the viewer
            answer.set_exception(Unanswered(str(failed(fault))))

    def advance(self) -> None:
        """Look how far everything is."""
        changed = self._desk.advance()
        if changed | self._study.advance():
            self._stale = self._stale or changed
        tree = self._desk.stage.tree if self._desk.stage else None
        if tree is not self._tree:
            self._tree, self._trees = tree, self._trees + 1
        # The next wrong node may lie deeper, and nobody is to click a box that is not drawn.
        self._desk.level = min(self._desk.level, DEEPEST_SENT)

    def state(self) -> Json:
        """Say how everything is."""
        desk, study, words = self._desk, self._study, self._words
        traced = desk.stage.traced if desk.stage else None
        cost = differ = ""
        origin = desk.subject.origin if desk.subject else ""
        seen = self._shown
        self._told += 1
        if seen is not None and seen.wrong >= 0:
            differ = words("{count} pixels differ").format(count=f"{seen.wrong:,}")
        if seen is not None and seen.scale and traced is not None:
            text = words("tests per ray; on average {boxes} boxes, {triangles} faces")
            cost = text.format(
                boxes=f"{traced.box_tests:.1f}", triangles=f"{traced.triangle_tests:.1f}"
            )
        return {
            "told": self._told,
            "status": status(desk, words, study.told),
            "trouble": self._trouble(),
            "ended": desk.stage is not None and desk.stage.state is State.ENDED,
            "remark": one_line(study.remark or study.told(origin)),
            "subject": desk.subjects,
            "tree": self._trees,
            "scene": desk.subject.name if desk.subject else "",
            "level": desk.level,
            "only": desk.only,
            "mode": desk.mode.value,
            "scale": seen.scale if seen and seen.scale else None,
            "differ": differ,
            "cost": cost,
            "node": self._node(),
            "ray": None if study.walk is None else walk_json(study.walk, words),
            "step": study.step,
            "lost": deepest_known(study.walk) if study.walk else -1,
        }

    def model(self) -> Json | None:
        """Write the mesh and the uppermost boxes, as a report has them."""
        desk = self._desk
        subject, stage = desk.subject, desk.stage
        if subject is None:
            return None
        tree = stage.tree if stage else None
        none = np.zeros((0, 3), np.float32)
        low, high = boxes(tree) if tree is not None and len(tree.end) else (none, none)
        mesh = self._light(subject.mesh)
        nothing = np.zeros(0, np.int64)
        model = Model(
            "", subject.title, mesh, len(subject.mesh.faces), low, high, -1, (), nothing, None
        )
        return {**model_json(model), "home": home_of(subject.home, mesh)}

    def image(self, after: int) -> tuple[int, Shown, float] | None:
        """Return the right pane with its number, if it is another one."""
        desk = self._desk
        if self._stale:
            self._stale = False
            self._shown, self._version = shown(desk), self._version + 1
        if self._shown is None or self._version == after:
            return None
        share = desk.stage.traced.share if desk.stage else 0.0
        return self._version, self._shown, share

    def look(self, given: Mapping[str, Any]) -> None:
        """Move the camera as the page has it.

        Raises:
            UsageError: A number is none, or out of bounds.
        """
        desk = self._desk
        if desk.subject is None:
            return
        size = numbers(given, "size", 2)
        # By one factor, or what is traced has another shape than what the page draws.
        scale = min(1.0, LARGEST_SIDE / max(*size, 1.0))
        width, height = (int(max(scale * side, 16)) for side in size)
        orbit = orbit_at(given, desk.subject.home, self._light(desk.subject.mesh))
        if orbit != desk.orbit or (width, height) != desk.size:
            desk.size = width, height
            desk.look(orbit)
            self._stale = True

    def do(self, given: Mapping[str, Any]) -> Json:
        """Do what the page asks for, and say how everything is then.

        Raises:
            UsageError: It is nothing that can be asked for.
        """
        desk, study, what = self._desk, self._study, given.get("what")
        self._own_fault = ""
        alone: Mapping[str, Callable[[], None]] = {
            "next-node": study.next_node,
            "next-ray": study.next_ray,
            "again": desk.run_again,
        }
        if str(what) in alone:
            alone[str(what)]()
        elif what == "node":
            study.select(int(number(given, "node", 2**31)))
        elif what == "step":
            study.walk_to(int(number(given, "step", 2**31)))
        elif what in ("pick", "follow"):
            x, y = numbers(given, "at", 2)
            pixel = int(x * desk.size[0]), int(y * desk.size[1])
            study.pick(within(pixel, desk.size)) if what == "pick" else study.follow(pixel)
        elif what == "level":
            desk.level = int(max(number(given, "level", 64), -1))
            desk.only = given.get("only") is True
        elif what == "mode":
            desk.compare(mode(given.get("mode")))
            self._stale = True
        elif what == "scene":
            desk.choose_scene(str(given.get("scene")))
        else:
            raise UsageError("there is no such wish")
        desk.level = min(desk.level, DEEPEST_SENT)
        return self.state()

    def open(self, load: Load) -> Json:
        """Show what somebody dropped onto the page, once it is read."""
        self._own_fault = ""
        self._desk.choose(load)
        return self.state()

    def _trouble(self) -> str:
        desk = self._desk
        fault = desk.fault or self._own_fault
        if fault:
            return one_line(str(fault))
        product = desk.product
        if product is not None and product.engine is None and not desk.is_building:
            told = [
                self._study.told(product.refused),
                *(f"{one.line}: {one.text}" for one in product.diagnostics[:5]),
            ]
            return one_line(" / ".join(filter(None, told)))
        return one_line(self._study.told(desk.stage.trouble)) if desk.stage else ""

    def _node(self) -> Json | None:
        """Write the node that is looked at, with its faces if the page has those."""
        study, subject = self._study, self._desk.subject
        if study.facts is None or subject is None:
            return None
        whole = len(self._light(subject.mesh).faces) == len(subject.mesh.faces)
        return node_json(study.facts, study.judgement is not None, whole, self._words)

    def _light(self, mesh: Mesh) -> Mesh:
        """A mesh that is small enough for a page, made once."""
        if self._sent is None or self._sent[0] is not mesh:
            light = self._desk.light
            small = mesh if light is None else light
            if len(small.faces) > MOST_FACES_SENT:
                small, _ = coarsened(mesh, MOST_FACES_SENT)
            used = np.unique(small.faces)
            place = np.zeros(len(small.vertices), np.uint32)
            place[used] = np.arange(len(used), dtype=np.uint32)
            self._sent = mesh, Mesh(small.vertices[used], place[small.faces])
        return self._sent[1]
