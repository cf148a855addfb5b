"""Both panes in a file, without a window: what `view --screenshot` does."""

import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from grader.errors import MissingTool, OutputFault
from grader.model.mesh import Bytes
from grader.run.session import Engine
from grader.view.boxes import deepest_of
from grader.view.preview import Preview
from grader.view.shades import shaded, tint
from grader.view.camera import frame_of
from grader.view.stage import Stage, State
from grader.view.subject import Subject

if TYPE_CHECKING:
    import moderngl

SIZE = (640, 640)
"""Of one pane."""

GAP = 8
USUAL_LEVEL = 6


def surfaceless() -> "moderngl.Context":
    """Open OpenGL without a window.

    Raises:
        MissingTool: moderngl is not installed, or this machine has no OpenGL 3.3 without a
            window.
    """
    try:
        import moderngl
    except ImportError as fault:
        raise MissingTool(INSTALL) from fault
    try:
        return moderngl.create_context(standalone=True, backend="egl", require=330)
    except Exception as fault:  # noqa: BLE001 - moderngl raises plain exceptions for everything
        message = (
            "this machine has no OpenGL 3.3 without a window (EGL); on Debian or Ubuntu: "
            "sudo apt-get install libegl1 libgl1-mesa-dri. bvhgrade view --web needs none"
        )
        raise MissingTool(message) from fault


INSTALL = 'the viewer needs more packages: pip install "bvhgrade[view]"'


def finished(stage: Stage, subject: Subject, size: tuple[int, int]) -> Bytes:
    """Trace a whole picture, or as much as the submission lets us; (H, W, 3) uint8."""
    stage.show(subject.home, *size)
    while stage.state is not State.ENDED and not stage.traced.is_done:
        stage.advance()
        time.sleep(0.002)
    traced = stage.traced
    width, height = size
    if traced.orbit is None:
        return np.full((height, width, 3), 40, np.uint8)
    flat = shaded(traced.hits.reshape(-1, 7), frame_of(subject.home), subject.albedo)
    return flat.reshape(height, width, 3)


def screenshot(subject: Subject, engine: Engine, path: Path) -> str:
    """Draw both panes into a PNG.

    Returns:
        What the submission did wrong, if it ended; empty if not.

    Raises:
        MissingTool: There is no OpenGL.
        OutputFault: The file cannot be written.
    """
    context = surfaceless()
    stage = Stage(subject, engine)
    try:
        right = finished(stage, subject, SIZE)
        preview = Preview(context)
        preview.tint = tint(subject.albedo)
        preview.load("whole", subject.mesh)
        preview.load_tree(stage.tree)
        level = min(USUAL_LEVEL, deepest_of(stage.tree))
        preview.draw(subject.home, SIZE, level, only=False, moving=False)
        left = preview.pixels()
    finally:
        stage.close()
    gap = np.full((SIZE[1], GAP, 3), 12, np.uint8)
    save(np.concatenate([left, gap, right], axis=1), path)
    return stage.trouble


def save(pixels: Bytes, path: Path) -> None:
    """Write a PNG.

    Raises:
        OutputFault: It cannot be written.
    """
    from PIL import Image

    try:
        Image.fromarray(pixels).save(path, "PNG")
    except OSError as fault:
        raise OutputFault(f"{path} cannot be written: {fault.strerror}") from fault
