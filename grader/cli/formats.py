"""What `--format` does: other people's formats, written beside `result.json`."""

import json
from collections.abc import Iterable
from pathlib import Path

import click

from grader.language import translator
from grader.model.grade import Grade
from grader.output import ready, write_whole
from grader.report.formats import FORMATS, Written

format_option = click.option(
    "--format",
    "formats",
    type=click.Choice(list(FORMATS)),
    multiple=True,
    metavar="NAME",
    help=f"{', '.join(FORMATS)}; repeatable. json and html always are.",
)

Destination = tuple[Path, Written]


def ready_for(folder: Path, formats: Iterable[str]) -> list[Destination]:
    """Prove, before anything is graded, that every file can be written where it belongs.

    Raises:
        UsageError: One cannot be.
    """
    wanted = [written for name in dict.fromkeys(formats) for written in FORMATS[name]]
    paths = [(folder / written.path, written) for written in wanted]
    for path, _ in paths:
        ready(path.parent, path.name)
    return paths


def write_formats(paths: Iterable[Destination], result: Grade, language: str) -> None:
    """Write every file of the formats that were asked for."""
    from grader.report.as_json import to_text
    from grader.report.spoken import in_language

    # What lies in result.json, no more: whoever starts from there gets the same files.
    told = in_language(json.loads(to_text(result)), language)
    for path, written in paths:
        write_whole(path, written.write(told, translator(language)))
