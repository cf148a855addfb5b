"""The commands that speak of the program itself: what works here, what a result looks like."""

import click
from click.exceptions import Exit

from grader.cli.progress import shown
from grader.cli.status import FULL_MARKS, OUR_FAULT
from grader.report.escape import line_for_terminal


@click.command()
def schema() -> None:
    """Print the JSON Schema of result.json."""
    from grader.report.as_json import schema_text

    click.echo(schema_text(), nl=False)


@click.command()
def doctor() -> None:
    """Tell what works here and what to install.

    Exit status: 0 grading works here, 3 something that it needs is missing.
    """
    from grader.doctor import able, examine

    with shown("trying what grading needs"):
        findings = examine()
    width = max(len(finding.subject) for finding in findings)
    for finding in findings:
        sign = {True: "ok", False: "missing"}[finding.ok]
        if not finding.needed and not finding.ok:
            sign = "without"
        state = line_for_terminal(finding.state)
        click.echo(f"{sign:<8} {finding.subject:<{width}}  {state}")
        if finding.remedy:
            click.echo(f"{'':<8} {'':<{width}}  -> {finding.remedy}")
    works = able(findings)
    click.echo("\nGrading works here." if works else "\nGrading does not work here yet.")
    raise Exit(FULL_MARKS if works else OUR_FAULT)
