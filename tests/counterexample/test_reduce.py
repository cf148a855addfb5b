"""Sets become small, in few rounds, and in the same way every time."""

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.counterexample.reduce import reduced
from grader.model.mesh import Integers


class Asked:
    """Counts the rounds and keeps every subset that was tried."""

    def __init__(self, fails: Callable[[set[int]], bool]) -> None:
        self.rounds: list[list[Integers]] = []
        self._fails = fails

    def __call__(self, subsets: Sequence[Integers]) -> int | None:
        """Answer as a probe does."""
        self.rounds.append(list(subsets))
        for number, one in enumerate(subsets):
            if self._fails(set(one.tolist())):
                return number
        return None


@settings(max_examples=15)
@given(st.sets(st.integers(0, 199), min_size=1, max_size=6))
def test_what_is_needed_is_all_that_is_left(needed: set[int]) -> None:
    """Of 200 items those few are found on which it depends."""
    asked = Asked(lambda some: needed <= some)
    left = reduced(np.arange(200), asked, 100, 60)
    assert set(left.tolist()) == needed


@pytest.mark.parametrize("count", [1, 5, 9, 37, 600, 100_000])
def test_a_number_of_items_is_found_in_the_first_round(count: int) -> None:
    """Where any five items do, five are left, whatever they were taken from."""
    asked = Asked(lambda some: len(some) >= min(5, count))
    left = reduced(np.arange(count), asked, 60, 6)
    assert left.size == min(5, count)
    assert all(len(tried) <= 60 for tried in asked.rounds)


def test_proposals_are_sorted_and_smaller_and_not_made_twice() -> None:
    """Each round begins with the smallest, none is as large as what is known."""
    asked = Asked(lambda some: {3, 50} <= some)
    reduced(np.arange(64), asked, 100, 6, np.array([50, 3]))
    known = 64
    for tried in asked.rounds:
        sizes = [one.size for one in tried]
        assert sizes == sorted(sizes)
        assert max(sizes) < known
        assert len({one.tobytes() for one in tried}) == len(tried)
        assert all((np.diff(one) > 0).all() for one in tried)
        known = min([one.size for one in tried if {3, 50} <= set(one.tolist())], default=known)


def test_what_leads_is_tried_first() -> None:
    """Items that probably matter are in the smallest subsets."""
    asked = Asked(lambda some: {17, 99} <= some)
    assert reduced(np.arange(5000), asked, 40, 1, np.array([99, 17])).tolist() == [17, 99]


def test_what_cannot_be_reduced_stays() -> None:
    """Nothing smaller fails: all items are left, and no subset is tried for ever."""
    asked = Asked(lambda some: len(some) == 37)
    assert reduced(np.arange(37), asked, 100, 60).size == 37
    assert len(asked.rounds) < 6


def test_two_reductions_are_the_same() -> None:
    """Nothing depends on the clock or on chance."""
    one, other = (Asked(lambda some: sum(some) % 7 == 3) for _ in range(2))
    assert (reduced(np.arange(90), one, 50, 6) == reduced(np.arange(90), other, 50, 6)).all()
    for mine, yours in zip(one.rounds, other.rounds, strict=True):
        assert [each.tolist() for each in mine] == [each.tolist() for each in yours]
