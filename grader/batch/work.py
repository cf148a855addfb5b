"""What does a clerk do with one submission? Grade it, and write down all that is kept."""

import json
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from grader.batch.settings import Settings, Wish, settled
from grader.errors import GraderError, failed_here
from grader.kept import Result, kept
from grader.model.stages import Rejected, Submission
from grader.pipeline import grade_located

ENTRY = "grader.batch.work:graded"


@dataclass(frozen=True, slots=True)
class Order:
    """A submission, and how to grade it."""

    submission: Submission | Rejected
    wish: Wish
    settings: Settings
    """What the wish means for the class, and has to mean wherever it is graded."""


@dataclass(frozen=True, slots=True)
class Failed:
    """We failed to grade it; nothing is known of the submission."""

    why: str
    traceback: str = ""
    """Of a fault that nobody foresaw, for a maintainer."""


@dataclass(frozen=True, slots=True)
class Refused:
    """Whoever was to grade it would grade otherwise than the class; so would all others."""

    why: str


def graded(order: Order, tell: Callable[[str], None]) -> Result | Failed | Refused:
    """Grade one submission, if it means the same here as for the class.

    Args:
        order: What and how.
        tell: Is told each stage as it begins.
    """
    if why := differences(order.wish, order.settings):
        return Refused(why)
    told = ""

    def progress(stage: str, _: int, __: int) -> None:
        nonlocal told
        if stage != told:
            told = stage
            tell(stage)

    options = replace(order.wish.options(), progress=progress)
    try:
        result = kept(grade_located(order.submission, options))
    except GraderError as fault:
        return Failed(str(fault))
    except Exception as fault:  # noqa: BLE001 - one submission must not end the class
        return Failed(failed_here(fault), "".join(traceback.format_exception(fault)))
    if other := unlike(json.loads(result.text), order.settings):
        return Refused(
            f"{', '.join(other)}: not what the class was begun with, so a file of the rubric "
            "was changed meanwhile; call again with the rubric as it was, or with --regrade"
        )
    return result


def unlike(result: Mapping[str, Any], settings: Settings) -> list[str]:
    """Name what decided a result that is otherwise in these settings; the rubric is a file."""
    found, names = result["provenance"], ("rubric_sha256", "scenes_sha256", "seed", "isolation")
    return [name for name in names if found[name] != getattr(settings, name)]


@cache
def differences(wish: Wish, settings: Settings) -> str:
    """Say what decides a grade here that is not so for the class; empty if nothing."""
    try:
        changes = "; ".join(settings.changes(settled(wish)))
    except GraderError as fault:
        return str(fault)
    return changes and f"it would grade otherwise than the class ({changes})"
