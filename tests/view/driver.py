"""Opens the viewer's window, does to it what hands would do, and writes down what was seen.

Run by the tests in a process of its own: ImGui and GLFW keep what they hold until its end.
"""

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from imgui_bundle import imgui
from imgui_bundle.immapp import testing

from grader.cli.progress import silent
from grader.language import translator
from grader.options import Options
from grader.view.desk import Desk, Mode
from grader.view.opening import Wish, wanted
from grader.view.picture import BRIGHTEST
from grader.view.shades import BACKGROUND, is_hit
from grader.view.stage import State
from grader.view.study import Study
from grader.view.traced import agreement
from grader.view.window import Window, runner
from tests.view import sources

SCENE = "soup"
MOST_FRAMES = 20_000
PATIENCE_SECONDS = 500.0


class Hands:
    """What is done to a window, deed by deed."""

    def __init__(self, window: Window, file: Path) -> None:
        self.window, self.file = window, file
        self.seen: dict[str, Any] = {}
        self.left: np.ndarray | None = None

    def wait(self, ctx: Any, holds: Callable[[], bool]) -> None:  # noqa: ANN401 - ImGui's own
        """Let frames pass until something holds."""
        for _ in range(MOST_FRAMES):
            if holds():
                return
            ctx.yield_()
        raise TimeoutError("what was waited for never came")

    def is_traced(self) -> bool:
        """Whether the picture is there."""
        desk = self.window.desk
        return (
            desk.stage is not None
            and not desk.is_building
            and not desk.is_loading
            and desk.stage.traced.is_done
        )

    def work(self, ctx: Any, deeds: list[str]) -> None:  # noqa: ANN401 - ImGui's own
        """Do all deeds."""
        # Its own patience is a minute, and a busy machine needs more.
        imgui.test_engine.get_io(ctx.engine).config_watchdog_kill_test = PATIENCE_SECONDS
        if deeds[0] not in ("trouble", "broken", "bar"):
            self.wait(ctx, self.is_traced)
            self.wait(ctx, lambda: self.left is not None)
            stage = self.window.desk.stage
            assert stage is not None
            assert self.left is not None
            drawn = (self.left != BACKGROUND).any(axis=2)
            assert drawn.any()
            assert not drawn.all()
            self.seen["agreement"] = agreement(drawn, is_hit(stage.traced.t))
        ctx.set_ref("Main window (title bar invisible)")
        for deed in deeds:
            self.seen[deed] = getattr(self, deed)(ctx)

    def drag(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Drag over the left pane."""
        window = self.window
        before = window.desk.orbit
        assert before is not None
        self.to(ctx, 0.5, 0)
        ctx.mouse_down(0)
        for _ in range(4):
            at = imgui.get_io().mouse_pos
            ctx.mouse_move_to_pos((at.x + 20, at.y + 6))
        ctx.mouse_up(0)
        self.wait(ctx, lambda: bool(window.panes and window.panes.waited))
        after = window.desk.orbit
        assert after is not None
        return {"yaw": after.yaw - before.yaw, "pitch": after.pitch - before.pitch}

    def slider(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Move the slider of levels."""
        ctx.item_input_value("###level", 2)
        return {"level": self.window.desk.level}

    def heat(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Switch to the heatmap and back."""
        ctx.item_click("###cost")
        panes, stage = self.window.panes, self.window.desk.stage
        assert panes is not None
        assert stage is not None
        self.wait(ctx, lambda: bool(panes.shown and panes.shown.scale) and self.is_traced())
        ctx.yield_(2)
        hot = panes.shown
        assert hot is not None
        traced = stage.traced
        most = int(np.percentile(traced.tests[traced.seen], BRIGHTEST))
        ctx.item_click("###cost")
        self.wait(ctx, lambda: panes.shown is not None and not panes.shown.scale)
        assert panes.shown is not None
        return {
            "scale": hot.scale,
            "expected": most,
            "coloured": float((hot.pixels != panes.shown.pixels).any(axis=2).mean()),
            "back": self.window.desk.mode is Mode.SHADED,
        }

    def keys(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Turn and zoom by the keyboard, also while a list is open."""
        moved = {}
        for name in ("w", "left_arrow", "equal", "right_bracket", "keypad_add", "minus"):
            before = self.window.desk.orbit
            ctx.key_press(getattr(imgui.Key, name))
            ctx.yield_(2)
            moved[name] = self.window.desk.orbit != before
        ctx.item_click("###scene")
        before = self.window.desk.orbit
        for key in (imgui.Key.down_arrow, imgui.Key.w):
            ctx.key_press(key)
            ctx.yield_(2)
        moved["list"] = self.window.desk.orbit != before
        ctx.key_press(imgui.Key.escape)
        ctx.yield_(2)
        return moved

    def bar(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Look where the buttons end."""
        window = ctx.get_window_by_ref("//Main window (title bar invisible)")
        names = ("###scene", "###level", "###next-node", "###next-ray", "###reset", "###save")
        ends = [ctx.item_info(name).rect_full.max for name in names]
        return {
            "right": max(end.x for end in ends),
            "room": window.pos.x + window.size.x,
            "rows": len({end.y for end in ends}),
        }

    def counterexample(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Ask for the next wrong ray and node, and step."""
        study, told = self.window.study, {}
        self.wait(ctx, lambda: study.walk is not None)
        walk = study.walk
        assert walk is not None
        told["first"] = walk.of.title
        ctx.key_press(imgui.Key.r)
        self.wait(ctx, lambda: study.walk is not walk)
        assert study.walk is not None
        told["next"] = study.walk.of.title
        steps = [study.step]
        for key in (imgui.Key.period, imgui.Key.comma):
            ctx.key_press(key)
            ctx.yield_(2)
            steps.append(study.step)
        ctx.key_press(imgui.Key.n)
        self.wait(ctx, lambda: bool(study.remark))
        subject = self.window.desk.subject
        assert subject is not None
        return {**told, "steps": steps, "remark": study.remark, "origin": subject.origin}

    def drop(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Drop a file onto the window."""
        Path("two.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
        desk = self.window.desk
        self.window.drop(["two.obj"])
        self.wait(ctx, lambda: desk.subject is not None and desk.subject.name == "two")
        self.wait(ctx, self.is_traced)
        assert desk.stage is not None
        return {"hit": float(is_hit(desk.stage.traced.t).mean())}

    def click(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Click a pixel on the right, then a box on the left."""
        window, study = self.window, self.window.study
        self.wait(ctx, self.is_traced)
        self.to(ctx, 0.5, 1)
        ctx.mouse_click(0)
        self.wait(ctx, lambda: study.walk is not None)
        window.desk.level = 0
        self.to(ctx, 0.5, 0)
        ctx.mouse_click(0)
        self.wait(ctx, lambda: study.facts is not None)
        assert study.walk is not None
        assert study.facts is not None
        return {"first": study.walk.steps[0].node, "node": study.facts.node}

    def save(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Save a picture."""
        ctx.item_click("###save")
        ctx.yield_(2)
        return {"files": len(list(Path().glob("bvhgrade-*.png")))}

    def combo(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Choose another scene."""
        ctx.combo_click("###scene/nested")
        desk = self.window.desk
        self.wait(ctx, lambda: desk.subject is not None and desk.subject.name == "nested")
        self.wait(ctx, self.is_traced)
        assert desk.subject is not None
        assert desk.stage is not None
        return {"faces": len(desk.subject.mesh.faces), "share": desk.stage.traced.share}

    def trouble(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Wait until the submission ended."""
        desk = self.window.desk
        self.wait(ctx, lambda: desk.stage is not None and bool(desk.stage.trouble))
        frames = self.window.frames
        self.wait(ctx, lambda: self.window.frames > frames + 3)
        assert desk.stage is not None
        ended = desk.stage.state is State.ENDED and not desk.lacks_tree
        return {"text": desk.stage.trouble, "old": self.old(ctx) if ended else ""}

    def old(self, ctx: Any) -> str:  # noqa: ANN401 - ImGui's own
        """Turn the camera away from a picture that stays, and click that."""
        window, panes, orbit = self.window, self.window.panes, self.window.desk.orbit
        assert panes is not None
        assert orbit is not None
        window.look(orbit.turned(0.3, 0.0))
        self.wait(ctx, lambda: panes.shown is not None and panes.shown.pixels.max() <= 85)
        self.to(ctx, 0.5, 1)
        ctx.mouse_click(0)
        self.wait(ctx, lambda: bool(window.study.remark))
        return window.study.remark

    def broken(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Wait until the compiler has complained."""
        desk = self.window.desk
        self.wait(ctx, lambda: desk.product is not None and desk.product.engine is None)
        assert desk.product is not None
        return {"lines": [one.line for one in desk.product.diagnostics]}

    def rebuild(self, ctx: Any) -> dict[str, Any]:  # noqa: ANN401 - ImGui's own
        """Save another source, and wait until that is shown."""
        desk, before = self.window.desk, self.window.desk.product
        self.file.write_text(sources.reference(), encoding="utf-8")
        self.wait(ctx, lambda: desk.product is not before and self.is_traced())
        stage = desk.stage
        assert stage is not None
        assert stage.state is State.TRACING
        return {"text": stage.trouble, "share": stage.traced.share}

    def to(self, ctx: Any, share: float, pane: int) -> None:  # noqa: ANN401 - ImGui's own
        """Move the mouse over a pane: 0 is the left one."""
        width, height = self.window.desk.size
        window = ctx.get_window_by_ref("//Main window (title bar invisible)")
        x = window.pos.x + 8 + pane * (width + 8) + share * width
        ctx.mouse_move_to_pos((x, window.pos.y + 40 + share * height))

    def frame(self) -> None:
        """Draw a frame, and keep the first settled preview without boxes."""
        self.window.frame()
        panes, desk = self.window.panes, self.window.desk
        if self.left is None and panes is not None and panes.is_settled and self.is_traced():
            assert desk.orbit is not None
            preview = panes._preview
            preview.draw(desk.orbit, desk.size, -1, only=False, moving=False)
            self.left = preview.pixels()
            panes._context.screen.use()
            panes._drawn = None


def main(file: Path, told: Path, deeds: list[str]) -> None:
    """Open the window, do the deeds, write down what was seen."""
    options = Options(41, None, (), silent)
    fails, narrow = deeds[0] == "counterexample", deeds[0] == "bar"
    check = "hits.closest-wins" if fails else None
    first = wanted(Wish(file, options, None if fails else SCENE, check))
    with Desk(file, options, first) as desk:
        study = Study(desk)
        window = Window(desk, study, [SCENE, "nested"], translator("de") if narrow else str)
        hands = Hands(window, file)
        params = runner(window, "test")
        if narrow:
            params.app_window_params.window_geometry.size = (900, 700)
        params.callbacks.show_gui = hands.frame
        testing.run(
            test_function=lambda ctx: hands.work(ctx, deeds),
            runner_params=params,
        )
        study.close()
    told.write_text(json.dumps(hands.seen))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:])
