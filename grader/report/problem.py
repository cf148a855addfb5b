"""How does a terminal tell one problem at a time, for somebody who mends and saves?"""

from rich.console import Console

from grader.language import translator
from grader.model.grade import Grade
from grader.model.stages import Rejected
from grader.model.verdict import Verdict
from grader.report.counts import teller
from grader.report.facts import unstarted, worst
from grader.report.failure import Occasion
from grader.report.sheet import Sheet
from grader.report.terminal import (
    banner,
    every_fault,
    first_step,
    header,
    is_exposed,
    not_begun,
    rejected,
    remarks,
    uncompiled,
    worst_failure,
)


def print_problem(console: Console, grade: Grade, occasion: Occasion, whole: bool) -> None:
    """Print the score and the failure that costs most; the others are only counted.

    Args:
        console: Where.
        grade: What came of a run.
        occasion: How it came to be printed.
        whole: Whether every check was run.
    """
    sheet = Sheet(console, translator(occasion.language), teller(occasion.language))
    header(sheet, grade)
    if is_exposed(grade):
        banner(sheet)
    if isinstance(grade.submission, Rejected):
        rejected(sheet, grade.submission)
    elif grade.build is not None and grade.build.library is None:
        uncompiled(sheet, grade)
    else:
        every_fault(sheet, grade)
        worst_failure(sheet, grade, occasion)
        what_else(sheet, grade, whole)
        first_step(sheet, grade, occasion)
    remarks(sheet, grade)
    sheet.show()


def what_else(sheet: Sheet, grade: Grade, whole: bool) -> None:
    """Say what comes after the failure that was explained, or that there was none."""
    idle = unstarted(grade)
    for part in idle:
        not_begun(sheet, part)
    shown = worst(grade)
    others = sum(
        score.verdict is Verdict.FAIL and score.part not in idle
        for score in grade.checks
        if score is not shown
    )
    if others:
        one = sheet.words("1 more check fails; it is shown once this one passes.")
        many = sheet.words("{others} more checks fail; they are shown once this one passes.")
        sheet.say(one if others == 1 else many.format(others=others), "dim")
    elif shown is None and all(score.verdict is Verdict.PASS for score in grade.checks):
        sheet.say(all_pass(sheet, len(grade.checks), whole), "green")


def all_pass(sheet: Sheet, checks: int, whole: bool) -> str:
    """Say what passes, and no more than was run."""
    if whole:
        return sheet.words("Everything passes.")
    if checks == 1:
        return sheet.words("The check of this run passes.")
    return sheet.words("All {checks} checks of this run pass.").format(checks=checks)
