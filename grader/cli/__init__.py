"""What can be typed after `bvhgrade`; each command imports what it needs only when it runs."""

import os
import sys
from io import TextIOWrapper

import click

from grader import __version__
from grader.cli.batch import batch
from grader.cli.bench import bench
from grader.cli.certify import certify
from grader.cli.export import export
from grader.cli.grading import check, grade
from grader.cli.installation import doctor, schema
from grader.cli.output import require_outlet
from grader.cli.package import package
from grader.cli.reporting import report
from grader.cli.scenes import scenes
from grader.cli.similar import similar
from grader.cli.status import INTERRUPTED, GraderGroup
from grader.cli.verify import verify
from grader.cli.view import view


@click.group(cls=GraderGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="bvhgrade")
def cli() -> None:
    """Grade a BVH exercise in C++: one file, two functions, 50 points."""


COMMANDS = (
    *(check, grade, view, batch, verify, report, export, similar),
    *(package, scenes, doctor, schema, certify, bench),
)
for command in COMMANDS:
    cli.add_command(command)


def main() -> None:
    """Run the command line and leave with the exit status that the contract names."""
    if isinstance(sys.stderr, TextIOWrapper):
        sys.stderr.reconfigure(errors="backslashreplace")
    require_outlet()
    try:
        cli(prog_name="bvhgrade")
    except KeyboardInterrupt:
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115, PTH123 - nothing more is said
        sys.exit(INTERRUPTED)
