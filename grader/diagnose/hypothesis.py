"""How is a suspicion declared: a sentence, and a count of what speaks for and against it?

A hypothesis foretells what a submission with one certain misconception delivers. Where that is
not what a right one delivers, and the submission does deliver it, the place speaks for the
hypothesis; where the submission delivers anything else than foretold, against it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from grader.model.mesh import Mask

CaseT = TypeVar("CaseT")


@dataclass(frozen=True, slots=True)
class Support:
    """What speaks for a hypothesis and what against it."""

    fits: int
    """Wrong places that are wrong in the very way that was foretold."""

    against: int
    """Places that are otherwise than foretold, right or wrong."""


NOTHING = Support(0, 0)


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """One misconception, and how to look for it in a case."""

    id: str
    """`topic.what-is-done`: `axis.by-depth`. Several hypotheses may be of one misconception."""

    kind: type
    """Cases of this type are shown to `decide`."""

    sentence: str
    """What is likely wrong: first line of the docstring of `decide`, shown to the student."""

    decide: Callable[[Any], Support]
    least: int = 3
    """So many places have to be as foretold: fewer may be so by chance."""

    general: bool = False
    """Named only where no other one is: it foretells less exactly than they do."""


def hypothesis(
    kind: type[CaseT], id: str, least: int = 3, general: bool = False
) -> Callable[[Callable[[CaseT], Support]], Hypothesis]:
    """Turn a function from a case to its support into a `Hypothesis`; registers nothing."""

    def declare(decide: Callable[[CaseT], Support]) -> Hypothesis:
        sentence = (decide.__doc__ or "").strip().split("\n")[0]
        return Hypothesis(id, kind, sentence, decide, least, general)

    return declare


def weighed(foretold: Mask, right: Mask) -> Support:
    """Count places.

    Args:
        foretold: (K,) bool, True where the submission does what was foretold.
        right: (K,) bool, True where that is not a mistake.
    """
    return Support(
        int(np.count_nonzero(foretold & ~right)),
        int(np.count_nonzero(np.logical_not(foretold))),
    )
