"""How long does the dragon take, and how smoothly does it turn? `python -m tests.view.measure`.

Needs a display: `xvfb-run -a -s "-screen 0 1600x1000x24" python -m tests.view.measure`. Wall
times, so they mean something on an idle machine only; no test asserts them.
"""

import sys
import time

BEGUN = time.monotonic()

import resource  # noqa: E402 - the clock starts first
from collections.abc import Callable  # noqa: E402 - the clock starts first
from pathlib import Path  # noqa: E402 - the clock starts first
from typing import Any  # noqa: E402 - the clock starts first

import numpy as np  # noqa: E402 - the clock starts first

from grader.cli.progress import silent  # noqa: E402 - the clock starts first
from grader.options import Options  # noqa: E402 - the clock starts first
from grader.resources import reference_source  # noqa: E402 - the clock starts first
from grader.view.desk import Desk  # noqa: E402 - the clock starts first
from grader.view.study import Study  # noqa: E402 - the clock starts first
from grader.view.subject import of_scene  # noqa: E402 - the clock starts first
from grader.view.window import Window, runner  # noqa: E402 - the clock starts first

TURNS = 60


class Watch:
    """Notes when things are first seen, then turns the camera."""

    def __init__(self, window: Window) -> None:
        self._window = window
        self.first: dict[str, float] = {}
        self.frames: list[float] = []
        self.used: list[float] = []
        self._turned = 0
        self._turns = False
        self._left: Callable[..., None] | None = None

    def frame(self) -> None:
        """Draw one frame, and look what is there."""
        from imgui_bundle import hello_imgui

        window, desk = self._window, self._window.desk
        if window.panes is not None and self._left is None:
            self._left = window.panes.left
            setattr(window.panes, "left", self._dragged)  # noqa: B010 - in place of the mouse
        window.frame()
        stage = desk.stage
        self._note("first frame", True)
        self._note("mesh", desk.subject is not None and window.panes is not None)
        self._note("compiled", desk.product is not None)
        self._note("tree", stage is not None and stage.tree is not None)
        self._note("first rows", stage is not None and stage.traced.share > 0)
        done = stage is not None and stage.traced.is_done
        self._note("picture", done)
        if "picture" in self.first and self._turned < TURNS and desk.orbit is not None:
            self.frames.append(time.monotonic())
            self.used.append(time.process_time())
            self._turned += 1
            self._turns = True
        elif self._turned == TURNS:
            hello_imgui.get_runner_params().app_shall_exit = True

    def _dragged(self, imgui: Any, size: tuple[int, int]) -> None:  # noqa: ANN401 - ImGui's own
        """Draw the left pane, then move the camera as the mouse does over it."""
        assert self._left is not None
        self._left(imgui, size)
        if self._turns and self._window.desk.orbit is not None:
            self._turns = False
            self._window.look(self._window.desk.orbit.turned(0.02, 0.0))

    def _note(self, what: str, is_there: bool) -> None:
        if is_there:
            self.first.setdefault(what, time.monotonic() - BEGUN)


def main(scene: str) -> None:
    """Open, turn, tell."""
    from imgui_bundle import immapp

    with Desk(
        reference_source(), Options(41, None, (), silent), lambda: of_scene(scene)
    ) as desk:
        study = Study(desk)
        window = Window(desk, study, [scene], str)
        watch = Watch(window)
        params = runner(window, "measured")
        params.callbacks.show_gui = watch.frame
        immapp.run(params)
        study.close()
    lines = [f"{what:<12} {seconds:7.2f} s" for what, seconds in watch.first.items()]
    assert window.panes is not None
    gaps, waited = np.diff(watch.frames), 1000 * np.array(window.panes.waited)
    lines.append(f"while it turns {1 / np.median(gaps):.1f} frames a second (median)")
    cost = 1000 * np.median(np.diff(watch.used))
    lines.append(f"{cost:.0f} ms of CPU time a frame while it turns (median)")
    lines.append(
        f"first new rows after {np.median(waited):.0f} ms (median), {waited.max():.0f} ms "
        f"(most), {len(waited)} moves"
    )
    used = resource.getrusage(resource.RUSAGE_SELF)
    lines.append(f"CPU {used.ru_utime + used.ru_stime:.2f} s")
    lines.append(f"load {Path('/proc/loadavg').read_text().strip()}")
    sys.stdout.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "dragon")
