"""The controls above the panes; what does not fit into one row begins another."""

from collections.abc import Callable, Sequence
from types import ModuleType

from grader.language import Words
from grader.view.desk import Desk, Mode
from grader.view.panel import scaled
from grader.view.study import Study

CHOICE = 150
"""Pixels of a list or a slider, at the usual size of letters."""


class Row:
    """Puts controls beside each other."""

    def __init__(self, imgui: ModuleType) -> None:
        """Begin where ImGui is about to draw."""
        self._imgui, self._is_first = imgui, True
        self._edge = imgui.get_cursor_screen_pos().x + imgui.get_content_region_avail().x

    def choice(self, label: str) -> None:
        """Make room for a list or a slider, and give it its width."""
        inner = self._imgui.get_style().item_inner_spacing.x
        wide = scaled(self._imgui, CHOICE)
        self._next(wide + inner + self._text(label))
        self._imgui.set_next_item_width(wide)

    def tick(self, label: str) -> None:
        """Make room for a box to be ticked."""
        inner = self._imgui.get_style().item_inner_spacing.x
        self._next(self._imgui.get_frame_height() + inner + self._text(label))

    def button(self, label: str) -> None:
        """Make room for a button."""
        self._next(self._text(label) + 2 * self._imgui.get_style().frame_padding.x)

    def _next(self, width: float) -> None:
        imgui = self._imgui
        right = imgui.get_item_rect_max().x + imgui.get_style().item_spacing.x + width
        if not self._is_first and right <= self._edge:
            imgui.same_line()
        self._is_first = False

    def _text(self, label: str) -> float:
        return float(self._imgui.calc_text_size(label, hide_text_after_double_hash=True).x)


class Bar:
    """Draws the controls, and does what they stand for."""

    def __init__(
        self,
        desk: Desk,
        study: Study,
        scenes: Sequence[str],
        words: Words,
        actions: Sequence[tuple[str, Callable[[], None]]],
    ) -> None:
        """Prepare.

        Args:
            desk: What is shown.
            study: What is looked at more closely.
            scenes: Names of the stored scenes.
            words: Translates our own texts.
            actions: Labels of further buttons, and what those do.
        """
        self._desk, self._scenes, self._words = desk, list(scenes), words
        self._actions = (
            (words("Next failing node") + "###next-node", study.next_node),
            (words("Next failing ray") + "###next-ray", study.next_ray),
            *actions,
        )

    def draw(self, imgui: ModuleType) -> None:
        """Draw all of them."""
        desk, words, row = self._desk, self._words, Row(imgui)
        self._scene(imgui, row)
        label = words("BVH level") + "###level"
        row.choice(label)
        most = max(desk.deepest, 0)
        changed, level = imgui.slider_int(label, min(desk.level, most), -1, most)
        desk.level = level if changed else desk.level
        label = words("only this level") + "###only"
        row.tick(label)
        _, desk.only = imgui.checkbox(label, desk.only)
        label = words("Cost heatmap") + "###cost"
        row.tick(label)
        changed, hot = imgui.checkbox(label, desk.mode is Mode.COST)
        if changed:
            desk.compare(Mode.COST if hot else Mode.SHADED)
        for name, action in self._actions:
            row.button(name)
            if imgui.button(name):
                action()

    def _scene(self, imgui: ModuleType, row: Row) -> None:
        """Choose one."""
        label = self._words("Scene") + "###scene"
        row.choice(label)
        current = self._desk.subject.name if self._desk.subject else "..."
        if imgui.begin_combo(label, current):
            for name in self._scenes:
                if imgui.selectable(name, name == current)[0]:
                    self._desk.choose_scene(name)
            imgui.end_combo()
