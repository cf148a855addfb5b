"""The commands that speak of scenes: which there are, and their Mitsuba references."""

from typing import TYPE_CHECKING

import click
from click.exceptions import Exit

from grader.cli.progress import shown_progress
from grader.cli.status import FULL_MARKS, OUR_FAULT
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.oracle.scenes import SceneStatus


@click.group()
def scenes() -> None:
    """List scenes, or render their Mitsuba references."""


@scenes.command(name="list")
def list_command() -> None:
    """List the scenes and whether their references can be used.

    Exit status: 0 all can be used, 3 one cannot.
    """
    from grader.oracle.scenes import list_scenes

    tell(list_scenes())


@scenes.command(name="render")
@click.argument("names", nargs=-1)
def render_command(names: tuple[str, ...]) -> None:
    """Render the references of the scenes NAMES, or of all, anew.

    Needs Mitsuba: pip install 'bvhgrade[render]'.

    Exit status: 0 all were rendered, 2 no such scene, 3 one could not be rendered.
    """
    from grader.oracle.scenes import render_scenes

    with shown_progress() as progress:
        rendered = render_scenes(names, lambda step: progress(step, 0, 0))
    tell(rendered)


def tell(found: "tuple[SceneStatus, ...]") -> None:
    """Print one line a scene, and end with the status that belongs to them."""
    width = max((len(status.scene.name) for status in found), default=0)
    for status in found:
        scene = status.scene
        size = f"{scene.width} x {scene.height}"
        known = f"{status.faces:>9,} faces  {size:>11}  {status.reference_mib:>5.1f} MiB"
        click.echo(f"{scene.name:<{width}}  {known}  {line_for_terminal(scene.title)}")
        if status.problem:
            click.echo(f"{'':<{width}}  -> {line_for_terminal(status.problem)}")
    raise Exit(OUR_FAULT if any(status.problem for status in found) else FULL_MARKS)
