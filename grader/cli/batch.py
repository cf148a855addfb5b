"""The command that grades a whole class."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.classes import ended_early, require_same, say, told
from grader.cli.interrupts import interruptible
from grader.cli.live import shown_class
from grader.cli.options import (
    language_option,
    rubric_option,
    seed_option,
    time_option,
    unsafe_option,
)
from grader.cli.output import patient_stdout
from grader.cli.regrading import regraded
from grader.errors import UsageError, WorkerFault
from grader.language import usual_language
from grader.output import STORE, STUDENTS, ready
from grader.plain import as_name

if TYPE_CHECKING:
    from grader.batch.job import Job
    from grader.batch.layouts import Arrangement


@click.command()
@click.argument("folder_or_zip", type=click.Path(exists=True, path_type=Path), required=False)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    required=True,
    metavar="DIR",
    help="Folder for the results.",
)
@click.option(
    "--jobs",
    type=click.IntRange(1, 256),
    metavar="N",
    help="Submissions at a time (default: enough).",
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Grade on the Dask cluster there (docs/scale.md).",
)
@click.option("--regrade", is_flag=True, help="Show who in DIR would change and why.")
@click.option("--apply", is_flag=True, help="With --regrade: make it the class's results.")
@click.option(
    "--drop", metavar="NAME", help="Take a student, by the folder's name, out of DIR."
)
@seed_option
@rubric_option
@time_option
@language_option
@unsafe_option
def batch(folder_or_zip: Path | None, output: Path, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Grade a whole class; the same command again goes on.

    FOLDER_OR_ZIP holds a file or folder for each student, or is a download of
    Moodle, Canvas, Gradescope or GitHub Classroom.

    Exit status: 0 all have their grade, 2 wrong usage, 3 some are withheld.
    """
    from grader.batch.job import Job
    from grader.batch.settings import Wish, settled

    require_one(folder_or_zip, given["drop"], given["regrade"], given["apply"])
    require_home(folder_or_zip, output)
    wish = Wish(
        given["seed"], given["rubric"], given["time_limit"], not given["unsafe_no_isolation"]
    )
    folder = ready(output)
    with interruptible(), patient_stdout():
        language = given["language"] or usual_language()
        job = Job(
            folder, settled(wish), wish, given["jobs"], language, scheduler=given["scheduler"]
        )
        if given["drop"] is not None:
            raise Exit(dropped(job, given["drop"].removeprefix(f"{STUDENTS}/")))
        if folder_or_zip is None:
            raise Exit(regraded(replace(job, preview=True), given["apply"]))
        raise Exit(graded(folder_or_zip, job))


def require_one(path: Path | None, drop: str | None, regrade: bool, apply: bool) -> None:
    """Keep apart what can be asked of a class.

    Raises:
        UsageError: Nothing was asked for, or two things at once.
    """
    if drop is not None and (path or regrade or apply):
        raise UsageError("--drop only takes a student out of DIR; grade before it or after it")
    if regrade and path is not None:
        raise UsageError(
            f"--regrade grades what DIR holds, and nothing of {path}; leave that out, or grade "
            "it into another folder"
        )
    if apply and not regrade:
        raise UsageError("--apply keeps what --regrade graded; give --regrade as well")
    if not regrade and drop is None and path is None:
        raise UsageError("name the folder or zip of a class, or give --regrade or --drop NAME")


def require_home(path: Path | None, output: Path) -> None:
    """Find out whether results can lie where they are wanted, or are there.

    Raises:
        UsageError: They cannot, or they are not.
    """
    if path is not None and output.resolve() == path.resolve():
        raise UsageError(
            f"{output} holds the submissions, and results may not lie among them; name another "
            "folder with -o"
        )
    if path is None and not (output / STORE).is_file():
        raise UsageError(
            f"{output}: there is no {STORE}, but a class that was graded is expected; name the "
            "folder that `bvhgrade batch` wrote to"
        )


def graded(path: Path, job: "Job") -> int:
    """Grade a class; the exit status."""
    from grader.batch.layouts import arranged
    from grader.batch.runner import Batch
    from grader.batch.sources import opened_class
    from grader.batch.store import opened_store

    with opened_class(path) as source, opened_store(job.folder) as store:
        class_ = arranged(source, path.resolve().name)
        tell_of(path, class_)
        require_same(store, job)
        with shown_class() as watch:
            batch = Batch(job, store, watch)
            try:
                batch.read(class_)
                batch.grade()
                totals = batch.write()
            except (WorkerFault, KeyboardInterrupt) as fault:
                batch.tabulate()
                return ended_early(watch, fault)
    status = told(job, totals, batch.troubles)
    tell_odd(class_)
    return status


def dropped(job: "Job", name: str) -> int:
    """Take a student out of a class, with whatever it was graded; the exit status.

    Raises:
        UsageError: Nobody has such a folder.
        OutputFault: Something cannot be removed or written.
    """
    from grader.batch.files import Standing, remove_folder
    from grader.batch.store import opened_store
    from grader.batch.table import write_table

    with opened_store(job.folder) as store:
        student = next((one for one in store.students() if one.slug == name), None)
        if student is None:
            raise UsageError(
                f"{job.folder}: no student's folder is called {as_name(name)}; class.csv there "
                "lists all of them"
            )
        # The folder first: whatever ends this in between, the store still knows whose it was.
        remove_folder(job, student)
        store.drop(student)
        say(f"{student.name}: taken out of the class")
        job = replace(job, settings=store.current() or job.settings)
        return told(job, write_table(job, store, Standing(store, job)), troubles=0)


def tell_of(path: Path, class_: "Arrangement") -> None:
    """Say what was found, and what is left out.

    Raises:
        UsageError: There is no submission.
    """
    for name in class_.others:
        say(f"nobody's: `{as_name(name)}`")
    if not class_.places:
        raise UsageError(
            f"{path}: there is no submission in it; name what holds a file or folder for each "
            "student"
        )
    say(f"{len(class_.places):,} submissions, {class_.layout} layout")


def tell_odd(class_: "Arrangement") -> None:
    """Say at the end, too, that something was left out: long before stands what it is."""
    if count := len(class_.others):
        click.echo(f"nobody's: {count:,} named above; look whether they are", err=True)
