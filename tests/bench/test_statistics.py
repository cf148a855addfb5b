"""Runs become numbers: the arithmetic is held to examples that are done in the head."""

import math
from functools import partial

import pytest

from grader.bench import scale
from grader.bench.boxes import _mean
from grader.bench.record import Cost, Size, Spread
from grader.bench.statistics import exponent, interleaved, lost_in_noise, ratios, spread


def test_rounds_take_turns() -> None:
    """Each round runs everything once, every other one the other way round."""
    order: list[str] = []

    def run(name: str) -> Cost:
        order.append(name)
        return Cost(len(order), 0.0)

    costs = interleaved({name: partial(run, name) for name in "abc"}, 3)
    assert "".join(order) == "abccbaabc"
    assert [cost.cpu for cost in costs["a"]] == [1, 6, 7]


def test_a_spread_is_median_and_extremes() -> None:
    """Of an even number the median is the mean of the two in the middle."""
    found = spread([4.0, 1.0, 2.0, 10.0])
    assert (found.median, found.low, found.high, found.rounds) == (3.0, 1.0, 10.0, 4)


def test_a_ratio_is_taken_in_each_round() -> None:
    """A round in which everything takes ten times as long changes nothing."""
    found = ratios([1.0, 10.0, 1.0], [2.0, 20.0, 2.0])
    assert found == Spread(0.5, 0.5, 0.5, 3)


def test_a_round_that_was_lost_in_the_noise_is_left_out() -> None:
    """And told; where nothing is left there is no ratio."""
    assert ratios([1.0, 0.0, 3.0], [2.0, 2.0, 0.0]) == Spread(0.5, 0.5, 0.5, 1)
    assert lost_in_noise([1.0, 0.0, 3.0], [2.0, 2.0, 0.0]).startswith("; 2 of 3 rounds")
    assert ratios([0.0], [1.0]) is None
    assert lost_in_noise([1.0], [1.0]) == ""


def test_a_difference_below_nothing_is_noise() -> None:
    """No millionth of a second, of which a ratio would be made."""
    assert _mean(Cost(1.0, 2.0), Cost(1.5, 1.0), 2) == Cost(0.0, 0.5)


def test_growth_is_fitted_to_what_was_measured() -> None:
    """A size whose rays were lost in the noise tells nothing of them."""
    sizes = tuple(
        Size(faces, faces / 1e6, faces / 1e6, faces / 1e6 if faces != 32_000 else 0.0, 1.0)
        for faces in (16_000, 32_000, 64_000)
    )
    grown = {each.what: each.exponent for each in scale.growths(sizes)}
    assert math.isclose(grown["rays"], 1.0)
    assert scale.growths(sizes[:1]) == ()


def test_rounds_belong_together() -> None:
    """A ratio of different numbers of rounds is no ratio."""
    with pytest.raises(ValueError, match="argument 2"):
        ratios([1.0, 2.0], [1.0])


@pytest.mark.parametrize("power", [0.0, 1.0, 1.5])
def test_an_exponent_is_found_again(power: float) -> None:
    """The factor does not matter."""
    sizes = [10.0, 100.0, 5000.0]
    assert math.isclose(
        exponent(sizes, [3 * size**power for size in sizes]), power, abs_tol=1e-9
    )
