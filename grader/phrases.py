"""How is a message with numbers in it told in another language?

Theory of operation. Checks word what they found in English, and so it stands in `result.json`,
which is the same for everybody. A report that speaks another language finds the sentence again:
the catalogue has each of them with letters in braces where the numbers stand. What stood there
is looked up in turn, so that `but {a} is closer` needs no sentence for each surface. A hole
named `raw` holds a stranger's words, which stay as they are; so does whatever the catalogue
lacks. Texts are matched piece by piece from the left, never by a regular expression, because a
submission may have written parts of them.

Checks write counts as English has them, `4,480 faces`. A hole that is a count and nothing else
gets what the language puts between groups of digits, which the catalogue has as the translation
of a comma; coordinates, names and a stranger's words stay. German gets a point: a narrow space
would be better beside decimals, but `grader.plain` lets no space through but the ordinary one,
at which a line may end.
"""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

from grader.language import Words, catalogue, translator

HOLE = re.compile(r"\{([a-f]|raw)\}")
RAW = "raw"
COUNT = re.compile(r"[1-9]\d{0,2}(?:,\d{3})+")
LONGEST = 2_000
"""Characters of a message that is looked at; ours have 300."""

FEW = 6
"""Letters of a sentence with which it says so little that joints are looked for first."""

DEEPEST = 8
"""Sentences within sentences."""

JOINTS = (re.compile(r"(: )"), re.compile(r"(; )"), re.compile(r"(, )(?=but )"))
"""Where two sentences of the catalogue meet in one message, without a hole for either."""


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence with holes, and its translation."""

    pieces: tuple[str, ...]
    """What stands before, between and behind the holes."""

    holes: tuple[str, ...]
    other: str

    @property
    def letters(self) -> int:
        """How much of it tells it from other sentences."""
        return sum(map(str.isalpha, "".join(self.pieces)))

    def held(self, text: str) -> dict[str, str] | None:
        """Return what a text has in the holes; None if it is another sentence."""
        first, *middle, last = self.pieces
        end = len(text) - len(last)
        if not (text.startswith(first) and text.endswith(last)) or end < len(first):
            return None
        found, at = [], len(first)
        for piece in middle:
            place = text.find(piece, at + 1, end)
            if place < 0:
                return None
            found.append(text[at:place])
            at = place + len(piece)
        found.append(text[at:end])
        return dict(zip(self.holes, found, strict=True)) if all(found) else None


def counted(number: int, words: Words = str) -> str:
    """Write a count: `14,811`."""
    return regrouped(f"{number:,}", words)


def regrouped(written: str, words: Words) -> str:
    """Write in another language a count that is written in English."""
    return written.replace(",", words(","))


def teller(language: str) -> Words:
    """Return what tells messages of checks in a language; English ones stay as they are."""
    if language == "en":
        return _unchanged
    return lambda text: _told(text, language, 0)


def _unchanged(text: str) -> str:
    return text


def _told(text: str, language: str, depth: int) -> str:
    """Translate a message, and what is in its holes."""
    known = catalogue(language, "check")
    if text in known:
        return known[text]
    if COUNT.fullmatch(text):
        return regrouped(text, translator(language))
    if depth > DEEPEST or len(text) > LONGEST:
        return text

    def again(part: str) -> str:
        return _told(part, language, depth + 1)

    strong, weak = sentences(language)
    return (
        _found(strong, text, again) or _joined(text, again) or _found(weak, text, again) or text
    )


def _found(known: Sequence[Sentence], text: str, again: Callable[[str], str]) -> str:
    """Translate a text that is one of these sentences; empty if it is none."""
    for sentence in known:
        held = sentence.held(text)
        if held is not None:
            return _filled(sentence, held, again)
    return ""


def _filled(sentence: Sentence, held: dict[str, str], again: Callable[[str], str]) -> str:
    def put(hole: re.Match[str]) -> str:
        name = hole[1]
        return held[name] if name == RAW else again(held[name])

    return HOLE.sub(put, sentence.other)


def _joined(text: str, again: Callable[[str], str]) -> str:
    """Translate both sides of the first place where sentences meet; empty if there is none."""
    for joint in JOINTS:
        before, *rest = joint.split(text, maxsplit=1)
        if rest:
            mark, after = rest
            return again(before) + mark + again(after)
    return ""


@cache
def sentences(language: str) -> tuple[tuple[Sentence, ...], tuple[Sentence, ...]]:
    """Return sentences with holes, the longest first, and apart those that say little."""
    found = []
    for english, other in catalogue(language, "check").items():
        pieces = HOLE.split(english)
        if len(pieces) > 1:
            found.append(Sentence(tuple(pieces[::2]), tuple(pieces[1::2]), other))
    found.sort(key=lambda one: -one.letters)
    strong = tuple(one for one in found if one.letters > FEW)
    return strong, tuple(found[len(strong) :])
