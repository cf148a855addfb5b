"""The window: two panes under one bar and a column beside them, drawn with Dear ImGui."""

import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from grader.errors import MissingTool, UsageError
from grader.language import Words
from grader.model.mesh import Bytes
from grader.view.camera import Orbit
from grader.view.desk import Desk, Mode
from grader.view.needed import INSTALL, NO_DISPLAY
from grader.view.overlay import projected
from grader.view.panel import WIDTH, Panel, colour_of, saved
from grader.view.picture import Shown, shown
from grader.view.preview import Preview
from grader.view.screenshot import panes
from grader.view.shades import tint
from grader.view.status import status
from grader.view.study import Study
from grader.view.subject import of_file

if TYPE_CHECKING:
    import moderngl

SETTLED_SECONDS = 0.3
"""After the last move of the camera the whole mesh is drawn."""

TURN = 0.008
"""Radians for each pixel that the mouse is dragged."""

KEY_TURN, KEY_ZOOM = 0.1, 0.85
SIZE = (1440, 760)


class Window:
    """What is shown of a desk, and what the mouse and the keys do to it."""

    def __init__(self, desk: Desk, study: Study, scenes: Sequence[str], words: Words) -> None:
        """Prepare; nothing is drawn yet.

        Args:
            desk: What is shown.
            study: What is looked at more closely.
            scenes: Names of the stored scenes.
            words: Translates our own texts.
        """
        self.desk, self.study, self.words = desk, study, words
        self.scenes = list(scenes)
        self.panel = Panel(desk, study, words)
        self.shown: Shown | None = None
        self.preview_seconds = 0.0
        self.waited: list[float] = []
        """Seconds from each move of the camera to the first new rows."""

        self.frames = 0
        self._context: moderngl.Context | None = None
        self._preview: Preview | None = None
        self._right: moderngl.Texture | None = None
        self._drawn: object = None
        self._subjects = -1
        self._tree: object = None
        self._moved, self._waiting = 0.0, False
        self._stale = True

    def prepare(self) -> None:
        """Take over the window's OpenGL, and what is dropped on it."""
        import moderngl

        self._context = moderngl.create_context(require=330)
        self._preview = Preview(self._context)

    def frame(self) -> None:
        """Draw one frame, and do what was asked for in it."""
        from imgui_bundle import imgui

        self.frames += 1
        self._advance()
        self._load()
        self._bar(imgui)
        wide = WIDTH * imgui.get_font_size() / 15
        room, gap = imgui.get_content_region_avail(), imgui.get_style().item_spacing.x
        height = room.y - imgui.get_frame_height_with_spacing()
        width = (room.x - wide - 2 * gap) / 2
        size = max(int(width), 16), max(int(height), 16)
        self.desk.resize(*size)
        self._left_pane(imgui, size)
        imgui.same_line()
        self._right_pane(imgui, size)
        imgui.same_line()
        if imgui.begin_child("##panel", (0, size[1])):
            self.panel.draw(imgui, self.shown)
        imgui.end_child()
        self._keys(imgui)
        imgui.text_unformatted(self.status())

    def status(self) -> str:
        """Put the numbers of the moment into one line."""
        told = status(self.desk, self.words)
        return f"{told}   preview {1000 * self.preview_seconds:.0f} ms"

    def look(self, orbit: Orbit) -> None:
        """Move the camera, if it is another one."""
        if orbit != self.desk.orbit:
            self._moved, self._waiting = time.monotonic(), True
            self.desk.look(orbit)

    def open(self, path: Path) -> None:
        """Show a mesh or a counterexample from a file."""
        try:
            subject = of_file(path)
        except UsageError as fault:
            self.panel.saved = str(fault)
            return
        self.desk.choose(lambda: subject)

    def save(self) -> None:
        """Save what is shown as a picture, where the program was started."""
        if self.desk.orbit is None or self._context is None:
            return
        pixels = panes(self.desk, self.study, Preview(self._context))
        self._context.screen.use()
        name = self.desk.subject.name if self.desk.subject else "view"
        path = Path(f"bvhgrade-{name}-{time.strftime('%H%M%S')}.png")
        self.panel.saved = saved(pixels, path, self.words)

    def _advance(self) -> None:
        changed = self.desk.advance()
        self.study.advance()
        stage = self.desk.stage
        if changed:
            self._stale = True
        if self._waiting and changed and stage and stage.traced.orbit == self.desk.orbit:
            self.waited.append(time.monotonic() - self._moved)
            self._waiting = False

    def _load(self) -> None:
        """Give the graphics card what is new."""
        desk, preview = self.desk, self._preview
        if preview is None:
            return
        if desk.subject is not None and self._subjects != desk.subjects:
            self._subjects, self._drawn = desk.subjects, None
            preview.tint = tint(desk.subject.albedo)
            preview.load("whole", desk.subject.mesh)
            if desk.light is not None and desk.light is not desk.subject.mesh:
                preview.load("moving", desk.light)
            else:
                preview.unload("moving")
        tree = desk.stage.tree if desk.stage else None
        if tree is not self._tree:
            self._tree, self._drawn = tree, None
            preview.load_tree(tree)

    def _bar(self, imgui: ModuleType) -> None:
        """Draw the controls above the panes."""
        desk, words = self.desk, self.words
        imgui.set_next_item_width(150)
        current = desk.subject.name if desk.subject else "..."
        if imgui.begin_combo(words("Scene") + "##scene", current):
            for name in self.scenes:
                if imgui.selectable(name, name == current)[0]:
                    desk.choose_scene(name)
            imgui.end_combo()
        imgui.same_line()
        imgui.set_next_item_width(150)
        most = max(desk.deepest, 0)
        level = min(desk.level, most)
        changed, level = imgui.slider_int(words("BVH level") + "##level", level, -1, most)
        desk.level = level if changed else desk.level
        imgui.same_line()
        _, desk.only = imgui.checkbox(words("only this level") + "##only", desk.only)
        imgui.same_line()
        changed, on = imgui.checkbox(words("Cost heatmap") + "##cost", desk.mode is Mode.COST)
        if changed:
            desk.compare(Mode.COST if on else Mode.SHADED)
            self._stale = True
        actions = (
            (words("Next failing node") + "##next-node", self.study.next_node),
            (words("Next failing ray") + "##next-ray", self.study.next_ray),
            (words("Reset view") + "##reset", self._reset),
            (words("Save picture") + "##save", self.save),
        )
        for name, action in actions:
            imgui.same_line()
            if imgui.button(name):
                action()

    def _reset(self) -> None:
        if self.desk.subject is not None:
            self.look(self.desk.subject.home)

    def _left_pane(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        desk, preview, context = self.desk, self._preview, self._context
        if preview is None or context is None:
            return
        moving = time.monotonic() - self._moved < SETTLED_SECONDS
        level = min(desk.level, desk.deepest)
        wanted = (desk.orbit, size, level, desk.only, moving)
        if desk.orbit is not None and wanted != self._drawn:
            begun = time.monotonic()
            preview.draw(desk.orbit, size, level, desk.only, moving)
            context.finish()
            self.preview_seconds = time.monotonic() - begun
            # As ImGui expects it.
            context.screen.use()
            self._drawn = wanted
        corner = imgui.get_cursor_screen_pos()
        self._image(imgui, preview.texture, size, upright=False)
        if self._clicked(imgui):
            self.study.pick(self._pixel(imgui, corner))
        self._steer(imgui, size)
        if desk.orbit is not None:
            self._strokes(imgui, corner, size)

    def _strokes(self, imgui: ModuleType, corner: Any, size: tuple[int, int]) -> None:  # noqa: ANN401 - ImVec2
        """Draw lines over the left pane."""
        drawn = imgui.get_window_draw_list()
        end = (corner.x + size[0], corner.y + size[1])
        drawn.push_clip_rect((corner.x, corner.y), end, True)
        for stroke in self.study.strokes():
            flat = projected(stroke, self.desk.orbit, *size)
            colour = colour_of(imgui, flat.colour)
            for one, other in (flat.lines + np.array([corner.x, corner.y])).tolist():
                drawn.add_line(tuple(one), tuple(other), colour, flat.width)
        drawn.pop_clip_rect()

    def _right_pane(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        if self._stale:
            self._stale = False
            self.shown = shown(self.desk)
            if self.shown is not None:
                self._upload(self.shown.pixels)
        corner = imgui.get_cursor_screen_pos()
        self._image(imgui, self._right if self.shown else None, size, upright=True)
        if self._clicked(imgui):
            self.study.follow(self._pixel(imgui, corner))
        self._steer(imgui, size)

    def _image(
        self,
        imgui: ModuleType,
        texture: "moderngl.Texture | None",
        size: tuple[int, int],
        upright: bool,
    ) -> None:
        if texture is None:
            imgui.dummy(size)
            return
        first, last = ((0, 0), (1, 1)) if upright else ((0, 1), (1, 0))
        imgui.image(imgui.ImTextureRef(texture.glo), size, first, last)

    def _upload(self, pixels: Bytes) -> None:
        if self._context is None:
            return
        size = pixels.shape[1], pixels.shape[0]
        if self._right is None or self._right.size != size:
            if self._right is not None:
                self._right.release()
            self._right = self._context.texture(size, 3, alignment=1)
        self._right.write(np.ascontiguousarray(pixels))

    def _clicked(self, imgui: ModuleType) -> bool:
        """Whether the item that was drawn last was clicked, and not dragged."""
        if not imgui.is_item_hovered() or not imgui.is_mouse_released(0):
            return False
        moved = imgui.get_mouse_drag_delta(0, 0.0)
        return bool(abs(moved.x) + abs(moved.y) < 3)

    def _pixel(self, imgui: ModuleType, corner: Any) -> tuple[int, int]:  # noqa: ANN401 - ImVec2
        at = imgui.get_mouse_pos()
        width, height = self.desk.size
        column, row = int(at.x - corner.x), int(at.y - corner.y)
        return min(max(column, 0), width - 1), min(max(row, 0), height - 1)

    def _steer(self, imgui: ModuleType, size: tuple[int, int]) -> None:
        """Move the camera by the mouse over the pane that was drawn last."""
        orbit = self.desk.orbit
        if orbit is None or not imgui.is_item_hovered():
            return
        io = imgui.get_io()
        sideways, down = io.mouse_delta.x, io.mouse_delta.y
        if imgui.is_mouse_dragging(0, 2.0) and not io.key_shift:
            orbit = orbit.turned(-TURN * sideways, TURN * down)
        elif imgui.is_mouse_dragging(1, 0.0) or imgui.is_mouse_dragging(0, 2.0):
            orbit = orbit.panned(sideways / size[1], -down / size[1])
        if io.mouse_wheel:
            orbit = orbit.zoomed(0.9**io.mouse_wheel)
        self.look(orbit)

    def _keys(self, imgui: ModuleType) -> None:
        """Move the camera, and step along a ray, by the keyboard."""
        orbit = self.desk.orbit
        if orbit is None or imgui.get_io().want_text_input:
            return
        key = imgui.Key
        moves = {
            key.left_arrow: lambda: orbit.turned(-KEY_TURN, 0),
            key.right_arrow: lambda: orbit.turned(KEY_TURN, 0),
            key.up_arrow: lambda: orbit.turned(0, KEY_TURN),
            key.down_arrow: lambda: orbit.turned(0, -KEY_TURN),
            key.equal: lambda: orbit.zoomed(KEY_ZOOM),
            key.minus: lambda: orbit.zoomed(1 / KEY_ZOOM),
            key.a: lambda: orbit.panned(0.05, 0),
            key.d: lambda: orbit.panned(-0.05, 0),
            key.w: lambda: orbit.panned(0, -0.05),
            key.s: lambda: orbit.panned(0, 0.05),
        }
        for pressed, move in moves.items():
            if imgui.is_key_pressed(pressed):
                self.look(move())
        actions = {
            key._0: self._reset,
            key.n: self.study.next_node,
            key.r: self.study.next_ray,
            key.comma: lambda: self.study.walk_to(self.study.step - 1),
            key.period: lambda: self.study.walk_to(self.study.step + 1),
        }
        for pressed, action in actions.items():
            if imgui.is_key_pressed(pressed):
                action()


def runner(window: Window, title: str) -> Any:  # noqa: ANN401 - ImGui's own
    """Describe the window to ImGui's runner.

    Raises:
        MissingTool: The packages of the viewer are not installed.
    """
    try:
        import moderngl  # noqa: F401 - both have to be there before a window is opened
        from imgui_bundle import hello_imgui
    except ImportError as fault:
        raise MissingTool(INSTALL) from fault
    params = hello_imgui.RunnerParams()
    params.app_window_params.window_title = title
    params.app_window_params.window_geometry.size = SIZE
    params.ini_disable = True
    params.fps_idling.enable_idling = False
    params.callbacks.post_init = window.prepare
    params.callbacks.show_gui = window.frame
    return params


def opened(window: Window, title: str) -> None:
    """Show the window until it is closed.

    Raises:
        MissingTool: The packages are not installed, or there is no display.
    """
    params = runner(window, title)
    from imgui_bundle import immapp

    if sys.platform == "linux" and not has_display():
        raise MissingTool(NO_DISPLAY)
    try:
        immapp.run(params)
    except RuntimeError as fault:
        raise MissingTool(NO_DISPLAY) from fault


def has_display() -> bool:
    """Whether the environment names a display of X11 or of Wayland."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
