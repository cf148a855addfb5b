"""What is opened, and where: a window, a page or a file."""

from dataclasses import dataclass
from pathlib import Path

from grader.errors import UsageError
from grader.language import Words
from grader.options import Options
from grader.oracle.scenes import scene_named, scenes
from grader.view.desk import Desk, Load
from grader.view.subject import of_scene

USUAL_SCENE = "dragon"


@dataclass(frozen=True, slots=True)
class Wish:
    """What somebody wants to look at."""

    path: Path
    options: Options
    scene: str | None
    check: str | None
    words: Words


def opening(wish: Wish, web: bool, picture: Path | None) -> None:
    """Show what is wished for, until it is closed.

    Raises:
        UsageError: The scene, the check or the path is wrong.
        MissingTool: The packages are not installed, or there is no display.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    first = wanted(wish)
    if picture is not None:
        _drawn(wish, first, picture)
        return
    with Desk(wish.path, wish.options, first) as desk:
        from grader.view.window import Window, opened

        window = Window(desk, [scene.name for scene in scenes()], wish.words)
        opened(window, f"bvhgrade view {wish.path.name}")


def wanted(wish: Wish) -> Load:
    """Say what is shown first.

    Raises:
        UsageError: There is no such scene.
    """
    name = scene_named(wish.scene or USUAL_SCENE).name
    return lambda: of_scene(name)


def _drawn(wish: Wish, first: Load, picture: Path) -> None:
    from grader.sandbox.nursery import Nursery
    from grader.sandbox.scratch import scratch_folder
    from grader.view.screenshot import screenshot
    from grader.view.workshop import built

    with scratch_folder() as folder, Nursery() as nursery:
        product = built(wish.path, folder, nursery, wish.options)
        if product.engine is None:
            reason = product.refused or "it does not compile; bvhgrade check says why"
            raise UsageError(f"{wish.path}: {reason}")
        screenshot(first(), product.engine, picture)
