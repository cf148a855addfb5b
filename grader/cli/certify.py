"""The command that grades the grader: does it accept what is right and see what is wrong?"""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.status import FULL_MARKS, LOST_POINTS
from grader.errors import UsageError
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.certify.corpus import Wrong
    from grader.certify.holes import Hole
    from grader.certify.row import Row
    from grader.certify.run import Work


@click.command()
@click.option(
    "--seeds",
    type=click.IntRange(1, 1000),
    default=3,
    show_default=True,
    metavar="N",
    help="Grade with N seeds: 41, 42, and so on.",
)
@click.option(
    "--match", default="", metavar="TEXT", help="Only files whose name contains TEXT."
)
@click.option("--jobs", type=click.IntRange(1, 256), default=2, show_default=True, metavar="N")
@click.option("--again", is_flag=True, help="Grade what is stored too, and compare.")
@click.option("--stored", is_flag=True, help="Grade nothing; judge the stored kill matrix.")
@click.option(
    "--mutants",
    type=click.IntRange(1),
    metavar="N",
    help="Study N small edits of right submissions instead of the corpus.",
)
@click.option(
    "--seed", type=int, default=1, show_default=True, help="What those N are drawn with."
)
def certify(match: str, stored: bool, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Grade every right and wrong submission of a checkout.

    What this state of the grader has graded before is not graded again: a run that was killed
    goes on. The rows of seed 41 become tests/submissions/kill-matrix.csv, and what they
    say is written to docs/certificate.md.

    Exit status: 0 nothing speaks against the grader, 1 there is a hole.
    """
    from grader.certify.corpus import name_of, right_submissions, wrong_submissions
    from grader.certify.matrix import SEED, row_of, stored_lines

    wrong = wrong_submissions()
    every = [*right_submissions(), *(one.path for one in wrong)]
    if given["mutants"]:
        from grader.cli.mutants import study

        hole = study(match, **given)
        write_certificate(wrong)
        raise Exit(LOST_POINTS if hole else FULL_MARKS)
    paths = [path for path in every if match in name_of(path)]
    if not paths:
        raise UsageError(f"--match {match}: no submission of the corpus has such a name")
    if stored:
        names = {name_of(path) for path in paths}
        rows = [row_of(line) for name, line in stored_lines().items() if name in names]
    else:
        from grader.certify.run import Work

        seeds = range(SEED, SEED + given["seeds"])
        rows = graded_rows(Work(paths, seeds, given["jobs"], given["again"]))
        print_matrix(rows)
        keep([row for row in rows if row.seed == SEED and not row.broken], every)
    write_certificate(wrong)
    raise Exit(LOST_POINTS if print_holes(rows, wrong, not match) else FULL_MARKS)


def graded_rows(work: "Work") -> "list[Row]":
    """Grade what is missing and show each row as it comes in."""
    from grader.certify.ledger import Ledger, grader_digest, usual_ledger
    from grader.certify.run import certified_rows

    def tell(row: "Row") -> None:
        marks = [*row.failed, *(f"BROKEN {line_for_terminal(each)}" for each in row.broken)]
        scores = " ".join(f"{score:g}" for score in row.scores)
        click.echo(f"{row.seed} {row.name}  {scores}  {' '.join(marks)}")

    return certified_rows(work, Ledger(usual_ledger(), grader_digest()), tell)


def keep(rows: "Sequence[Row]", every: Sequence[Path]) -> None:
    """Put the rows of the matrix's seed into the stored matrix."""
    from grader.certify.corpus import name_of
    from grader.certify.matrix import store

    store(rows, [name_of(path) for path in every])


def write_certificate(wrong: "Sequence[Wrong]") -> None:
    """Write docs/certificate.md from the stored matrix."""
    from grader.certify.certificate import certificate, certificate_file
    from grader.certify.matrix import row_of, stored_lines

    rows = [row_of(line) for line in stored_lines().values()]
    certificate_file().write_text(certificate(rows, wrong))


def print_matrix(rows: "Sequence[Row]") -> None:
    """Tell of each submission which checks fail, and with how many of the seeds."""
    names = sorted({row.name for row in rows})
    width = max(map(len, names))
    click.echo("\nKill matrix")
    for name in names:
        mine = [row for row in rows if row.name == name and not row.broken]
        failed = [check for row in mine for check in row.failed]
        told = [
            check if failed.count(check) == len(mine) else f"{check} ({failed.count(check)})"
            for check in dict.fromkeys(failed)
        ]
        click.echo(f"{name:<{width}}  {' '.join(told)}")


def print_holes(rows: "Sequence[Row]", wrong: "Sequence[Wrong]", whole: bool) -> bool:
    """Tell what speaks against the grader; True if something does."""
    from grader.certify.holes import Kind, differing_seeds, holes, without_killer

    found: list[Hole] = holes(rows, wrong)
    if whole:
        found += without_killer(rows, wrong)
    for kind in Kind:
        mine = [hole.sentence for hole in found if hole.kind is kind]
        click.echo(f"\n{len(mine)} {kind.value}")
        click.echo("".join(f"  {line_for_terminal(each)}\n" for each in mine), nl=False)
    luck = differing_seeds(rows)
    click.echo(f"\n{len(luck)} fail other checks with another seed (no hole)")
    click.echo("".join(f"  {name}\n" for name in luck), nl=False)
    return bool(found)
