"""How are large counts written? In groups of three digits, with what a language puts between.

Checks write `4,480 faces`, as English has it. `grader.phrases` tells the sentence around a
count and leaves alone what is in its holes, since that may be coordinates, a name or a
stranger's words. Here a hole that is a count and nothing else gets the sign of the language,
which the catalogue has as the translation of a comma. German gets a point: a narrow space would
be better beside decimals, but `grader.plain` lets no space through but the ordinary one, at
which a line may end.

The search for the sentence is that of `grader.phrases`, down to its own functions. It stands
here because that module belongs to what a verdict depends on, and this one does not.
"""

import re

from grader import phrases
from grader.language import Words, catalogue, translator

COUNT = re.compile(r"[1-9]\d{0,2}(?:,\d{3})+")


def counted(number: int, words: Words = str) -> str:
    """Write a count: `14,811`."""
    return regrouped(f"{number:,}", words)


def regrouped(written: str, words: Words) -> str:
    """Write in another language a count that is written in English."""
    return written.replace(",", words(","))


def teller(language: str) -> Words:
    """Return what tells messages of checks in a language, counts included."""
    told = phrases.teller(language)
    return told if language == "en" else lambda text: _told(text, language, 0)


def _told(text: str, language: str, depth: int) -> str:
    if COUNT.fullmatch(text):
        return regrouped(text, translator(language))
    is_known = text in catalogue(language, "check")
    if is_known or depth > phrases.DEEPEST or len(text) > phrases.LONGEST:
        return phrases.teller(language)(text) if is_known else text

    def again(part: str) -> str:
        return _told(part, language, depth + 1)

    strong, weak = phrases.sentences(language)
    return (
        phrases._found(strong, text, again)
        or phrases._joined(text, again)
        or phrases._found(weak, text, again)
        or text
    )
