"""How does a terminal tell one problem at a time, for somebody who mends and saves?"""

from rich.console import Console

from grader.model.grade import Grade
from grader.model.stages import Rejected
from grader.model.verdict import Verdict
from grader.report.facts import unstarted, worst
from grader.report.failure import Occasion
from grader.report.sheet import Sheet
from grader.report.terminal import (
    banner,
    every_fault,
    header,
    is_exposed,
    rejected,
    uncompiled,
    worst_failure,
)


def print_problem(console: Console, grade: Grade, occasion: Occasion) -> None:
    """Print the score and the failure that costs most; the others are only counted."""
    sheet = Sheet(console)
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
        what_else(sheet, grade)
    sheet.show()


def what_else(sheet: Sheet, grade: Grade) -> None:
    """Say what comes after the failure that was explained, or that there was none."""
    idle = unstarted(grade)
    for sentence in idle.values():
        sheet.say(sentence, "yellow")
    shown = worst(grade)
    others = sum(
        score.verdict is Verdict.FAIL and score.part not in idle
        for score in grade.checks
        if score is not shown
    )
    if others:
        word = "check fails" if others == 1 else "checks fail"
        sheet.say(f"{others} more {word}; that comes later.", "dim")
    elif shown is None and all(score.verdict is Verdict.PASS for score in grade.checks):
        sheet.say("Everything passes.", "green")
