"""Stands in for the pipeline: what a clerk does with a submission is what its text says.

`die` ends the clerk, `die aloud` with a traceback; `raise` is a fault of ours, `stumble` one
that nobody foresaw, `broken` one of a check; `wait` never ends; `die once`, `wait once` and
`withheld once` (a grade without a score) do so only the first time; `wrong` loses points,
`moody` with another seed; anything else is a perfect grade. As a program it grades a class so,
in a whole process.
"""

import os
import signal
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from grader.batch.job import Job
from grader.batch.settings import Settings, Wish
from grader.batch.work import Failed, Order, Refused, differences
from grader.errors import failed_here
from grader.kept import Result, kept
from grader.model.stages import Submission
from tests.report import samples

ENTRY = "tests.batch.stand_in:graded"
LOG = "BVHGRADE_TESTS_LOG"
"""Names the file that gets a line for each grading that begins: the process and the text."""

TRACEBACK = "Traceback of ours"

WISH = Wish(41, None, None, isolated=False)
SETTINGS = Settings("0.1", "1" * 64, "2" * 64, 41, "none", None)


def job(folder: Path, clerks: int | None = 2, scheduler: str | None = None) -> Job:
    """A class that is graded by this file."""
    return Job(folder, SETTINGS, WISH, clerks, entry=ENTRY, scheduler=scheduler)


def anew(folder: Path) -> Job:
    """The class of a folder with another seed."""
    return replace(job(folder), settings=replace(SETTINGS, seed=7), preview=True)


def begun(log: Path) -> list[str]:
    """The texts of the submissions whose grading has begun so far."""
    return [text for _, text in taken_up(log)]


def taken_up(log: Path) -> list[tuple[int, str]]:
    """Which process began to grade which text, in this order; of a long text its first line."""
    lines = log.read_text().splitlines() if log.exists() else []
    parts = [line.partition(" ") for line in lines]
    return [(int(clerk), text) for clerk, _, text in parts if clerk.isdecimal()]


def graded(order: Order, tell: Callable[[str], None]) -> Result | Failed:
    """Do what the submission says."""
    assert isinstance(order.submission, Submission)
    text = order.submission.source.decode(errors="replace").strip()
    log = Path(os.environ[LOG])
    before = begun(log)
    with log.open("a") as file:
        file.write(f"{os.getpid()} {text}\n")
    tell("[red]tracing[/red]")
    if text == "die" or (text == "die once" and text not in before):
        os.kill(os.getpid(), signal.SIGKILL)
    if text == "die aloud":
        print(TRACEBACK, flush=True)  # noqa: T201 - as Python does when it dies
        os.kill(os.getpid(), signal.SIGKILL)
    if text == "stumble":
        return Failed(failed_here(KeyError(TRACEBACK)), TRACEBACK)
    if text == "broken":
        withheld = replace(samples.broken(), submission=order.submission)
        return kept(replace(withheld, traceback=TRACEBACK))
    if text == "raise":
        return Failed("no more [bold]file descriptors")
    while text == "wait" or (text == "wait once" and text not in before):
        time.sleep(1)
    if text == "withheld once" and text not in before:
        return kept(replace(samples.broken(), submission=order.submission))
    loses = text == "wrong" or (text == "moody" and order.wish.seed != SETTINGS.seed)
    sample = samples.failing() if loses else samples.perfect()
    given = order.settings
    provenance = replace(
        sample.provenance,
        rubric_sha256=given.rubric_sha256,
        scenes_sha256=given.scenes_sha256,
        seed=given.seed,
        isolation=given.isolation,
    )
    return kept(replace(sample, submission=order.submission, provenance=provenance))


def careful(order: Order, tell: Callable[[str], None]) -> Result | Failed | Refused:
    """Do so only if the installation here would grade as the class is graded."""
    why = differences(order.wish, order.settings)
    return Refused(why) if why else graded(order, tell)


def main(source: str, folder: str, scheduler: str | None = None) -> int:
    """Grade a class in this process, as the command does."""
    from grader.cli.batch import graded as grade_class
    from grader.cli.interrupts import interruptible

    with interruptible():
        return grade_class(Path(source), job(Path(folder), scheduler=scheduler))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
