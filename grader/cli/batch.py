"""The command that grades a whole class."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.interrupts import interruptible
from grader.cli.live import shown_class
from grader.cli.options import (
    language_option,
    rubric_option,
    seed_option,
    time_option,
    unsafe_option,
)
from grader.cli.status import FULL_MARKS, INTERRUPTED, OUR_FAULT
from grader.errors import UsageError, WorkerFault
from grader.language import usual_language
from grader.output import STUDENTS, ready
from grader.plain import as_name
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from grader.batch.comparison import Change
    from grader.batch.job import Job
    from grader.batch.layouts import Arrangement
    from grader.batch.records import Student
    from grader.batch.store import Store
    from grader.batch.table import Totals
    from grader.cli.live import Lines


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
    help="Submissions at a time (default: as many as keep all busy).",
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Grade on the Dask cluster there (docs/scale.md).",
)
@click.option("--regrade", is_flag=True, help="Show who in DIR would change and why.")
@click.option("--apply", is_flag=True, help="With --regrade: make it the class's results.")
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

    if given["regrade"] and folder_or_zip is not None:
        raise UsageError(
            f"--regrade grades what {output} holds, and nothing of {folder_or_zip}; leave that "
            "out, or grade it into another folder"
        )
    if not given["regrade"] and (folder_or_zip is None or given["apply"]):
        raise UsageError("name the folder or zip of a class; --apply goes with --regrade")
    wish = Wish(
        given["seed"], given["rubric"], given["time_limit"], not given["unsafe_no_isolation"]
    )
    folder = ready(output)
    with interruptible():
        language = given["language"] or usual_language()
        job = Job(
            folder, settled(wish), wish, given["jobs"], language, scheduler=given["scheduler"]
        )
        if folder_or_zip is None:
            raise Exit(regraded(replace(job, preview=True), given["apply"]))
        raise Exit(graded(folder_or_zip, job))


def graded(path: Path, job: "Job") -> int:
    """Grade a class; the exit status."""
    from grader.batch.layouts import arranged
    from grader.batch.runner import Batch
    from grader.batch.sources import opened_class
    from grader.batch.store import opened_store

    with opened_class(path) as source, opened_store(job.folder) as store:
        class_ = arranged(source, path.resolve().name)
        tell_of(class_)
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
    return told(job, totals, batch.troubles)


def ended_early(watch: "Lines", fault: WorkerFault | KeyboardInterrupt) -> int:
    """Say why not all was graded, and what is kept; the exit status."""
    kept = "what was graded is kept, and the same command goes on"
    if isinstance(fault, WorkerFault):
        watch.say(f"bvhgrade: {fault}")
        watch.say(kept)
        return OUR_FAULT
    watch.say(f"interrupted; {kept}")
    status: int = getattr(fault, "status", INTERRUPTED)
    return status


def regraded(job: "Job", apply: bool) -> int:
    """Grade what the store holds with other settings; the exit status.

    Raises:
        UsageError: There is nothing to compare with.
    """
    from grader.batch.comparison import changes
    from grader.batch.records import names_of
    from grader.batch.runner import Batch
    from grader.batch.store import opened_store

    with opened_store(job.folder) as store:
        before = store.current()
        if before is None:
            raise UsageError(f"{job.folder} holds no results yet; grade a class first")
        say("; ".join(before.changes(job.settings)) or "the same settings as before")
        store.know(job.settings)
        with shown_class() as watch:
            batch = Batch(job, store, watch)
            try:
                batch.grade()
            except (WorkerFault, KeyboardInterrupt) as fault:
                return ended_early(watch, fault)
        names = names_of(store.students())
        tell_changes(changes(store, before, job), names)
        if missing := tell_missing(store.without_points(job.settings), names):
            kept = "so nothing was changed; the same command goes on"
            say(f"{missing:,} not graded anew, {kept}")
            return OUR_FAULT
        if not apply:
            say("nothing was changed; --apply makes it so")
            return FULL_MARKS
        store.make_current(job.settings)
        batch.job = replace(job, preview=False)
        return told(job, batch.write(), batch.troubles)


def tell_changes(
    found: "Iterable[tuple[Student, Change | None]]", names: "Mapping[str, str]"
) -> None:
    """Say of everybody whose points or checks change what changes, and why.

    Args:
        found: Students, and what changes for them.
        names: Of their folders.
    """
    from grader.batch.comparison import lines

    same = 0
    for student, change in found:
        if change is None:
            same += 1
            continue
        first, *checks = lines(change)
        say(f"{names[student.slug]}: {first}")
        for line in checks:
            click.echo(f"    {line_for_terminal(line)}")
    say(f"{same:,} stay as they are")


def tell_missing(students: "Iterable[Student]", names: "Mapping[str, str]") -> int:
    """Name everybody who could not be graded anew; how many there are."""
    missing = list(students)
    for student in missing:
        unread = (
            ""
            if student.sha256
            else ", since its file was never read; grade the download again"
        )
        say(f"{names[student.slug]}: not graded anew{unread}")
    return len(missing)


def tell_of(class_: "Arrangement") -> None:
    """Say what was found, and what is left out.

    Raises:
        UsageError: There is no submission.
    """
    for name in class_.others:
        say(f"nobody's: `{as_name(name)}`")
    if not class_.places:
        raise UsageError("there is no submission in it, but a class is expected")
    say(f"{len(class_.places):,} submissions, {class_.layout} layout")


def require_same(store: "Store", job: "Job") -> None:
    """Keep results of different rubrics, seeds and graders apart.

    Raises:
        UsageError: The folder holds results of other settings.
    """
    current = store.current()
    if current is not None and current != job.settings:
        changes = "; ".join(current.changes(job.settings))
        raise UsageError(
            f"{job.folder} holds results of other settings ({changes}); add --regrade to see "
            "what that changes, or name another folder"
        )
    store.know(job.settings)


def told(job: "Job", totals: "Totals", troubles: int) -> int:
    """Say how it ended; the exit status."""
    from grader.batch.table import CLASS

    say(f"{totals.graded:,} graded, {totals.withheld:,} withheld, {totals.waiting:,} waiting")
    say(f"{job.folder / CLASS}, and a folder for each in {job.folder / STUDENTS}")
    return OUR_FAULT if totals.withheld or totals.waiting or troubles else FULL_MARKS


def say(line: str) -> None:
    """Print one line."""
    click.echo(line_for_terminal(line))
