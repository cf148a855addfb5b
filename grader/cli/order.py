"""What does a command that grades know: whose file, and how it is to be graded?"""

import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grader.language import usual_language
from grader.report.escape import line_for_terminal


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be graded, and how."""

    path: Path
    seed: int
    rubric: Path | None
    only: tuple[str, ...]
    """Ids of the checks to run; empty for all."""

    time_limit: float | None
    """Wall seconds of the whole grade; None for the rubric's."""

    isolated: bool
    hints: int = 1
    """How much is said beyond the facts, 0 to 3."""
    for_student: bool = False
    """Whether what the rubric hides is left out."""

    language: str = "en"
    views: bool = True
    """Whether to draw what a report shows; who waits for the next save does without."""

    quick: bool = False
    """Whether only what finds most mistakes is run, and nothing is drawn or searched for."""


def ordered(path: Path, given: Mapping[str, Any]) -> Order:
    """Put together what the options say."""
    return Order(
        path,
        given["seed"],
        given["rubric"],
        given.get("only", ()),
        given["time_limit"],
        not given["unsafe_no_isolation"],
        given.get("hints", 1),
        language=given["language"] or usual_language(),
        quick=given.get("quick", False),
    )


def is_whole(order: Order) -> bool:
    """Tell whether every check of the rubric is run."""
    from grader.selection import select

    if order.only or order.quick:
        return False
    return not select(order.rubric, (), order.for_student).hidden


def repetition(order: Order) -> str:
    """Word the call that grades the same again, ready to be pasted; empty if it cannot be."""
    return call_of("check", order, "--seed", str(order.seed))


def call_of(name: str, order: Order, *given: str) -> str:
    """Word the call of a command for the same submission; empty if it cannot be pasted."""
    words = ["bvhgrade", name, str(order.path), *given]
    if order.rubric is not None:
        words += ["--rubric", str(order.rubric)]
    if order.language != usual_language():
        words += ["--language", order.language]
    command = shlex.join(words)
    return command if command == line_for_terminal(command) else ""
