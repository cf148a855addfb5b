"""How a check is declared: a sentence, a mask that is True where wrong, and one message."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from grader.model.mesh import Mask
from grader.model.verdict import Evidence, Example

CaseT = TypeVar("CaseT")

MAX_EXAMPLES = 3
"""More than three examples teach nothing new."""


@dataclass(frozen=True, slots=True)
class Check:
    """One statement that is true of a right submission, and how to decide it on one case."""

    id: str
    kind: type
    """Cases of this type are shown to `decide`."""

    title: str
    """The statement: first line of the docstring of `decide`, shown to the student."""

    needs: tuple[str, ...]
    """Checks that must not have failed on the same case, else this one is BLOCKED."""

    when: Callable[[Any], bool]
    """Whether a trial gives a right submission something to examine; others are left out."""

    decide: Callable[[Any], Evidence]

    blames: tuple[str, ...] = ()
    """Checks that `decide` may name as the reason that it could not look at a case."""


def always(_: object) -> bool:
    """Every trial of its kind gives a check something to examine."""
    return True


def check(
    kind: type[CaseT],
    id: str,
    needs: tuple[str, ...] = (),
    when: Callable[[Any], bool] = always,
    blames: tuple[str, ...] = (),
) -> Callable[[Callable[[CaseT], Evidence]], Check]:
    """Turn a function from a case to evidence into a `Check`; registers nothing.

    Args:
        kind: The case type that the function takes.
        id: `topic.statement-in-kebab-case`, the statement as it is when it is right.
        needs: Ids of the checks that must hold before this one can be decided.
        when: Tells of a trial whether it is one for this check.
        blames: Ids that its evidence may be `hidden_by`; they are decided beside it.
    """

    def declare(decide: Callable[[CaseT], Evidence]) -> Check:
        title = (decide.__doc__ or "").strip().split("\n")[0].rstrip(".")
        return Check(id, kind, title, needs, when, decide, blames)

    return declare


def judged(
    wrong: Mask, example: Callable[[int], Example], examined: int | None = None
) -> Evidence:
    """Count a mask and word its first three places.

    Args:
        wrong: (K,) bool, True where the submission is wrong.
        example: Words one place, given its index into `wrong`.
        examined: How many things were looked at, if not all of `wrong`.
    """
    places = np.flatnonzero(wrong)
    return Evidence(
        examined=wrong.size if examined is None else examined,
        wrong=int(places.size),
        examples=tuple(example(int(place)) for place in places[:MAX_EXAMPLES]),
    )


def one(wrong: Example | None) -> Evidence:
    """Judge a case as a single thing: right, or wrong in one way."""
    return Evidence(1, 1, (wrong,)) if wrong else Evidence(1, 0)


def vector(values: Any) -> str:  # noqa: ANN401 - any sequence of three float32
    """Write three float32 so that two different numbers never look alike."""
    return "(" + ", ".join(f"{float(value):.9g}" for value in values) + ")"
