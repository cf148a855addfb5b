"""What every attack finds: a compiled framework, and bait of its own."""

from collections.abc import Generator
from pathlib import Path

import pytest

from grader.options import Options
from grader.pipeline import grade_one
from grader.resources import reference_source
from grader.solution import Solution
from tests.attacks.harness import SEED
from tests.attacks.witness import VARIABLE, Witness, witnessed


@pytest.fixture(scope="session")
def warm(cache: Path) -> None:
    """Compile the framework and the reference before any clock runs."""
    checks = ("build.compiles", "bvh.rebuild-starts-afresh")
    grade_one(reference_source(), Options(SEED, None, checks, lambda *_: None))
    Solution().plan(SEED)


@pytest.fixture
def witness(warm: None, monkeypatch: pytest.MonkeyPatch) -> Generator[Witness]:
    """Bait of its own for each attack, and a grader whose environment holds a secret."""
    with witnessed() as witness:
        monkeypatch.setenv(VARIABLE, witness.secret)
        monkeypatch.setenv("HOME", str(witness.root / "home"))
        yield witness
