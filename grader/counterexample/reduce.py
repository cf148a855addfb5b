"""How is a set of things made smaller while something stays true of it? Delta debugging.

Every round proposes many subsets at once, the smallest first, because asking about a hundred
costs hardly more than asking about one. There is no clock in here: how far a reduction comes
depends on the answers only.

Source: A. Zeller, R. Hildebrandt, Simplifying and Isolating Failure-Inducing Input, IEEE
Transactions on Software Engineering 28(2), 2002.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import chain

import numpy as np

from grader.model.mesh import Integers

FirstFailing = Callable[[Sequence[Integers]], int | None]
"""Of subsets, the smallest first: the index of the first that still fails, if one does."""

SIZES = (
    *range(11),
    *(12, 14, 17, 20, 24, 33, 48, 64, 96, 129, 192, 257, 384, 513, 1025, 2049, 4097),
)
"""Of subsets that are drawn: all small ones, and those around which trees change."""

SHUFFLES = 3
"""Subsets of each size that are drawn."""


def reduced(
    items: Integers, fails: FirstFailing, most: int, rounds: int, first: Integers | None = None
) -> Integers:
    """Return a subset that fails, of which no proposal that is smaller does.

    Args:
        items: (K,) int64, ascending; known to fail.
        fails: Tries subsets, each ascending.
        most: Subsets that are tried in a round.
        rounds: How often subsets may be tried.
        first: (K,) int64, items that probably matter, the most important first; the first
            round draws subsets that hold them.

    Returns:
        (K,) int64, ascending.
    """
    lead = np.zeros(0, np.int64) if first is None else first
    waiting: Iterator[Integers] = chain(drawn(items, lead), divided(items))
    for _ in range(rounds):
        proposals = _next(waiting, items.size, most)
        if not proposals:
            break
        chosen = fails(proposals)
        if chosen is not None:
            items = proposals[chosen]
            waiting = divided(items)
    return items


def drawn(items: Integers, lead: Integers) -> Iterator[Integers]:
    """Propose subsets of many sizes: the leading items, then others at random.

    Items, leading ones and each subset are (K,) int64; subsets are ascending.
    """
    rng = np.random.default_rng([items.size, lead.size])
    for _ in range(SHUFFLES):
        rest = rng.permutation(items[~np.isin(items, lead)])
        order = np.concatenate([lead, rest])
        yield from (np.sort(order[:size]) for size in SIZES)


def divided(items: Integers) -> Iterator[Integers]:
    """Propose the parts of finer and finer divisions, and what is left without each part.

    Items and each part are (K,) int64, ascending.
    """
    parts = 2
    while parts < 2 * items.size:
        pieces = np.array_split(items, min(parts, items.size))
        yield from pieces
        yield from (np.setdiff1d(items, piece, assume_unique=True) for piece in pieces)
        parts *= 2


def _next(waiting: Iterator[Integers], below: int, most: int) -> list[Integers]:
    """Take the next proposals, without those that are there twice or no smaller, by size."""
    found: dict[bytes, Integers] = {}
    for one in waiting:
        if one.size < below:
            found[one.tobytes()] = one
        if len(found) == most:
            break
    return sorted(found.values(), key=lambda one: one.size)
