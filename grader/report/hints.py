"""What is said beyond the facts, step by step: a likely cause, a question, something to try.

None of it is the solution: a cause says what is misunderstood, a question where to look, and
what there is to try shows the mistake on paper or in a debugger.
"""

import re
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files

from grader.language import Words
from grader.model.grade import CheckScore
from grader.report.counts import counted, regrouped

NO_HINTS, WITH_CAUSE, WITH_QUESTION, WITH_TRIAL = range(4)
"""Steps of `--hints`; each tells what the one before it does, and one thing more."""


@cache
def told() -> Mapping[str, Mapping[str, str]]:
    """Read what is asked, and what there is to try, by check."""
    text = files("grader.report").joinpath("hints.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


_SHARE = re.compile(r"(?s)(.*) This explains ([\d,]+) of ([\d,]+) places\.")

LABELS = ("cause", "hint", "try")


def likely_cause(score: CheckScore, words: Words = str) -> str:
    """Word the likely cause of a failure, and how much speaks for it; empty if unsure."""
    cause = score.cause
    if cause is None:
        return ""
    if cause.places == 1:
        return words(cause.sentence)
    share = words("This explains {fits} of {places} places.")
    fits, places = (counted(number, words) for number in (cause.fits, cause.places))
    share = share.format(fits=fits, places=places)
    return f"{words(cause.sentence)} {share}"


def misconception(cause: str) -> tuple[str, str, str]:
    """Split what `likely_cause` wrote into the misconception, and how many places fit of all.

    Both numbers are empty if it named none.
    """
    found = _SHARE.fullmatch(cause)
    return (found[1], found[2], found[3]) if found else (cause, "", "")


def cause_in(hint: str, words: Words) -> str:
    """Tell in a language what `likely_cause` wrote in English."""
    sentence, fits, places = misconception(hint)
    if not places:
        return words(hint)
    share = words("This explains {fits} of {places} places.").format(
        fits=regrouped(fits, words), places=regrouped(places, words)
    )
    return f"{words(sentence)} {share}"


def hints(score: CheckScore, step: int, words: Words = str) -> list[tuple[str, str]]:
    """Choose what is said about a failure, each with its label.

    Args:
        score: The failed check.
        step: 0 to 3, as in `--hints`.
        words: Translates.
    """
    more = told().get(score.check, {})
    texts = (
        likely_cause(score, words),
        words(more.get("question", "")),
        words(more.get("trial", "")),
    )
    return [(label, text) for label, text in zip(LABELS, texts[:step], strict=False) if text]
