"""How do submissions that are alike look on one page? Side by side, marked where they agree."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from grader.language import translator
from grader.report.html.page import page

LONGEST = 3000
"""Characters of a piece; a longer one would lose its middle when it is made printable."""

LARGEST = 60_000
"""Characters that are shown of one file."""


@dataclass(frozen=True, slots=True)
class Side:
    """One of two files."""

    names: tuple[str, ...]
    """Who handed it in."""

    text: str
    share: float
    """How much of it the other one has as well, 0 to 1; the starter's code does not count."""

    places: tuple[tuple[int, int], ...]
    """Where that stands: first character, and the one after the last."""


@dataclass(frozen=True, slots=True)
class Class:
    """What was compared."""

    submissions: int
    files: int
    """Different ones."""

    usual: float
    """The share that half of all pairs do not exceed."""

    least: float
    """The share from which on pairs are shown."""

    alike: int
    """Pairs of files from there on; not all need be shown."""

    given_up: tuple[tuple[str, ...], ...] = ()
    """For each file that took too long to be compared: who handed it in."""


def to_alike_page(
    whole: Class,
    shown: Sequence[tuple[Side, Side]],
    identical: Sequence[Sequence[str]],
    footer: str,
    language: str,
) -> str:
    """Write `similar.html`.

    Args:
        whole: What was compared.
        shown: Pairs, the most alike first.
        identical: For each file that several handed in: who.
        footer: With what they were compared.
        language: `en` or `de`.
    """
    words = translator(language)
    lead = words(
        "{submissions} submissions, {files} different files. Half of all pairs have at most "
        "{usual} of their own code in common, and {alike} have {least} or more."
    ).format(
        submissions=whole.submissions,
        files=whole.files,
        usual=percent(whole.usual),
        alike=whole.alike,
        least=percent(whole.least),
    )
    values = {
        "title": words("BVH exercise: submissions that are alike"),
        "lead": lead,
        "identical": [list(names) for names in identical],
        "given_up": [list(names) for names in whole.given_up],
        "pairs": [[_side(side) for side in pair] for pair in shown],
        "footer": footer,
    }
    return page("similar", language, values, {})


def percent(share: float) -> str:
    """Write a share."""
    return f"{100 * share:.0f} %"


def _side(side: Side) -> dict[str, object]:
    return {
        "names": list(side.names),
        "share": percent(side.share),
        "pieces": list(pieces(side.text[:LARGEST], side.places)),
        "cut": len(side.text) > LARGEST,
    }


def pieces(text: str, places: Sequence[tuple[int, int]]) -> Iterator[tuple[str, bool]]:
    """Cut a text at the borders of places; they may overlap, and lie outside of it.

    Yields:
        A piece, and whether it lies in a place.
    """
    at = 0
    for begin, end in sorted(places):
        begin, end = max(begin, at), min(end, len(text))
        if begin >= end:
            continue
        yield from _short(text[at:begin], marked=False)
        yield from _short(text[begin:end], marked=True)
        at = end
    yield from _short(text[at:], marked=False)


def _short(text: str, marked: bool) -> Iterator[tuple[str, bool]]:
    for begin in range(0, len(text), LONGEST):
        yield text[begin : begin + LONGEST], marked
