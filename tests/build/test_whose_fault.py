"""A file that compiles late, or not at all: is that its own fault, or the machine's?"""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.build import compile, compiling
from grader.errors import BuildFault
from grader.model.stages import Further
from grader.sandbox.box import Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.launch import Outcome
from grader.sandbox.target import Target
from tests.build.compilers import errors
from tests.compiled import (
    BEGIN,
    STARTER,
    partial_build,
    whole_build,
)


@pytest.mark.parametrize(("delayed", "ours"), [(0.0, False), (20.0, False), (40.0, True)])
def test_a_compiler_that_stood_in_line_is_no_fault_of_the_submission(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, delayed: float, ours: bool
) -> None:
    """Of 60 s by the clock it had more than its 30 s of computing, or it had not."""
    late = Outcome(-9, True, b"", b"", 60.0, 0.0, delayed)
    monkeypatch.setattr(compiling, "confined", lambda *_: late)
    if ours:
        with pytest.raises(BuildFault, match="stood in line for a processor"):
            whole_build(BEGIN, tmp_path)
    else:
        (error, *_) = errors(whole_build(BEGIN, tmp_path))
        assert error.text == "compiling took longer than 60 s"


def test_a_compiler_that_stood_in_line_is_tried_alone(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else whoever compiles for ever would never be graded in half a processor's container."""
    given: list[float] = []

    def slow(target: Target, *_: object) -> Outcome:
        given.append(target.seconds)
        return Outcome(-9, True, b"", b"", target.seconds, 0.0, 0.7 * target.seconds)

    monkeypatch.setattr(compiling, "confined", slow)
    (error, *_) = errors(whole_build(BEGIN + "// for ever\n", tmp_path))
    assert error.text == "compiling took longer than 60 s"
    assert sorted(set(given)) == [60.0, 120.0]


FULL = Outcome(1, False, b"", b"as: No space left on device\n", 0.1, 0.1)


def test_a_machine_that_compiles_nothing_is_no_fault_of_the_submission(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No line of the file is named, and our own solution fails in the same way."""
    monkeypatch.setattr(compiling, "confined", lambda *_: FULL)
    with pytest.raises(BuildFault, match="our own solution either: as: No space left"):
        whole_build(STARTER.read_text() + "// never compiled before\n", tmp_path)


@pytest.mark.parametrize(("stands", "own"), [(0.0, 62.5), (20.0, 42.5)])
def test_what_compilers_computed_is_told_apart_from_standing_in_line(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, stands: float, own: float
) -> None:
    """One takes 2.5 s of a processor, one is ended after a minute; what is kept takes none."""
    late = Outcome(-9, True, b"", b"", 60.0, 0.0, stands)

    def slow(target: Target, box: Box, entry: Path, isolation: Isolation) -> Outcome:
        if "-S" in target.arguments:
            return late
        return replace(confined(target, box, entry, isolation), cpu_seconds=2.5)

    monkeypatch.setattr(compiling, "confined", slow)
    monkeypatch.setattr(compile, "_blame", lambda *_: None)
    source = STARTER.read_text() + f"// never timed before, {stands}\n"
    assert partial_build(source, tmp_path, Further.CALLS).own_seconds == own
    assert partial_build(source, tmp_path / "again").own_seconds == 0.0


@pytest.mark.parametrize("ours", [True, False])
def test_a_machine_that_lists_no_calls_is_no_fault_of_the_submission(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ours: bool
) -> None:
    """The disk is full when the calls are listed, for everybody or for this submission only."""
    starts = confined
    listed: list[Path] = []

    def full(target: Target, box: Box, entry: Path, isolation: Isolation) -> Outcome:
        if "-S" not in target.arguments:
            return starts(target, box, entry, isolation)
        listed.append(target.folder or tmp_path)
        return FULL if ours or len(listed) == 1 else starts(target, box, entry, isolation)

    monkeypatch.setattr(compiling, "confined", full)
    source = STARTER.read_text() + f"// never listed before, {ours}\n"
    if ours:
        with pytest.raises(BuildFault, match="our own solution either: as: No space left"):
            partial_build(source, tmp_path, Further.CALLS)
    else:
        build = partial_build(source, tmp_path, Further.CALLS)
        assert build.library
        assert build.calls is None
    assert len(set(listed)) == 2
