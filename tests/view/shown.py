"""Small things to look at, and how tests wait for them."""

import time
from collections.abc import Callable

from grader.model.mesh import Mesh
from grader.view.stage import Stage, State
from grader.view.subject import Subject, around
from tests.verify.builder import soup

PATIENCE = 240.0
"""Seconds; only a machine that is much too busy needs more than a few."""


def confetti(faces: int = 40) -> Subject:
    """Show a few faces here and there."""
    return of_mesh(soup(faces))


def of_mesh(mesh: Mesh) -> Subject:
    """Show a mesh."""
    return Subject("few", "a few faces", mesh, around(mesh))


def until(holds: Callable[[], bool], look: Callable[[], object]) -> None:
    """Look again and again until something holds.

    Raises:
        TimeoutError: It never does.
    """
    end = time.monotonic() + PATIENCE
    while not holds():
        if time.monotonic() > end:
            raise TimeoutError("what was waited for never came")
        look()
        time.sleep(0.003)


def finished(stage: Stage) -> Stage:
    """Wait until a picture is traced, or the process ended."""
    until(lambda: stage.state is State.ENDED or stage.traced.is_done, stage.advance)
    return stage
