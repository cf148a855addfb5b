"""The command that compares the submissions of a class with each other."""

from pathlib import Path

import click

from grader import __version__
from grader.cli.options import language_option
from grader.cli.progress import shown
from grader.language import usual_language
from grader.report.escape import line_for_terminal


@click.command(short_help="Show which submissions of a class are alike.")
@click.argument(
    "folder", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path)
)
@click.option(
    "--least",
    type=click.IntRange(1, 100),
    default=50,
    show_default=True,
    metavar="PERCENT",
    help="Of a submission's own code that another one has as well.",
)
@language_option
def similar(folder: Path, least: int, language: str | None) -> None:
    """Show which submissions of a class are alike; DIR is where `batch` keeps it.

    Names, comments and the starter's code do not count. Writes similar.html into DIR. It
    needs copydetect: pip install "bvhgrade[similar]".

    Exit status: 0 written, 2 there is no class, 3 they could not be compared.
    """
    from grader.similar.alike import write_alike

    footer = f"bvhgrade {__version__}, copydetect"
    with shown("comparing"):
        path, whole = write_alike(folder, least / 100, footer, language or usual_language())
    for names in whole.given_up:
        told = f"not compared, because it takes too long: {', '.join(names)}"
        click.echo(line_for_terminal(told), err=True)
    told = f"{whole.files} different files, {whole.alike} pairs from {least} % on"
    click.echo(f"written: {line_for_terminal(str(path))}: {told}")
