"""How do runs become numbers? Interleaved rounds, medians, spreads and fitted exponents."""

import math
import statistics
from collections.abc import Callable, Mapping, Sequence

from grader.bench.record import Cost, Spread

Run = Callable[[], Cost]


def interleaved(runs: Mapping[str, Run], rounds: int) -> dict[str, list[Cost]]:
    """Do every run once in each round, so that a busy minute disturbs all of them alike.

    Args:
        runs: What to run, by name.
        rounds: How often.

    Returns:
        The costs of each, one a round, in the order of the rounds.
    """
    costs: dict[str, list[Cost]] = {name: [] for name in runs}
    for number in range(rounds):
        names = list(runs)
        # Who comes first in one round comes last in the next: a drift favours nobody.
        for name in names if number % 2 == 0 else reversed(names):
            costs[name].append(runs[name]())
    return costs


def spread(values: Sequence[float]) -> Spread:
    """Return the median of at least one number, and the smallest and the largest of them."""
    return Spread(statistics.median(values), min(values), max(values), len(values))


def ratios(above: Sequence[float], below: Sequence[float]) -> Spread | None:
    """Divide round by round: what slows a whole round down falls out.

    A difference of two times that is not above 0 is noise, and no ratio is made of it.

    Args:
        above: One number a round.
        below: As many.

    Returns:
        Of the rounds that have both; None if there are none.
    """
    found = [a / b for a, b in zip(above, below, strict=True) if min(a, b) > 0]
    return spread(found) if found else None


def lost_in_noise(above: Sequence[float], below: Sequence[float]) -> str:
    """Word how many rounds `ratios` leaves out; empty if none."""
    lost = sum(min(pair) <= 0 for pair in zip(above, below, strict=True))
    return f"; {lost} of {len(above)} rounds were lost in the noise" if lost else ""


def exponent(sizes: Sequence[float], costs: Sequence[float]) -> float:
    """Fit `cost = factor * size ** exponent` by least squares on logarithms.

    Args:
        sizes: At least two different ones, all above 0.
        costs: As many, all above 0.
    """
    x, y = [math.log(size) for size in sizes], [math.log(cost) for cost in costs]
    return statistics.linear_regression(x, y).slope
