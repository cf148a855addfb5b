"""The table says what was measured, and what it is held to."""

from dataclasses import replace

from grader.bench import goals
from grader.bench.record import Reading, Spread
from grader.bench.shown import lines_of
from tests.bench.tables import READINGS, TABLE


def test_a_goal_is_met_on_its_own_side() -> None:
    """A speed shall not be smaller than its bound, a cost not larger."""
    assert [reading.is_met for reading in READINGS] == [False, False, True, False, None]
    at_the_bound = Spread(goals.FAST_CAMERA.bound or 0.0, 0.1, 0.9, 3)
    assert Reading(goals.FAST_CAMERA, at_the_bound, "").is_met


def test_a_ratio_without_a_bound_is_neither() -> None:
    """It is only reported."""
    free = replace(goals.WALL, bound=None)
    assert Reading(free, Spread(1.0, 1.0, 1.0, 1), "").is_met is None


def test_every_line_stands_alone() -> None:
    """Each goal has its number, bound, ratio with spread, state and the two quantities."""
    lines = lines_of(TABLE)
    row = next(line for line in lines if line.startswith("1 "))
    for part in ("<= 1.10", "1.20 (1.10 to 1.30)", "not met", "6.0 s / 5.0 s"):
        assert part in row
    missing = next(line for line in lines if line.startswith("3b"))
    assert "not measured" in missing
    assert "check50 is not installed" in missing


def test_costs_and_peaks_are_shown() -> None:
    """With their units."""
    text = "\n".join(lines_of(TABLE))
    assert "4,000,000   1.500 s" in text
    assert "construct 1.05, check 0.90" in text
    assert "900 MiB, its largest child 700 MiB" in text
