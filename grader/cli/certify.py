"""The command that grades the grader: does it accept what is right and see what is wrong?"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.status import FULL_MARKS, LOST_POINTS
from grader.errors import UsageError
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.certify.holes import Hole
    from grader.certify.row import Row


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
    "--sample",
    is_flag=True,
    help="Compare a part of the files with the matrix.",
)
@click.option(
    "--mutants",
    type=click.IntRange(1),
    metavar="N",
    help="Study N small edits of right submissions instead.",
)
@click.option(
    "--counterexamples",
    is_flag=True,
    help="Measure the smallest inputs that fail checks instead.",
)
@click.option(
    "--into",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="FOLDER",
    help="Keep those inputs in FOLDER/SUBMISSION/.",
)
@click.option(
    "--seed", type=int, default=1, show_default=True, help="What those N are drawn with."
)
def certify(
    match: str,
    stored: bool,
    sample: bool,
    **given: Any,  # noqa: ANN401 - click's own
) -> None:
    """Grade every right and wrong submission of a checkout.

    The rows of seed 41 become tests/submissions/kill-matrix.csv, all are summed up in
    docs/certificate.md; what was graded before is not graded again.

    Exit status: 0 nothing speaks against the grader, 1 there is a hole or a difference.
    """
    require_inputs(given["into"], given["counterexamples"])
    if given["mutants"]:
        from grader.cli.mutants import study

        hole = study(match, **given)
        write_certificate()
        raise Exit(LOST_POINTS if hole else FULL_MARKS)
    if given["counterexamples"]:
        from grader.cli.smallest import search

        undecided = search(match, **given)
        write_certificate()
        raise Exit(LOST_POINTS if undecided else FULL_MARKS)
    against = judged(match, stored, sample, given)
    raise Exit(LOST_POINTS if against else FULL_MARKS)


def require_inputs(into: Path | None, counterexamples: bool) -> None:
    """Refuse a folder for inputs that nobody looks for.

    Raises:
        UsageError: One was named.
    """
    if into and not counterexamples:
        raise UsageError("--into keeps what --counterexamples finds; give that as well")


def judged(match: str, stored: bool, sample: bool, given: Mapping[str, Any]) -> bool:
    """Grade the corpus, store and tell it; True if anything speaks against the grader."""
    from grader.certify.matrix import stored_rows
    from grader.identity import grader_digest

    grader = grader_digest()
    paths = asked_for(match, sample, grader)
    rows = stored_rows(paths) if stored else graded_rows(paths, grader, **given)
    found = holes_of(rows, not match)
    if not sample:
        if not stored:
            keep(rows, found, not match, grader)
        write_certificate()
    print_holes(rows, found)
    differs = sample and print_differences(rows)
    return bool(found) or differs


def asked_for(match: str, sample: bool, grader: str) -> list[Path]:
    """Choose files of the corpus; a sample by the state of the grader.

    Raises:
        UsageError: There is no such file.
    """
    from grader.certify.corpus import every_submission, name_of
    from grader.certify.sample import sampled

    every = sampled(grader) if sample else every_submission()
    paths = [path for path in every if match in name_of(path)]
    if not paths:
        raise UsageError(f"--match {match}: no submission of the corpus has such a name")
    return paths


def graded_rows(
    paths: Sequence[Path],
    grader: str,
    seeds: int,
    jobs: int,
    again: bool,
    **_: Any,  # noqa: ANN401 - the other options
) -> "list[Row]":
    """Grade what is missing, show each row as it comes in, and then all of them."""
    from grader.certify.ledger import Ledger, usual_ledger
    from grader.certify.matrix import SEED
    from grader.certify.run import Work, certified_rows
    from grader.certify.state import require_unchanged

    def tell(row: "Row") -> None:
        require_unchanged(grader)
        marks = [*row.failed, *(f"BROKEN {line_for_terminal(each)}" for each in row.broken)]
        scores = " ".join(f"{score:g}" for score in row.scores)
        click.echo(f"{row.seed} {row.name}  {scores}  {' '.join(marks)}")

    work = Work(paths, range(SEED, SEED + seeds), jobs, again)
    rows = certified_rows(work, Ledger(usual_ledger(), grader), tell)
    print_matrix(rows)
    return rows


def keep(rows: "Sequence[Row]", found: "Sequence[Hole]", whole: bool, grader: str) -> None:
    """Store the decided rows of the matrix's seed, and the sum of a run over everything.

    Raises:
        UsageError: The grader is not the one that graded them any more.
    """
    from grader.certify.corpus import every_submission, name_of
    from grader.certify.matrix import SEED, store
    from grader.certify.seeds import store_tried, tried
    from grader.certify.state import require_unchanged

    require_unchanged(grader)
    decided = [row for row in rows if row.seed == SEED and not row.broken]
    store(decided, [name_of(path) for path in every_submission()], grader)
    if whole:
        store_tried(tried(rows, found, grader))


def write_certificate() -> None:
    """Write docs/certificate.md from the stored matrix."""
    from grader.certify.certificate import certificate, certificate_file
    from grader.certify.corpus import every_submission, wrong_submissions
    from grader.certify.matrix import stored_rows

    rows = stored_rows(every_submission())
    certificate_file().write_text(certificate(rows, wrong_submissions()))


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


def print_differences(rows: "Sequence[Row]") -> bool:
    """Tell where the stored matrix says something else; True if it does anywhere."""
    from grader.certify.sample import differences

    found = list(differences(rows))
    click.echo(f"\n{len(found)} differ from the stored matrix")
    click.echo("".join(f"  {line_for_terminal(each)}\n" for each in found), nl=False)
    return bool(found)


def holes_of(rows: "Sequence[Row]", whole: bool) -> "list[Hole]":
    """Judge rows; those of the whole corpus also say which check has no killer."""
    from grader.certify.corpus import wrong_submissions
    from grader.certify.holes import holes, without_killer

    wrong = wrong_submissions()
    return holes(rows, wrong) + (without_killer(rows, wrong) if whole else [])


def print_holes(rows: "Sequence[Row]", found: "Sequence[Hole]") -> None:
    """Tell what speaks against the grader, and which files are luckier with another seed."""
    from grader.certify.holes import Kind, differing_seeds, ran_twice

    # That no two runs differ is worth nothing where there were no two.
    for kind in (kind for kind in Kind if kind is not Kind.UNSTEADY or ran_twice(rows)):
        mine = [hole.sentence for hole in found if hole.kind is kind]
        click.echo(f"\n{len(mine)} {kind.value}")
        click.echo("".join(f"  {line_for_terminal(each)}\n" for each in mine), nl=False)
    luck = differing_seeds(rows)
    click.echo(f"\n{len(luck)} fail other checks with another seed (no hole)")
    click.echo("".join(f"  {name}\n" for name in luck), nl=False)
