"""A failure of our own before anything foreign ran is tried again, and never a submission's."""

import signal
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from subprocess import Popen

import pytest

from grader.errors import MissingTool, WorkerFault
from grader.run.job import Job
from grader.run.session import Engine, run_job
from grader.sandbox import confine, kept, launch, nursery, words
from grader.sandbox.box import Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.launch import Order, begin
from grader.sandbox.stage import staged
from grader.sandbox.target import ATTEMPTS, Target
from tests.compiled import PATIENT, engine_of
from tests.sandbox.boxes import SNIPPET, WORKER_BOUNDS, as_worker


@pytest.fixture
def launches(monkeypatch: pytest.MonkeyPatch) -> list[Order]:
    """List the processes that are started from now on."""
    seen: list[Order] = []

    def counted(order: Order) -> Popen[bytes]:
        seen.append(order)
        return begin(order)

    monkeypatch.setattr(nursery, "begin", counted)
    monkeypatch.setattr(launch, "begin", counted)
    return seen


def spoil(monkeypatch: pytest.MonkeyPatch, times: int) -> None:
    """Let the first processes fail to confine themselves."""
    real, left = words.specification, [True] * times

    def spoiled(box: Box, isolation: Isolation, waits: bool) -> Iterator[str]:
        yield from real(box, isolation, waits)
        if left:
            left.pop()
            yield "file=many"

    for module in (confine, kept):
        monkeypatch.setattr(module, "specification", spoiled)


def test_one_failure_is_forgiven(
    isolation: Isolation, monkeypatch: pytest.MonkeyPatch, launches: list[Order]
) -> None:
    """The second attempt counts."""
    spoil(monkeypatch, 1)
    outcome = as_worker(isolation, "print('reached')")
    assert (outcome.code, outcome.out, len(launches)) == (0, b"reached\n", 2)


def test_two_failures_are_our_fault(
    isolation: Isolation, monkeypatch: pytest.MonkeyPatch, launches: list[Order]
) -> None:
    """The sentence has the level and the last words of our own part."""
    spoil(monkeypatch, 2)
    with pytest.raises(WorkerFault) as caught:
        as_worker(isolation, "print('reached')")
    assert len(launches) == ATTEMPTS == 2
    text = str(caught.value)
    assert text.startswith(f"a process could not be confined ({isolation.level.value}): ")
    assert "many" in text
    assert len(text) < 700


def test_a_file_of_ours_that_is_missing_is_our_fault(
    isolation: Isolation, open_folder: Path
) -> None:
    """So is a target that is none of our modules."""
    entry = open_folder / "start.py"
    target = Target("snippet", [], 60.0, 4096)
    with pytest.raises(WorkerFault, match=r"start\.py"):
        confined(target, Box((open_folder,), WORKER_BOUNDS), entry, isolation)
    staged_entry = staged(SNIPPET)
    missing = replace(target, program="no_such_module")
    with pytest.raises(WorkerFault, match="no_such_module"):
        confined(missing, Box((staged_entry.parent,), WORKER_BOUNDS), staged_entry, isolation)


def test_an_interpreter_that_is_missing_is_said(isolation: Isolation) -> None:
    """Nothing is concluded about the submission."""
    gone = replace(isolation, interpreter=Path("/no/such/python"))
    with pytest.raises((MissingTool, WorkerFault), match="/no/such/python"):
        as_worker(gone, "pass")


@pytest.mark.usefixtures("cache")
def test_a_worker_of_ours_that_fails_ends_the_grade(
    isolation: Isolation, monkeypatch: pytest.MonkeyPatch, open_folder: Path
) -> None:
    """`run_job` passes it on as what it is: no ending is made of it."""
    engine: Engine = replace(engine_of(open_folder / "none.so"), isolation=isolation)
    spoil(monkeypatch, 2)
    with pytest.raises(WorkerFault):
        run_job(Job(), engine, PATIENT)


@pytest.mark.parametrize(
    ("code", "status"),
    [
        ("os._exit(0)", 0),
        ("os._exit(1)", 1),
        ("os.kill(os.getpid(), 9)", -signal.SIGKILL),
        ("raise OSError('bwrap: no')", 1),
        ("os.closerange(0, 64); os._exit(1)", 1),
    ],
)
def test_what_runs_inside_cannot_pretend_to_be_our_fault(
    isolation: Isolation, launches: list[Order], code: str, status: int
) -> None:
    """Whatever it does at once, it was reached, and is not run a second time."""
    assert as_worker(isolation, code).code == status
    assert len(launches) == 1
