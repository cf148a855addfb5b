"""Where the time of a grade went."""

import time
from functools import cache
from pathlib import Path

import pytest

from grader import pipeline
from grader.intake.locate import locate
from grader.model.stages import Rejected, Submission
from grader.options import Options
from grader.pipeline import grade_one
from grader.sandbox.box import Isolation
from grader.sandbox.selftest import unconfined


def test_the_whole_grade_is_timed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading and the proof of isolation count, though they take none of the student's time."""
    slept = 0.2

    @cache
    def proved() -> Isolation:
        time.sleep(slept)
        return unconfined()

    def read(path: Path, limit: int) -> Submission | Rejected:
        time.sleep(slept)
        return locate(path, limit)

    monkeypatch.setattr(pipeline, "proved_isolation", proved)
    monkeypatch.setattr(pipeline, "locate", read)
    (tmp_path / "nothing.cpp").touch()
    told: list[str] = []
    options = Options(41, None, (), lambda stage, *_: told.append(stage))
    spent = grade_one(tmp_path / "nothing.cpp", options).timing
    assert told == [name for name, _ in spent.stages] == ["intake", "isolation"]
    assert all(seconds >= slept for _, seconds in spent.stages)
    assert spent.total >= spent.grader >= sum(seconds for _, seconds in spent.stages)
