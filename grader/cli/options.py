"""The options that several commands have."""

from pathlib import Path

import click

from grader.language import LANGUAGES

SEED = 41

submission_type = click.Path(exists=True, path_type=Path)
seed_option = click.option(
    "--seed",
    type=click.IntRange(0, 2**32 - 1),
    default=SEED,
    show_default=True,
    help="Of meshes and rays.",
)
rubric_option = click.option(
    "--rubric",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Points and limits instead of the built-in ones.",
)
time_option = click.option(
    "--time-limit",
    type=click.FloatRange(30, 86_400),
    metavar="SECONDS",
    help="The grade is there by then (default: the rubric's total_seconds).",
)
hints_option = click.option(
    "--hints",
    type=click.IntRange(0, 3),
    default=1,
    show_default=True,
    help="0 facts, 1 and a likely cause, 2 and a question, 3 and what to try.",
)
language_option = click.option(
    "--language",
    type=click.Choice(LANGUAGES),
    help="Of what people read (default: as LC_ALL or LANG say).",
)
unsafe_option = click.option(
    "--unsafe-no-isolation",
    is_flag=True,
    help="Run the code with your own rights: you trust it.",
)
