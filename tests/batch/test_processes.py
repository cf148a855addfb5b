"""A class as a whole process: killed, interrupted, and started twice."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.batch.classes import CODE, folder_of, points
from tests.batch.stand_in import LOG, begun, taken_up
from tests.cli.test_processes import environment

PATIENCE = 300.0


def started(path: Path, log: Path, *where: str) -> subprocess.Popen[bytes]:
    """Begin to grade a class in a process of its own."""
    program = [sys.executable, "-m", "tests.batch.stand_in"]
    words = [*program, str(path), str(log.parent / "out"), *where]
    given = environment(**{LOG: str(log), "PYTHONWARNINGS": "ignore"})
    return subprocess.Popen(words, env=given, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def until(claim: Callable[[], bool]) -> None:
    """Wait until something is so."""
    deadline = time.monotonic() + PATIENCE
    while not claim():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.02)


@contextmanager
def waiting(tmp_path: Path, log: Path) -> Iterator[tuple[Path, subprocess.Popen[bytes]]]:
    """A class of three, of which the second one never ends, once it is being graded."""
    (tmp_path / "out").mkdir()
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "wait", "cy.cpp": "c"})
    process = started(path, log)
    try:
        until(lambda: "wait" in begun(log) and len(points(tmp_path / "out")) == 2)
        yield path, process
    finally:
        process.kill()
        process.communicate()


def clerks_of(log: Path) -> list[int]:
    """Processes that grade for a test."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
                given = (entry / "environ").read_bytes().split(b"\0")
            except OSError:
                continue
            if b"grader.sandbox.clerk" in words and f"{LOG}={log}".encode() in given:
                found.append(int(entry.name))
    return found


def finish(path: Path, log: Path) -> tuple[int, bytes]:
    """Give the same command again, after the one that never ended was mended."""
    (path / "bob.cpp").write_text("b")
    process = started(path, log)
    _, said = process.communicate(timeout=PATIENCE)
    return process.returncode, said


def test_a_killed_batch_goes_on_where_it_was(tmp_path: Path, log: Path) -> None:
    """`kill -9` costs what was being graded, and its clerks end too."""
    with waiting(tmp_path, log) as (path, process):
        process.kill()
        process.wait()
        until(lambda: not clerks_of(log))
    status, said = finish(path, log)
    assert status == 0, said
    assert points(tmp_path / "out") == {"ada": 50, "bob": 50, "cy": 50}
    assert sorted(begun(log)) == sorted([CODE.strip(), "b", "c", "wait"])


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_batch_keeps_what_is_done(
    tmp_path: Path, log: Path, number: signal.Signals
) -> None:
    """It leaves a table, no process and no traceback."""
    with waiting(tmp_path, log) as (path, process):
        process.send_signal(number)
        _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 128 + number
    assert b"goes on" in said
    assert b"Traceback" not in said
    assert clerks_of(log) == []
    table = (tmp_path / "out/class.csv").read_text()
    assert "students/ada" in table
    assert "students/bob" not in table
    assert finish(path, log)[0] == 0


def kill_and_see(processes: set[int]) -> None:
    """Kill some processes, and wait until who started them has seen that they ended."""
    for process in processes:
        os.kill(process, signal.SIGKILL)
    until(lambda: not any(Path(f"/proc/{process}").exists() for process in processes))


def test_a_killed_clerk_costs_one_try(tmp_path: Path, log: Path) -> None:
    """As the kernel does it when memory runs out; twice, and the submission is withheld."""
    with waiting(tmp_path, log) as (_, process):
        for tries in (1, 2):
            until(lambda tries=tries: begun(log).count("wait") == tries)  # type: ignore[misc]  # bound here
            busy = [clerk for clerk, text in taken_up(log) if text == "wait"][-1]
            # The other one is free: its death costs nobody a try. First, and until it is gone:
            # it would get the order of the busy one, and then it dies over that.
            kill_and_see(set(clerks_of(log)) - {busy})
            os.kill(busy, signal.SIGKILL)
        _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 3
    assert b"SIGKILL" in said
    assert points(tmp_path / "out") == {"ada": 50, "bob": None, "cy": 50}


def test_two_batches_do_not_meet(tmp_path: Path, log: Path) -> None:
    """The second one says so; the first one goes on."""
    with waiting(tmp_path, log) as (path, process):
        second = started(path, log)
        _, said = second.communicate(timeout=PATIENCE)
        assert second.returncode != 0
        assert b"another batch" in said
        assert process.poll() is None
