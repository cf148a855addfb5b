"""The window: two panes under one bar, drawn with Dear ImGui."""

import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from grader.errors import MissingTool
from grader.language import Words
from grader.view.desk import COMPARING, Desk, Mode
from grader.view.picture import Shown, shown
from grader.view.preview import Preview
from grader.view.shades import tint
from grader.view.stage import State

if TYPE_CHECKING:
    import moderngl

INSTALL = 'the viewer needs more packages: pip install "bvhgrade[view]"'
NO_DISPLAY = (
    "no window can be opened here: there is no display, or it has no OpenGL 3.3. "
    "bvhgrade view --web shows the same in a browser, --screenshot FILE.png draws it into a file"
)
SETTLED_SECONDS = 0.3
"""After the last move of the camera the whole mesh is drawn."""

TURN = 0.008
"""Radians for each pixel that the mouse is dragged."""

SIZE = (1280, 720)


class Window:
    """What is shown of a desk, and what the mouse and the keys do to it."""

    def __init__(self, desk: Desk, scenes: Sequence[str], words: Words) -> None:
        """Prepare; nothing is drawn yet.

        Args:
            desk: What is shown.
            scenes: Names of the stored scenes.
            words: Translates our own texts.
        """
        self.desk, self.words = desk, words
        self.scenes = list(scenes)
        self._context: moderngl.Context | None = None
        self._preview: Preview | None = None
        self._right: moderngl.Texture | None = None
        self._drawn: object = None
        self._subjects = 0
        self._tree: object = None
        self._moved = 0.0
        self._stale = True
        self.shown: Shown | None = None
        self.preview_seconds = 0.0
        self.first_rows: list[float] = []
        """Seconds from a move of the camera to the first new rows, of the last moves."""

        self._waiting: float | None = None

    def prepare(self) -> None:
        """Take over the window's OpenGL."""
        import moderngl

        self._context = moderngl.create_context(require=330)
        self._preview = Preview(self._context)

    def frame(self) -> None:
        """Draw one frame, and do what was asked for in it."""
        from imgui_bundle import imgui

        if self.desk.advance():
            self._stale = True
            if self._waiting is not None and self.desk.stage and self.desk.stage.traced.share:
                self.first_rows.append(time.monotonic() - self._waiting)
                self._waiting = None
        self._load()
        self._bar(imgui)
        height = imgui.get_content_region_avail().y - imgui.get_frame_height_with_spacing()
        width = (imgui.get_content_region_avail().x - imgui.get_style().item_spacing.x) / 2
        size = max(int(width), 16), max(int(height), 16)
        self.desk.resize(*size)
        self._left_pane(imgui, size)
        imgui.same_line()
        self._right_pane(imgui, size)
        imgui.text_unformatted(self.status())

    def status(self) -> str:
        """Put the numbers of the moment into one line."""
        desk, words = self.desk, self.words
        if desk.fault:
            return desk.fault
        parts = []
        if desk.subject is not None:
            parts.append(words("{faces} faces").format(faces=f"{len(desk.subject.mesh.faces):,}"))
        if desk.is_building:
            parts.append(words("compiling ..."))
        if desk.stage is not None:
            stage, traced = desk.stage, desk.stage.traced
            if stage.state is State.CONSTRUCTING:
                parts.append(words("construct ..."))
            if stage.tree is not None:
                parts.append(words("{nodes} nodes").format(nodes=f"{stage.tree.node_count:,}"))
            parts.append(f"construct {1000 * stage.construct_seconds:.0f} ms")
            parts.append(f"trace {1000 * traced.seconds:.0f} ms")
            parts.append(f"{100 * traced.share:.0f} %")
            if stage.trouble:
                parts.insert(0, stage.trouble)
        parts.append(f"preview {1000 * self.preview_seconds:.0f} ms")
        return "   ".join(parts)

    def _load(self) -> None:
        """Give the graphics card what is new."""
        desk, preview = self.desk, self._preview
        if desk.subject is not None and self._subjects != desk.subjects:
            self._subjects = desk.subjects
            preview.tint = tint(desk.subject.albedo)
            preview.load("whole", desk.subject.mesh)
            preview.load("moving", desk.light)
            self._drawn = None
        tree = desk.stage.tree if desk.stage else None
        if tree is not self._tree:
            self._tree = tree
            preview.load_tree(tree)
            self._drawn = None

    def _bar(self, imgui: "object") -> None:
        desk, words = self.desk, self.words
        imgui.set_next_item_width(170)
        current = desk.subject.name if desk.subject else "..."
        if imgui.begin_combo(words("Scene") + "##scene", current):
            for name in self.scenes:
                if imgui.selectable(name, name == current)[0]:
                    desk.choose_scene(name)
            imgui.end_combo()
        imgui.same_line()
        imgui.set_next_item_width(170)
        most = max(desk.deepest, 0)
        changed, level = imgui.slider_int(
            words("BVH level") + "##level", min(desk.level, most), -1, most
        )
        if changed:
            desk.level, self._drawn = level, None
        imgui.same_line()
        changed, desk.only = imgui.checkbox(words("only this level") + "##only", desk.only)
        if changed:
            self._drawn = None
        imgui.same_line()
        changed, on = imgui.checkbox(words("Cost heatmap") + "##cost", desk.mode is Mode.COST)
        if changed:
            desk.compare(Mode.COST if on else Mode.SHADED)
            self._stale = True

    def _left_pane(self, imgui: "object", size: tuple[int, int]) -> None:
        from imgui_bundle import ImVec2

        desk = self.desk
        moving = time.monotonic() - self._moved < SETTLED_SECONDS
        wanted = (desk.orbit, size, desk.level, desk.only, moving)
        if desk.orbit is not None and wanted != self._drawn:
            begun = time.monotonic()
            self._preview.draw(desk.orbit, size, min(desk.level, desk.deepest), desk.only, moving)
            self._context.finish()
            self.preview_seconds = time.monotonic() - begun
            self._restore()
            self._drawn = wanted
        texture = self._preview.texture
        if texture is not None:
            ref = imgui.ImTextureRef(texture.glo)
            imgui.image(ref, ImVec2(*size), ImVec2(0, 1), ImVec2(1, 0))
        else:
            imgui.dummy(ImVec2(*size))
        self._steered(imgui, size)

    def _restore(self) -> None:
        """Leave OpenGL as ImGui expects it."""
        self._context.screen.use()

    def _right_pane(self, imgui: "object", size: tuple[int, int]) -> None:
        from imgui_bundle import ImVec2

        if self._stale:
            self._stale = False
            self.shown = shown(self.desk)
            if self.shown is not None:
                self._upload(self.shown.pixels)
        if self._right is not None and self.shown is not None:
            ref = imgui.ImTextureRef(self._right.glo)
            imgui.image(ref, ImVec2(*size))
        else:
            imgui.dummy(ImVec2(*size))
        self._steered(imgui, size)

    def _upload(self, pixels: np.ndarray) -> None:
        size = pixels.shape[1], pixels.shape[0]
        if self._right is None or self._right.size != size:
            if self._right is not None:
                self._right.release()
            self._right = self._context.texture(size, 3, alignment=1)
        self._right.write(np.ascontiguousarray(pixels))

    def _steered(self, imgui: "object", size: tuple[int, int]) -> None:
        """Move the camera by the mouse over the pane that was drawn last."""
        desk = self.desk
        if desk.orbit is None or not imgui.is_item_hovered():
            return
        io, orbit = imgui.get_io(), desk.orbit
        if imgui.is_mouse_dragging(0, 2.0) and not io.key_shift:
            orbit = orbit.turned(-TURN * io.mouse_delta.x, TURN * io.mouse_delta.y)
        elif imgui.is_mouse_dragging(1, 0.0) or imgui.is_mouse_dragging(0, 0.0):
            orbit = orbit.panned(io.mouse_delta.x / size[1], -io.mouse_delta.y / size[1])
        if io.mouse_wheel:
            orbit = orbit.zoomed(0.9**io.mouse_wheel)
        self.look(orbit)

    def look(self, orbit: object) -> None:
        """Move the camera, if it is another one."""
        if orbit != self.desk.orbit:
            self._moved = time.monotonic()
            self._waiting = self._moved
            self.desk.look(orbit)


def runner(window: Window, title: str) -> "object":
    """Describe the window to ImGui's runner.

    Raises:
        MissingTool: The packages of the viewer are not installed.
    """
    try:
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

    try:
        immapp.run(params)
    except RuntimeError as fault:
        raise MissingTool(NO_DISPLAY) from fault


Run = Callable[[Window, str], None]
