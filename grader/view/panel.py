"""The column beside the panes: the picture's kind, one node, one ray, and what went wrong."""

from datetime import datetime
from pathlib import Path
from types import ModuleType

import numpy as np

from grader.errors import OutputFault
from grader.language import Words
from grader.plain import one_line
from grader.report.colours import HEAT
from grader.verify.check import vector
from grader.view.desk import Desk
from grader.view.dropped import safe_name
from grader.view.inspector import NodeFacts, some_faces
from grader.view.picture import Shown, titles
from grader.view.stage import State
from grader.view.study import Study
from grader.view.walking import cut_off, deepest_known, outcome_of, right_of

WIDTH = 300
"""Pixels at the usual size of letters."""

USUAL_FONT = 15

SCALE_STOPS = 24
GOOD, BAD, SOFT = (0.5, 0.85, 0.6, 1.0), (1.0, 0.45, 0.4, 1.0), (0.65, 0.68, 0.72, 1.0)


class Panel:
    """Draws the column; every text of a stranger goes through `one_line`."""

    def __init__(self, desk: Desk, study: Study, words: Words) -> None:
        self._desk, self._study, self._words = desk, study, words
        self.remark = ""
        """What came of the last picture or file."""

        self._seen: tuple[object, int] = None, 0
        """The ray and the step to which the list was scrolled."""

    def draw(self, imgui: ModuleType, shown: Shown | None) -> None:
        """Draw everything, from top to bottom."""
        self._kind(imgui)
        self._scale(imgui, shown)
        self._trouble(imgui)
        self._node(imgui)
        self._ray(imgui)

    def _kind(self, imgui: ModuleType) -> None:
        """Choose what the right pane shows."""
        desk, names = self._desk, titles(self._words)
        imgui.set_next_item_width(-1)
        if imgui.begin_combo("###mode", names[desk.mode]):
            for mode, name in names.items():
                if imgui.selectable(name, mode is desk.mode)[0]:
                    desk.compare(mode)
            imgui.end_combo()

    def _scale(self, imgui: ModuleType, shown: Shown | None) -> None:
        """Show what the colours mean."""
        if shown is None:
            return
        words = self._words
        if shown.wrong >= 0:
            imgui.text_wrapped(words("{count} pixels differ").format(count=f"{shown.wrong:,}"))
        if not shown.scale:
            return
        corner, width = imgui.get_cursor_screen_pos(), imgui.get_content_region_avail().x
        drawn = imgui.get_window_draw_list()
        for stop in range(SCALE_STOPS):
            colour = HEAT[255 * stop // (SCALE_STOPS - 1)]
            left = corner.x + width * stop / SCALE_STOPS
            drawn.add_rect_filled(
                (left, corner.y),
                (left + width / SCALE_STOPS + 1, corner.y + 12),
                colour_of(imgui, colour),
            )
        imgui.dummy((width, 12))
        text = words(
            "0 to {scale} tests per ray and more; on average {boxes} boxes, {triangles} faces"
        )
        traced = self._desk.stage.traced if self._desk.stage else None
        if traced is not None:
            imgui.text_wrapped(
                text.format(
                    scale=shown.scale,
                    boxes=f"{traced.box_tests:.1f}",
                    triangles=f"{traced.triangle_tests:.1f}",
                )
            )

    def _trouble(self, imgui: ModuleType) -> None:
        """Say what the submission, or a wish, came to."""
        desk, words, told = self._desk, self._words, self._study.told
        if desk.product is not None and desk.product.engine is None:
            imgui.text_colored(BAD, words("It does not compile:"))
            imgui.text_wrapped(one_line(told(desk.product.refused)))
            for each in desk.product.diagnostics[:8]:
                imgui.text_wrapped(f"{each.line}: {one_line(each.text, 300)}")
            if desk.stage is not None:
                imgui.text_wrapped(words("what is shown is the last build that did"))
        if desk.stage is not None and desk.stage.trouble:
            imgui.push_style_color(imgui.Col_.text, BAD)
            imgui.text_wrapped(one_line(told(desk.stage.trouble), 300))
            imgui.pop_style_color()
            if desk.stage.state is State.ENDED and imgui.button(words("Run it again")):
                desk.run_again()
        origin = told(desk.subject.origin) if desk.subject else ""
        fault = str(desk.fault or "")
        for text in (fault, self._study.remark, self.remark, origin):
            if text:
                imgui.text_wrapped(one_line(text, 300))

    def _node(self, imgui: ModuleType) -> None:
        words, facts = self._words, self._study.facts
        imgui.separator_text(words("Node"))
        if facts is None:
            imgui.text_wrapped(words("Click a box on the left, or enter a number."))
        changed, node = imgui.input_int("###node", facts.node if facts else 0)
        if changed:
            self._study.select(node)
        if facts is not None:
            self._facts(imgui, facts)

    def _facts(self, imgui: ModuleType, facts: NodeFacts) -> None:
        words, study = self._words, self._study
        imgui.text(
            words("level {level}, faces [{begin}, {end})").format(
                level=facts.level, begin=facts.begin, end=facts.end
            )
        )
        imgui.text_wrapped(some_faces(facts))
        imgui.text_wrapped(f"min {vector(facts.low)}")
        imgui.text_wrapped(f"max {vector(facts.high)}")
        if facts.parent >= 0 and imgui.small_button(f"{words('parent')} {facts.parent}"):
            study.select(facts.parent)
        for child in facts.children:
            imgui.same_line()
            if imgui.small_button(f"{words('child')} {child}"):
                study.select(child)
        if study.judgement is None:
            imgui.text_colored(SOFT, words("looking at every node ..."))
        elif not facts.faults:
            imgui.text_colored(GOOD, words("Nothing is wrong with this node."))
        for fault in facts.faults:
            imgui.push_style_color(imgui.Col_.text, BAD)
            imgui.text_wrapped(fault)
            imgui.pop_style_color()

    def _ray(self, imgui: ModuleType) -> None:
        words, study = self._words, self._study
        imgui.separator_text(words("Ray"))
        walk = study.walk
        if walk is None:
            imgui.text_wrapped(words("Click a pixel on the right to follow its ray."))
            return
        imgui.text(f"{walk.of.title}: {outcome_of(walk, words)}")
        if right_of(walk, words):
            imgui.text(right_of(walk, words))
        if walk.sentence:
            imgui.text_wrapped(walk.sentence)
        if imgui.arrow_button("###back", imgui.Dir.left):
            study.walk_to(study.step - 1)
        imgui.same_line()
        if imgui.arrow_button("###on", imgui.Dir.right):
            study.walk_to(study.step + 1)
        imgui.same_line()
        imgui.text(words("step {step} of {steps}").format(step=study.step, steps=walk.total))
        if cut_off(walk, words):
            imgui.text_wrapped(cut_off(walk, words))
        self._steps(imgui)

    def _steps(self, imgui: ModuleType) -> None:
        """List what the ray tested, in order."""
        words, study = self._words, self._study
        walk = study.walk
        if walk is None or not imgui.begin_child("###steps", (0, 0)):
            imgui.end_child()
            return
        lost = deepest_known(walk)
        for place, one in enumerate(walk.steps):
            what = words("node {node}") if one.node >= 0 else words("face {face}")
            name = what.format(node=one.node, face=one.face)
            if one.node < 0 and one.face < 0:
                name = words("something else")
            end = words("hit") if one.hit else words("missed")
            mark = "  <-- " + words("lost here") if place == lost else ""
            current = place == study.step - 1
            if imgui.selectable(f"{name}: {end}{mark}##{place}", current)[0]:
                study.walk_to(place + 1)
            # Once only: whoever scrolls elsewhere is left there.
            if current and self._seen != (walk, study.step):
                self._seen = walk, study.step
                imgui.set_scroll_here_y()
        imgui.end_child()


def scaled(imgui: ModuleType, width: float) -> float:
    """Return a width for letters of the size that they have, instead of the usual one."""
    return float(width * imgui.get_font_size() / USUAL_FONT)


def colour_of(imgui: ModuleType, rgb: tuple[int, int, int] | np.ndarray) -> int:
    """Pack a colour, three values from 0 to 255 or (3,) uint8 sRGB, as ImGui wants it."""
    red, green, blue = (int(value) / 255 for value in rgb)
    return int(imgui.get_color_u32((red, green, blue, 1.0)))


def saved(pixels: np.ndarray, subject: str, words: Words) -> str:
    """Save a picture, (H, W, 3) uint8 sRGB, and say where it is or why it is not.

    It lies where the program was started: a subject may be called by a file that anybody wrote.
    """
    from grader.view.screenshot import save

    # Nobody saves two in one microsecond.
    path = Path(f"bvhgrade-{safe_name(subject)}-{datetime.now():%H%M%S-%f}.png")
    try:
        save(pixels, path)
    except OutputFault as fault:
        return str(fault)
    return words("saved as {path}").format(path=path)
