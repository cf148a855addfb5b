"""What `batch --regrade` does: who would change, and why, before anything does."""

from dataclasses import replace
from typing import TYPE_CHECKING

import click

from grader.cli.classes import ended_early, say, told
from grader.cli.live import shown_class
from grader.cli.status import FULL_MARKS, OUR_FAULT
from grader.errors import UsageError, WorkerFault
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from collections.abc import Container, Iterable, Mapping

    from grader.batch.comparison import Change
    from grader.batch.job import Job
    from grader.batch.records import Student
    from grader.batch.settings import Settings
    from grader.batch.store import Store


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
        if before == job.settings:
            return finished(job, store, apply)
        say("; ".join(before.changes(job.settings)))
        store.know(job.settings)
        with shown_class() as watch:
            try:
                Batch(job, store, watch).grade()
            except (WorkerFault, KeyboardInterrupt) as fault:
                return ended_early(watch, fault)
        names = names_of(store.students())
        tell_changes(changes(store, before, job), names)
        return decided(job, store, before, apply, names)


def decided(
    job: "Job", store: "Store", before: "Settings", apply: bool, names: "Mapping[str, str]"
) -> int:
    """Apply what was graded, unless somebody would lose points; the exit status."""
    missing = list(store.without_points(job.settings))
    had_none = {one.slug for one in store.without_points(before)}
    tell_missing(missing, had_none, names)
    if losing := sum(one.slug not in had_none for one in missing):
        say(f"{losing:,} not graded anew, so nothing was changed; the same command goes on")
        return OUR_FAULT
    if not apply:
        say("nothing was changed; --apply makes it so")
        return OUR_FAULT if missing else FULL_MARKS
    withhold(missing, store, job)
    store.make_current(job.settings)
    return finished(job, store, apply)


def withhold(students: "Iterable[Student]", store: "Store", job: "Job") -> None:
    """Let those who had no points and have none now be withheld, and not be nowhere."""
    for one in students:
        if one.sha256 and not one.fault and store.result(one.sha256, job.settings) is None:
            store.put(replace(one, fault="it could not be graded anew", written=""), b"")


def finished(job: "Job", store: "Store", apply: bool) -> int:
    """Write what an earlier call with `--apply` did not come to; the exit status.

    Raises:
        UsageError: Nothing was asked for: these are the settings of the class.
    """
    from grader.batch.runner import Batch

    if not apply:
        raise UsageError(
            f"{job.folder} holds results of these very settings; name what is new, or grade "
            "the download again if something is withheld"
        )
    with shown_class() as watch:
        batch = Batch(replace(job, preview=False), store, watch)
        try:
            return told(job, batch.write(), batch.troubles)
        except KeyboardInterrupt as fault:
            watch.say("the new results are those of the class; not all folders hold them yet")
            return ended_early(watch, fault)


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


def tell_missing(
    students: "Iterable[Student]", had_none: "Container[str]", names: "Mapping[str, str]"
) -> None:
    """Name everybody who could not be graded anew.

    Args:
        students: They.
        had_none: Folders of those who lose nothing by that.
        names: Of their folders.
    """
    for student in students:
        why = "" if student.sha256 else ", since its file was never read"
        what = "; no points before either: grade the download again"
        end = what if student.slug in had_none else ""
        say(f"{names[student.slug]}: not graded anew{why}{end}")
