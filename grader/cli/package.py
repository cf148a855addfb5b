"""The command that packs what a course installs elsewhere."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from grader.cli.options import rubric_option
from grader.cli.progress import shown
from grader.errors import UsageError
from grader.output import write_bytes_whole
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.package.archive import Member

HOSTS = ("gradescope", "github", "prairielearn", "handout")


@click.command(short_help="Pack what a course installs elsewhere.")
@click.argument("host", type=click.Choice(HOSTS))
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    required=True,
    help="The zip to write.",
)
@rubric_option
@click.option("--seed", type=click.IntRange(0, 2**32 - 1), help="Instead of the usual 41.")
@click.option(
    "--wheels",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="What `pip download` wrote: the host then takes no Python package from a network.",
)
@click.option(
    "--repository",
    metavar="OWNER/NAME",
    help="GitHub only: where the course's grader will lie.",
)
def package(host: str, output: Path, repository: str | None, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Pack what a course installs elsewhere; docs/instructor.md says where it goes.

    The same grader and options give the same bytes.

    Exit status: 0 written, 2 an option does not fit, 3 it could not be written.
    """
    require_github(repository, host)
    from grader.package.archive import zipped

    with shown("packing"):
        data = zipped(packed(host, repository, given))
    write_bytes_whole(output, data, "name another file with -o")
    click.echo(f"written: {line_for_terminal(str(output))}, {len(data) / 1e6:.1f} MB")


def require_github(repository: str | None, host: str) -> None:
    """Refuse a repository that no package would name.

    Raises:
        UsageError: One was named for another host.
    """
    if repository is not None and host != "github":
        raise UsageError(f"--repository {repository}: only GitHub's package says it anywhere")


def packed(host: str, repository: str | None, given: Mapping[str, Any]) -> tuple["Member", ...]:
    """Collect what a host's package holds."""
    from grader.package import github, gradescope, handout, prairielearn
    from grader.package.kit import Choices

    choices = Choices(given["rubric"], given["seed"], given["wheels"])
    made: dict[str, Callable[[], tuple[Member, ...]]] = {
        "gradescope": lambda: gradescope.members(choices),
        "github": lambda: github.members(choices, repository),
        "prairielearn": lambda: prairielearn.members(choices),
        "handout": lambda: handout.members(choices),
    }
    return made[host]()
