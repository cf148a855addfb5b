"""What does a clerk do with one submission? Grade it, and write down all that is kept."""

import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace

from grader.batch.records import Result
from grader.batch.settings import Wish
from grader.errors import GraderError
from grader.model.grade import Grade
from grader.model.stages import Rejected, Submission
from grader.output import VIEWS
from grader.pipeline import grade_located
from grader.plain import printable

ENTRY = "grader.batch.work:graded"

LONGEST_FAULT = 4000
"""Characters of a traceback that are kept."""


@dataclass(frozen=True, slots=True)
class Order:
    """A submission, and how to grade it."""

    submission: Submission | Rejected
    wish: Wish


@dataclass(frozen=True, slots=True)
class Failed:
    """We failed to grade it; nothing is known of the submission."""

    why: str


def graded(order: Order, tell: Callable[[str], None]) -> Result | Failed:
    """Grade one submission.

    Args:
        order: What and how.
        tell: Is told each stage as it begins.
    """
    told = ""

    def progress(stage: str, _: int, __: int) -> None:
        nonlocal told
        if stage != told:
            told = stage
            tell(stage)

    options = replace(order.wish.options(), progress=progress)
    try:
        return kept(grade_located(order.submission, options))
    except GraderError as fault:
        return Failed(str(fault))
    except Exception as fault:  # noqa: BLE001 - one submission must not end the class
        return Failed(printable("".join(traceback.format_exception(fault)), LONGEST_FAULT))


def kept(grade: Grade) -> Result:
    """Write down all that is known of a grade; pages are made from this, at any time."""
    from grader.counterexample.written import to_text as counterexample
    from grader.report.as_json import to_text
    from grader.report.facts import counterexample_file
    from grader.report.views import to_text as views_text

    files = tuple(
        (counterexample_file(score), counterexample(score.counterexample))
        for score in grade.checks
        if score.counterexample is not None
    )
    if grade.views is not None:
        files = (*files, (VIEWS, views_text(grade.views)))
    return Result(to_text(grade), files)
