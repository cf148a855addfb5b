"""The commands that speak of scenes: which there are, and their Mitsuba references."""

import click

from grader.cli.progress import shown_progress


@click.group()
def scenes() -> None:
    """List scenes, or render their Mitsuba references."""


@scenes.command(name="list")
def list_all() -> None:
    """List the scenes and whether their references are at hand."""
    from grader.oracle.scenes import list_scenes

    for scene in list_scenes():
        click.echo(scene)


@scenes.command()
@click.argument("names", nargs=-1)
def render(names: tuple[str, ...]) -> None:
    """Render the Mitsuba references of NAMES, or of all scenes."""
    from grader.oracle.scenes import render_scenes

    with shown_progress() as progress:
        render_scenes(names, progress)
