"""The commands that speak of scenes: which there are, their references, and own models."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.exceptions import Exit

from grader.cli.progress import shown, shown_progress
from grader.cli.status import FULL_MARKS, OUR_FAULT
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.oracle.album import SceneStatus

OWN = "own-scenes"

folder_option = click.option(
    "--scenes",
    "folder",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="A course's own folder of scenes instead of the shipped one.",
)


@click.group()
def scenes() -> None:
    """List scenes, render their Mitsuba references, import models."""


@scenes.command(name="list")
@folder_option
def list_command(folder: Path | None) -> None:
    """List the scenes and whether their references can be used.

    Exit status: 0 all can be used, 2 scenes.toml is wrong, 3 a reference cannot be used.
    """
    from grader.oracle.album import list_scenes

    with shown("reading scenes"):
        listed = list_scenes(folder)
    tell(listed)


@scenes.command(name="render")
@click.argument("names", nargs=-1)
@folder_option
def render_command(names: tuple[str, ...], folder: Path | None) -> None:
    """Render the references of the scenes NAMES, or of all, anew.

    Needs Mitsuba: pip install 'bvhgrade[render]'.

    Exit status: 0 all were rendered, 2 no such scene, 3 one could not be rendered.
    """
    from grader.oracle.album import render_scenes

    with shown_progress() as progress:
        rendered = render_scenes(names, lambda step: progress(step, 0, 0), folder)
    tell(rendered)


@scenes.command(name="import")
@click.argument("model", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--name", help="Of the scene (default: the file's).")
@click.option(
    "--into",
    type=click.Path(file_okay=False, path_type=Path),
    default=OWN,
    show_default=True,
    metavar="DIR",
    help="The course's own folder of scenes; created if needed.",
)
@click.option(
    "--up",
    type=click.Choice(["y", "z"]),
    help="The axis that points up (default: z in an STL, else y).",
)
def import_command(model: Path, name: str | None, into: Path, up: str | None) -> None:
    """Make a scene of the OBJ, PLY, STL or glTF file MODEL.

    It is scaled into a cube from -1 to 1 and gets a camera and a light that fit; both can be
    changed in DIR/scenes.toml. A rubric with `[scenes] folder = "DIR"` grades with it.

    Needs Mitsuba: pip install 'bvhgrade[render]'.

    Exit status: 0 there is a new scene, 2 the model will not do, 3 it could not be rendered.
    """
    from grader.oracle.imported import Wish, import_scene

    wish = Wish(model, into, name, up)
    with shown_progress() as progress:
        status, remark = import_scene(wish, lambda step: progress(step, 0, 0))
    if remark:
        click.echo(remark)
    tell([status])


def tell(found: "Sequence[SceneStatus]") -> None:
    """Print one line a scene, and end with the status that belongs to them."""
    width = max((len(status.scene.name) for status in found), default=0)
    for status in found:
        click.echo(_line(status, width))
        if status.problem:
            click.echo(f"{'':<{width}}  -> {line_for_terminal(status.problem)}")
    raise Exit(OUR_FAULT if any(status.problem for status in found) else FULL_MARKS)


def _line(status: "SceneStatus", width: int) -> str:
    """Word what is known of a scene."""
    scene = status.scene
    size = f"{scene.width} x {scene.height}"
    worth = f"x {scene.weight:<4g} {scene.visibility:<14}"
    by = dict(status.made_with).get("mitsuba", "")
    state = f"{status.reference_mib:.1f} MiB by Mitsuba {by}" if by else "cannot be used"
    known = f"{status.faces:>9,} faces  {size:>11}  {worth}  {line_for_terminal(state):<25}"
    return f"{scene.name:<{width}}  {known}  {line_for_terminal(scene.title)}"
