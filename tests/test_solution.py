"""Our own solution is asked once, and what it says is kept."""

from pathlib import Path

import pytest

from grader import solution
from grader.errors import WorkerFault
from grader.oracle.plan import Plan
from grader.run.session import Engine
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.selftest import proved_isolation
from grader.score.rubric import load_rubric
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


@pytest.mark.usefixtures("cache")
def test_our_own_solution_vouches_for_the_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where it cannot be loaded either, nobody is blamed for that."""
    with scratch_folder() as folder:
        engine = Engine(folder / "graded.so", load_rubric().limits, proved_isolation())
        ours = Solution()
        ours.vouch(engine)
        monkeypatch.setattr("shutil.copyfile", lambda _, to: Path(to).write_bytes(b""))
        with pytest.raises(WorkerFault, match="set TMPDIR to a folder from which"):
            ours.vouch(engine)
