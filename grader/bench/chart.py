"""What is there to see? How far each ratio is from its bound, and how costs grow."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

from grader.bench.drawing import Box, Dot, Drawing, Label, Line, Shape
from grader.bench.record import Reading, Size, Table
from grader.bench.scale import COSTS

WIDTH, ROW, TOP = 900, 24, 48
BAR_LEFT, BAR_RIGHT = 430, 860
FARTHEST = 2.0
"""Ratios beyond twice their bound end at the border, with their number."""

INK, FAINT, MET, MISSED = "#222222", "#cccccc", "#2a7f62", "#b5482f"
COLOURS = ("#2a5ca8", "#2a7f62", "#b5482f", "#7a4fa3")
PLOT_HEIGHT, NAME_HEIGHT = 320, 15


def chart_of(table: Table) -> Drawing:
    """Draw the table: a bar for each goal, and below it costs by number of faces."""
    bars = [each for each in table.readings if each.is_met is not None]
    below = TOP + ROW * len(bars) + 40
    shapes = [*_bars(bars), *(_curves(table.sizes, below) if table.sizes else ())]
    height = below + (PLOT_HEIGHT + 60 if table.sizes else 0)
    return Drawing(WIDTH, height, "Performance goals of bvhgrade, as ratios", shapes)


def share_of_bound(reading: Reading) -> float:
    """Return 1 for a ratio at its bound, less for a better one, whichever way it counts."""
    if reading.ratio is None or reading.goal.bound is None:
        raise AssertionError("only measured goals with a bound are drawn")
    if reading.goal.at_most:
        return reading.ratio.median / reading.goal.bound
    return reading.goal.bound / reading.ratio.median


def _bars(readings: Sequence[Reading]) -> Iterator[Shape]:
    scale = (BAR_RIGHT - BAR_LEFT) / FARTHEST
    goal = BAR_LEFT + scale
    yield Label(20, 20, "share of the bound (shorter is better)", INK, size=14)
    for row, reading in enumerate(readings):
        y = TOP + ROW * row
        share = share_of_bound(reading)
        ink = MET if reading.is_met else MISSED
        yield Label(
            20, y + ROW / 2, f"{reading.goal.number}  {reading.goal.title}", INK, size=12
        )
        yield Box(BAR_LEFT, y + 5, scale * min(share, FARTHEST), ROW - 10, ink)
        yield Label(
            BAR_LEFT + scale * min(share, FARTHEST) + 4, y + ROW / 2, f"{share:.2f}", INK
        )
    yield Line(goal, TOP - 6, goal, TOP + ROW * len(readings), INK, 1.5)
    yield Label(goal, TOP - 14, "bound", INK, "middle")


def _curves(sizes: Sequence[Size], top: float) -> Iterator[Shape]:
    """Draw seconds by faces, both in powers of ten."""
    left, right, bottom = 90.0, 760.0, top + PLOT_HEIGHT
    seconds = [max(1e-4, cost.of(size)) for size in sizes for cost in COSTS]
    x_range = _decades([size.faces for size in sizes])
    y_range = _decades(seconds)

    def place(faces: float, cost: float) -> tuple[float, float]:
        x = (math.log10(faces) - x_range[0]) / (x_range[1] - x_range[0])
        y = (math.log10(cost) - y_range[0]) / (y_range[1] - y_range[0])
        return left + x * (right - left), bottom - y * PLOT_HEIGHT

    for power in range(x_range[0], x_range[1] + 1):
        x, _ = place(10.0**power, 10.0 ** y_range[0])
        yield Line(x, top, x, bottom, FAINT)
        yield Label(x, bottom + 16, f"{10**power:,} faces", INK, "middle")
    for power in range(y_range[0], y_range[1] + 1):
        _, y = place(10.0 ** x_range[0], 10.0**power)
        yield Line(left, y, right, y, FAINT)
        yield Label(left - 8, y, f"{10.0**power:g} s", INK, "end")
    for colour, cost in zip(COLOURS, COSTS, strict=True):
        points = [place(size.faces, max(1e-4, cost.of(size))) for size in sizes]
        for (x, y), (to_x, to_y) in pairwise(points):
            yield Line(x, y, to_x, to_y, colour, 2)
        yield from (Dot(x, y, 3, colour) for x, y in points)
    yield from _names(sizes[-1], place)


def _names(
    largest: Size, place: Callable[[float, float], tuple[float, float]]
) -> Iterator[Shape]:
    """Write beside the last dots which cost they are, none over another."""
    ends = [
        (*place(largest.faces, max(1e-4, cost.of(largest))), cost.what, colour)
        for colour, cost in zip(COLOURS, COSTS, strict=True)
    ]
    lowest = -math.inf
    for x, y, what, colour in sorted(ends, key=lambda end: end[1]):
        lowest = max(y, lowest + NAME_HEIGHT)
        yield Label(x + 10, lowest, what, colour)


def _decades(values: Sequence[float]) -> tuple[int, int]:
    """Return the powers of ten between which values lie, one apart at least."""
    low = math.floor(math.log10(min(values)))
    return low, max(low + 1, math.ceil(math.log10(max(values))))
