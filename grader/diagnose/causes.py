"""Which hypothesis explains what failed? One for each failed check, or none where it is unsure.

A hypothesis is only tried if the table of known mistakes says that it makes some failed check
fail. It is named if nearly everything is as it foretells; of several the one that foretells
best and whose known failures are most like those at hand. A cause moves no point.
"""

from collections.abc import Collection, Iterable, Sequence
from functools import partial
from typing import Any

import numpy as np

from grader.diagnose import every_hypothesis
from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support
from grader.diagnose.notes import Notes
from grader.diagnose.patterns import explained, likeness
from grader.errors import let_go
from grader.model.cases import Case
from grader.model.grade import Cause, CheckScore
from grader.model.trials import part_of
from grader.model.verdict import Verdict

SURE = 0.95
"""Share of places that have to be as foretold."""

WEIGHT_OF_PATTERN = 0.1
"""How much the very pattern of failed checks outweighs places that are otherwise."""

HOPELESS = 20
"""After so many places that are otherwise, and half of all, nothing more is looked at."""


def causes_by_part(notes: Notes, told: Notes, scores: Sequence[CheckScore]) -> dict[str, Cause]:
    """Name the likely cause of failed checks, each from the cases of its own part.

    Args:
        notes: What is kept of the run.
        told: The cases of it that a student may hear of. Whoever sees some checks only must
            not learn from a cause what the others look at.
        scores: All of the run.
    """
    secret = {one.check for one in scores if one.visibility != "visible"}
    causes: dict[str, Cause] = {}
    for part in {one.part for one in scores}:
        mine = partial(_is_of, part=part)
        failed = {
            one.check for one in scores if one.part == part and one.verdict is Verdict.FAIL
        }
        every = likely_causes(notes.only(mine), failed)
        if secret:
            visible = likely_causes(told.only(mine), failed - secret)
            every = {check: every[check] for check in every.keys() & secret} | visible
        causes |= every
    return causes


def _is_of(case: Case, part: str) -> bool:
    """What is said of the file alone is said of all parts."""
    trial = getattr(case, "trial", None)
    return trial is None or part_of(trial) == part


def likely_causes(notes: Notes, failed: Collection[str]) -> dict[str, Cause]:
    """Name the likely cause of failed checks; checks without one are left out."""
    found = sorted(_supported(notes, failed), key=lambda one: one[0], reverse=True)
    causes: dict[str, Cause] = {}
    for _, each, support in found:
        mine = explained(each.id) & set(failed)
        if not mine & set(causes):
            places = support.fits + support.against
            causes |= dict.fromkeys(mine, Cause(each.id, each.sentence, support.fits, places))
    return causes


Ranked = tuple[tuple[bool, float, int], Hypothesis, Support]


def _supported(notes: Notes, failed: Collection[str]) -> Iterable[Ranked]:
    for each in every_hypothesis():
        if explained(each.id).isdisjoint(failed):
            continue
        support = weigh(each, notes)
        share = support.fits / max(support.fits + support.against, 1)
        if support.fits >= each.least and share >= SURE:
            rank = share + WEIGHT_OF_PATTERN * likeness(each.id, failed)
            yield (not each.general, rank, support.fits), each, support


def weigh(each: Hypothesis, notes: Notes) -> Support:
    """Look for a misconception in all cases of its kind, small ones first."""
    fits = against = 0
    cases: list[Any] = notes.of(each.kind)
    for case in cases:
        support = _tried(each, case)
        fits, against = fits + support.fits, against + support.against
        if against > HOPELESS and against > fits:
            break
    return Support(fits, against)


def _tried(each: Hypothesis, case: Any) -> Support:  # noqa: ANN401 - of the hypothesis's kind
    try:
        # A stranger's numbers may be anything, and what follows from them is only compared.
        with np.errstate(all="ignore"):
            return each.decide(case)
    except Exception as fault:  # noqa: BLE001 - only a hint is lost, and never a grade
        let_go(fault)
        return NOTHING
