"""Our own solution is asked once, and what it says is kept."""

import pytest

from grader import solution
from grader.oracle.plan import Plan
from grader.solution import Solution


@pytest.mark.usefixtures("cache")
def test_the_last_plans_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """A second submission finds the plan of its seed; the oldest plans go first."""
    drawn: list[int] = []

    def draw(seed: int, *_: object) -> Plan:
        drawn.append(seed)
        return Plan((), ((f"of {seed}", ""),))

    monkeypatch.setattr(solution, "kept_plan", draw)
    monkeypatch.setattr(solution, "_kept", {})
    monkeypatch.setattr(solution, "MOST_PLANS", 2)
    for seed in (1, 2, 1, 3, 2, 1):
        assert Solution().plan(seed).faults == ((f"of {seed}", ""),)
    assert drawn == [1, 2, 3, 1]
