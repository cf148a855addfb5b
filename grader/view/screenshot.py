"""Both panes in a file, without a window: what `view --screenshot` does."""

import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from grader.errors import MissingTool, OutputFault
from grader.model.mesh import Bytes
from grader.view.desk import COMPARING, Desk
from grader.view.needed import lacking
from grader.view.overlay import Stroke, projected
from grader.view.picture import shown
from grader.view.preview import Preview
from grader.view.shades import tint
from grader.view.stage import State
from grader.view.study import Study

if TYPE_CHECKING:
    import moderngl

SIZE = (640, 640)
"""Of one pane."""

EGL: dict[str, Any] = {"backend": "egl"}
GAP = 8
EMPTY = 40
"""Brightness of a pane without a picture."""

PAUSE_SECONDS = 0.004


def screenshot(desk: Desk, study: Study, path: Path) -> str:
    """Draw both panes into a PNG, as soon as everything is traced.

    Returns:
        What the submission did, if the picture is not all its own, or why there is none;
        otherwise empty.

    Raises:
        UsageError: Nothing can be loaded.
        MissingTool: There is no OpenGL.
        OutputFault: The file cannot be written.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    context = surfaceless()
    desk.resize(*SIZE)
    refused = wait(desk, study)
    if refused:
        return refused
    save(panes(desk, study, Preview(context)), path)
    return study.told(desk.stage.trouble) if desk.stage else ""


def surfaceless() -> "moderngl.Context":
    """Open OpenGL without a window.

    Raises:
        MissingTool: moderngl is not installed, or this machine has no OpenGL 3.3 without a
            window.
    """
    try:
        import moderngl
    except ImportError as fault:
        raise lacking(fault) from fault
    try:
        return moderngl.create_context(require=330, standalone=True, **EGL)
    except Exception as fault:  # moderngl raises nothing more precise
        message = (
            "this machine has no OpenGL 3.3 without a window (EGL); on Debian or Ubuntu: "
            "sudo apt-get install libegl1 libgl1-mesa-dri. bvhgrade view --web needs none"
        )
        raise MissingTool(message) from fault


def wait(desk: Desk, study: Study) -> str:
    """Wait until there is nothing more to come.

    Returns:
        Why there is no program; empty if there is one.

    Raises:
        UsageError: Nothing can be loaded.
        GraderError: Our own fault.
    """
    while not _is_done(desk, study):
        if not desk.advance() | study.advance():
            time.sleep(PAUSE_SECONDS)
        product = desk.product
        if product is not None and product.engine is None:
            said = [f"{one.line}: {one.text}" for one in product.diagnostics[:1]]
            line = " ".join([study.words("It does not compile."), *said])
            return study.told(product.refused) or line
        if desk.fault is not None:
            raise desk.fault
    return ""


def _is_done(desk: Desk, study: Study) -> bool:
    if desk.stage is None or desk.is_loading or desk.is_building or desk.lacks_tree:
        return False
    stages = [desk.stage]
    if desk.mode in COMPARING and desk.rival is not None:
        stages.append(desk.rival)
    ended = desk.stage.state is State.ENDED
    still = study.is_busy and not ended
    return not still and all(one.state is State.ENDED or one.traced.is_done for one in stages)


def panes(desk: Desk, study: Study, preview: Preview) -> Bytes:
    """Draw what is on a desk: (H, 2 W + GAP, 3) uint8 sRGB.

    Raises:
        AssertionError: Nothing is.
    """
    subject, orbit, (width, height) = desk.subject, desk.orbit, desk.size
    if subject is None or orbit is None:
        raise AssertionError("something is on the desk")
    preview.tint = tint(subject.albedo)
    preview.load("whole", subject.mesh)
    preview.load_tree(desk.stage.tree if desk.stage else None)
    level = min(desk.level, desk.deepest)
    preview.draw(orbit, desk.size, level, only=desk.only, moving=False)
    strokes = [projected(one, orbit, width, height) for one in study.strokes()]
    left = over(preview.pixels(), strokes)
    seen = shown(desk)
    empty = np.full((height, width, 3), EMPTY, np.uint8)
    right = empty if seen is None else stretched(seen.pixels, width, height)
    gap = np.zeros((height, GAP, 3), np.uint8)
    return np.concatenate([left, gap, right], axis=1)


def stretched(pixels: Bytes, width: int, height: int) -> Bytes:
    """Have a picture of another size, by the nearest pixels.

    Args:
        pixels: (H, W, 3) uint8.
        width: Wanted, in pixels.
        height: Wanted, in pixels.

    Returns:
        (height, width, 3) uint8.

    A process that has ended traces no picture of the size that the pane has now.
    """
    rows = np.arange(height) * pixels.shape[0] // height
    columns = np.arange(width) * pixels.shape[1] // width
    return np.asarray(pixels[rows[:, None], columns])


def over(pixels: Bytes, strokes: Sequence[Stroke]) -> Bytes:
    """Draw lines over a picture, (H, W, 3) uint8, and return another one as large."""
    from PIL import Image, ImageDraw

    image = Image.fromarray(pixels)
    draw = ImageDraw.Draw(image)
    for stroke in strokes:
        for one, other in stroke.lines.tolist():
            draw.line((*one, *other), fill=stroke.colour, width=max(1, round(stroke.width)))
    return np.asarray(image, np.uint8)


def save(pixels: Bytes, path: Path) -> None:
    """Write a picture, (H, W, 3) uint8 sRGB, as a PNG.

    Raises:
        OutputFault: It cannot be written.
    """
    from PIL import Image

    try:
        Image.fromarray(pixels).save(path, "PNG")
    except OSError as fault:
        raise OutputFault(f"{path} cannot be written: {fault.strerror}") from fault
