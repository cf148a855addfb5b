"""What is known of a growing call graph is what would be found out of the whole one."""

import numpy as np
import pytest

from grader.verify import growing as module
from grader.verify.growing import Growing
from grader.verify.walks import Callees, reachable, reverse


def naive(callees: Callees, call: str, targets: set[str], builders: set[str]) -> bool:
    """Find out anew whether every target makes the call and builds."""
    callers = reverse(callees)
    recur, build = reachable(callers, [call]), reachable(callers, builders)
    return targets <= recur & build


@pytest.mark.parametrize("seed", range(40))
def test_what_grew_is_what_is_there(seed: int) -> None:
    """Calls are added in any order, those of builders and of those who call them included."""
    rng = np.random.default_rng(seed)
    names = [f"f{k}" for k in range(12)]

    def some(least: int, most: int) -> set[str]:
        return set(map(str, rng.choice(names, rng.integers(least, most + 1), replace=False)))

    callees: Callees = {name: some(0, 2) for name in names[:8]}
    builders = some(2, 2)
    growing = Growing(callees, builders)
    said = set()
    for _ in range(20):
        call, targets = min(some(1, 1)), some(1, 3)
        found = growing.all_recur(call, targets)
        assert found == naive(callees, call, targets, builders)
        said.add(found)
        growing.add(min(some(1, 1)), some(0, 2))
    assert said == {True, False} or seed


def test_a_graph_without_end_is_not_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Many pointers among many functions would take minutes; not to follow costs no point."""
    callees: Callees = {f"f{k}": {f"f{k + 1}"} for k in range(50)} | {"f50": {"f0", "node"}}
    growing = Growing(callees, {"node"})
    assert growing.all_recur("f50", {"f1", "f2"})
    monkeypatch.setattr(module, "MOST_STEPS", 60)
    assert not growing.all_recur("f50", {"f1", "f2"})
