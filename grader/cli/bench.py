"""The command that measures how fast the grader is, beside what it is compared to."""

from pathlib import Path

import click

from grader.report.escape import line_for_terminal


@click.command(short_help="Print the table of performance goals, as ratios.")
@click.option("--quick", is_flag=True, help="A smaller mesh, fewer rounds: a minute or two.")
@click.option(
    "--write",
    "folder",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="Also write performance.md and its chart into this folder.",
)
def bench(quick: bool, folder: Path | None) -> None:
    """Print the table of performance goals, as ratios measured inside this run.

    It grades a thousand files and more, so it takes a while; a machine that is busy with
    something else spoils it.

    Exit status: 0 it was measured, 3 something of ours failed.
    """
    from grader.bench.shown import lines_of
    from grader.bench.table import FULL, QUICK, made

    table = made(QUICK if quick else FULL, lambda step: click.echo(f"... {step}", err=True))
    for line in lines_of(table):
        click.echo(line)
    if folder is not None:
        from grader.bench.document import write

        for path in write(folder, table):
            click.echo(f"written: {line_for_terminal(str(path))}")
