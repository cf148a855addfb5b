"""The two panes of a window: the preview on the left, what is traced on the right."""

import time
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from grader.model.mesh import Bytes
from grader.view.camera import Orbit, within
from grader.view.desk import Desk
from grader.view.overlay import projected
from grader.view.panel import colour_of
from grader.view.picture import Shown, is_old, shown
from grader.view.preview import Preview
from grader.view.shades import tint
from grader.view.steering import dragged, is_clicked
from grader.view.study import Study

if TYPE_CHECKING:
    import moderngl

SETTLED_SECONDS = 0.3
"""After the last move of the camera the whole mesh is drawn."""

SETTLED_FRAMES = 3
"""Without a move, for a machine on which one frame takes longer than that."""


FIRST_ROWS_SECONDS = 0.012
"""How long a frame waits for the first rows of a new view."""


class Panes:
    """Both panes, in the OpenGL of a window."""

    def __init__(self, desk: Desk, study: Study, context: "moderngl.Context") -> None:
        """Take over a window's OpenGL.

        Args:
            desk: What is shown.
            study: What is looked at more closely.
            context: OpenGL 3.3 or newer, which is ImGui's, too.
        """
        self._desk, self._study, self._context = desk, study, context
        self._preview = Preview(context)
        self._right: moderngl.Texture | None = None
        self._drawn: object = None
        self._subjects = -1
        self._tree: object = None
        self._moved, self._still = 0.0, SETTLED_FRAMES
        self._shown_as = desk.mode, False
        self.is_stale = True
        """Whether something else is traced than is shown."""

        self.shown: Shown | None = None
        self.preview_seconds = 0.0
        self.waited: list[float] = []
        """Seconds from each move of the camera to the first new rows."""

        self._waits = False

    def look(self, orbit: Orbit) -> None:
        """Move the camera."""
        if orbit == self._desk.orbit:
            return
        self._moved, self._still, self._waits = time.monotonic(), 0, True
        self._desk.look(orbit)

    def advance(self) -> None:
        """Look how far everything is."""
        self.is_stale |= self._desk.advance()
        stage = self._desk.stage
        if self._waits and stage is not None:
            traced = stage.traced
            if traced.orbit == self._desk.orbit and traced.share > 0:
                self.waited.append(time.monotonic() - self._moved)
                self._waits = False

    def load(self) -> None:
        """Give the graphics card what is new."""
        desk, preview = self._desk, self._preview
        if desk.subject is not None and self._subjects != desk.subjects:
            self._subjects, self._drawn = desk.subjects, None
            preview.tint = tint(desk.subject.albedo)
            preview.load("whole", desk.subject.mesh)
            preview.unload("moving")
            if desk.light is not None and desk.light is not desk.subject.mesh:
                preview.load("moving", desk.light)
        tree = desk.stage.tree if desk.stage else None
        if tree is not self._tree:
            self._tree, self._drawn = tree, None
            preview.load_tree(tree)

    @property
    def is_settled(self) -> bool:
        """Whether the whole mesh is drawn."""
        late = time.monotonic() - self._moved >= SETTLED_SECONDS
        return late and self._still >= SETTLED_FRAMES

    def left(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        """Draw the preview."""
        desk, preview = self._desk, self._preview
        self._still += 1
        moving, level = not self.is_settled, min(desk.level, desk.deepest)
        wanted = (desk.orbit, size, level, desk.only, moving)
        if desk.orbit is not None and wanted != self._drawn:
            begun = time.monotonic()
            preview.draw(desk.orbit, size, level, desk.only, moving)
            self._context.finish()
            self.preview_seconds = time.monotonic() - begun
            # As ImGui expects it.
            self._context.screen.use()
            self._drawn = wanted
        corner = imgui.get_cursor_screen_pos()
        _image(imgui, preview.texture, size, upright=False)
        if is_clicked(imgui):
            self._study.pick(pixel_at(_mouse(imgui, corner), size, desk.size))
        self._steered(imgui, size)
        if desk.orbit is not None:
            self._strokes(imgui, corner, size, desk.orbit)

    def right(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        """Draw what is traced."""
        # A moment for the first rows of a new view, so that they are in this very frame.
        end = time.monotonic() + FIRST_ROWS_SECONDS
        self.advance()
        while self._waits and self._desk.stage is not None and time.monotonic() < end:
            time.sleep(0.001)
            self.advance()
        wanted = self._desk.mode, is_old(self._desk)
        if self.is_stale or self._shown_as != wanted:
            self.is_stale, self._shown_as = False, wanted
            self.shown = shown(self._desk)
            if self.shown is not None:
                self._upload(self.shown.pixels)
        corner = imgui.get_cursor_screen_pos()
        _image(imgui, self._right if self.shown else None, size, upright=True)
        if is_clicked(imgui):
            self._study.follow(pixel_at(_mouse(imgui, corner), size, self._desk.size))
        self._steered(imgui, size)

    def _steered(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        orbit = self._desk.orbit
        if orbit is not None and imgui.is_item_hovered():
            self.look(dragged(imgui, orbit, size[1]))

    def _strokes(
        self,
        imgui: ModuleType,
        corner: Any,  # noqa: ANN401 - ImVec2
        size: tuple[int, int],
        orbit: Orbit,
    ) -> None:
        """Draw lines over the left pane."""
        drawn = imgui.get_window_draw_list()
        end = (corner.x + size[0], corner.y + size[1])
        drawn.push_clip_rect((corner.x, corner.y), end, True)
        for stroke in self._study.strokes():
            flat = projected(stroke, orbit, *size)
            colour = colour_of(imgui, flat.colour)
            for one, other in (flat.lines + np.array([corner.x, corner.y])).tolist():
                drawn.add_line(tuple(one), tuple(other), colour, flat.width)
        drawn.pop_clip_rect()

    def _upload(self, pixels: Bytes) -> None:
        size = pixels.shape[1], pixels.shape[0]
        if self._right is None or self._right.size != size:
            if self._right is not None:
                self._right.release()
            self._right = self._context.texture(size, 3, alignment=1)
        self._right.write(np.ascontiguousarray(pixels))


def _image(
    imgui: ModuleType, texture: "moderngl.Texture | None", size: tuple[int, int], upright: bool
) -> None:
    if texture is None:
        imgui.dummy(size)
        return
    first, last = ((0, 0), (1, 1)) if upright else ((0, 1), (1, 0))
    imgui.image(imgui.ImTextureRef(texture.glo), size, first, last)


def _mouse(imgui: ModuleType, corner: Any) -> tuple[float, float]:  # noqa: ANN401 - ImVec2
    at = imgui.get_mouse_pos()
    return at.x - corner.x, at.y - corner.y


def pixel_at(
    place: tuple[float, float], size: tuple[int, int], traced: tuple[int, int]
) -> tuple[int, int]:
    """Return column and row of what is traced at a place in a pane, which may be larger."""
    column, row = (int(place[axis] * traced[axis] / size[axis]) for axis in (0, 1))
    return within((column, row), traced)
