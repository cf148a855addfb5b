"""The window: two panes under one bar and a column beside them, drawn with Dear ImGui."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from grader.errors import MissingTool
from grader.language import Words
from grader.view.bar import Bar
from grader.view.camera import Orbit
from grader.view.desk import Desk
from grader.view.needed import NO_DISPLAY, has_display, lacking
from grader.view.panel import WIDTH, Panel, saved, scaled
from grader.view.panes import Panes
from grader.view.preview import Preview
from grader.view.screenshot import panes
from grader.view.status import is_vain, status
from grader.view.steering import act, is_choosing, pressed
from grader.view.study import Study
from grader.view.subject import of_file

SIZE = (1440, 760)
IDLE_FRAMES = 10.0
"""A second, as long as nothing is traced and nobody moves anything."""

LEAST = 16
"""Pixels of a pane's side, however small the window is."""


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
        self.panel = Panel(desk, study, words)
        self.panes: Panes | None = None
        """None until there is a window."""

        self.frames = 0
        actions = (
            (words("Reset view") + "###reset", self._reset),
            (words("Save picture") + "###save", self.save),
        )
        self._bar = Bar(desk, study, scenes, words, actions)
        self._context: Any = None

    def prepare(self) -> None:
        """Take over the window's OpenGL, and what is dropped onto it."""
        import moderngl

        self._context = moderngl.create_context(require=330)
        self.panes = Panes(self.desk, self.study, self._context)
        _hear_drops(self.drop)

    def frame(self) -> None:
        """Draw one frame, and do what was asked for in it."""
        from imgui_bundle import hello_imgui, imgui

        panes = self.panes
        if panes is None:
            return
        self.frames += 1
        self._advance(panes)
        panes.load()
        self._bar.draw(imgui)
        size = _pane_size(imgui)
        self.desk.resize(*size)
        panes.left(imgui, size)
        imgui.same_line()
        panes.right(imgui, size)
        imgui.same_line()
        if imgui.begin_child("##panel", (0, size[1])):
            self.panel.draw(imgui, panes.shown)
        imgui.end_child()
        if not imgui.get_io().want_text_input and not is_choosing(imgui):
            self._keys(imgui, panes)
        imgui.text_unformatted(self.status(imgui.get_io().framerate))
        runner = hello_imgui.get_runner_params()
        runner.fps_idling.enable_idling = not self._is_busy(panes)
        if is_vain(self.desk):
            runner.app_shall_exit = True

    def status(self, fps: float) -> str:
        """Put the numbers of the moment into one line.

        Args:
            fps: Frames a second; few as long as nothing happens.
        """
        told = status(self.desk, self.words, self.study.told)
        seconds = self.panes.preview_seconds if self.panes else 0.0
        return f"{told}   preview {1000 * seconds:.0f} ms   {fps:.0f} fps"

    def look(self, orbit: Orbit) -> None:
        """Move the camera."""
        if self.panes is not None:
            self.panes.look(orbit)

    def drop(self, names: Sequence[str]) -> None:
        """Show a mesh or a counterexample from a file, the last of several."""
        self.panel.remark = ""
        if names:
            path = Path(names[-1])
            # It is read aside, because it may be large.
            self.desk.choose(lambda: of_file(path))

    def save(self) -> None:
        """Save what is shown as a picture, where the program was started."""
        desk = self.desk
        if desk.orbit is None or desk.subject is None or self._context is None:
            return
        preview = Preview(self._context)
        pixels = panes(desk, self.study, preview)
        preview.release()
        self._context.screen.use()
        self.panel.remark = saved(pixels, desk.subject.name, self.words)

    def _advance(self, panes: Panes) -> None:
        panes.advance()
        self.study.advance()

    def _is_busy(self, panes: Panes) -> bool:
        """Whether the next frame will show something else, though nobody touches anything."""
        desk, stage = self.desk, self.desk.stage
        tracing = stage is not None and stage.is_tracing
        # While something is loaded or compiled, ten frames a second leave it the processor.
        waits = self.study.is_busy and not (desk.is_loading or desk.is_building)
        return bool(tracing or waits or not panes.is_settled)

    def _keys(self, imgui: ModuleType, panes: Panes) -> None:
        act(imgui, self.study, self._reset)
        if self.desk.orbit is not None:
            panes.look(pressed(imgui, self.desk.orbit))

    def _reset(self) -> None:
        if self.desk.subject is not None:
            self.look(self.desk.subject.home)


def _pane_size(imgui: ModuleType) -> tuple[int, int]:
    """Divide what is left of the window: two panes, and the column beside them."""
    wide = scaled(imgui, WIDTH)
    room, gap = imgui.get_content_region_avail(), imgui.get_style().item_spacing.x
    height = room.y - imgui.get_frame_height_with_spacing()
    return max(int((room.x - wide - 2 * gap) / 2), LEAST), max(int(height), LEAST)


def _hear_drops(take: Callable[[list[str]], None]) -> None:
    """Have the names of files that are dropped onto the window given to somebody."""
    import glfw
    from imgui_bundle.glfw_utils import glfw_window_hello_imgui

    def dropped(_: Any, names: Any) -> None:  # noqa: ANN401 - GLFW's own
        take([str(name) for name in names])

    # Its own types say that a name comes alone.
    glfw.set_drop_callback(glfw_window_hello_imgui(), dropped)  # type: ignore[arg-type]  # a list


def runner(window: Window, title: str) -> Any:  # noqa: ANN401 - ImGui's own
    """Describe the window to ImGui's runner.

    Raises:
        MissingTool: The packages of the viewer are not installed, or cannot be loaded.
    """
    try:
        from imgui_bundle import hello_imgui

        params = hello_imgui.RunnerParams()
        # Not before: ImGui says which library this loads. Under Wayland it would take another
        # one, with which ImGui does not load.
        import glfw  # noqa: F401 - all have to be there before a window is opened
        import moderngl  # noqa: F401 - all have to be there before a window is opened
    except ImportError as fault:
        raise lacking(fault) from fault
    params.app_window_params.window_title = title
    params.app_window_params.window_geometry.size = SIZE
    params.ini_disable = True
    params.fps_idling.fps_idle = IDLE_FRAMES
    params.fps_idling.time_active_after_last_event = 0.5
    params.callbacks.post_init = window.prepare
    params.callbacks.show_gui = window.frame
    return params


def opened(window: Window, title: str) -> None:
    """Show the window until it is closed.

    Raises:
        MissingTool: The packages are not installed, or there is no display.
        RuntimeError: Our own fault, after the window was there.
    """
    params = runner(window, title)
    from imgui_bundle import immapp

    if sys.platform == "linux" and not has_display():
        raise MissingTool(NO_DISPLAY)
    try:
        immapp.run(params)
    except RuntimeError as fault:
        # Where a frame was begun, there is a display.
        if window.frames:
            raise
        raise MissingTool(NO_DISPLAY) from fault
