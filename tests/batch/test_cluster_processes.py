"""The machines of a cluster end as the command itself may: at once, in the middle."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.batch.classes import CODE, comparable, folder_of, points
from tests.batch.clusters import PATIENCE, Machines, Process, machines
from tests.batch.processes import descendants, named
from tests.batch.stand_in import LOG, begun
from tests.batch.test_command import RIGHT, WRONG, batch, typed
from tests.batch.test_processes import clerks_of, started, until

pytestmark = pytest.mark.xdist_group("cluster-processes")

ALL = {"ada": 50, "bob": 50, "cy": 50}


@contextmanager
def waiting(
    tmp_path: Path, log: Path, text: str = "wait once"
) -> Iterator[tuple[Machines, Process, Path]]:
    """A class of three, graded by one worker, which waits over the second one."""
    (tmp_path / "out").mkdir()
    given = {"ada.cpp": CODE, "bob.cpp": text, "cy.cpp": "c"}
    path = folder_of(tmp_path, "class", given)
    with machines(tmp_path / "machines", 1, **{LOG: str(log)}) as cluster:
        process = started(path, log, cluster.address)
        try:
            until(lambda: text in begun(log) and "ada" in points(tmp_path / "out"))
            yield cluster, process, path
        finally:
            process.kill()
            process.communicate()


def ended(process: Process) -> tuple[int, str]:
    """Wait for the end of a command."""
    _, said = process.communicate(timeout=PATIENCE)
    assert b"Traceback" not in said
    return process.returncode, said.decode()


def test_a_killed_worker_costs_nothing(tmp_path: Path, log: Path) -> None:
    """Another one does what it was doing, and nothing else again."""
    with waiting(tmp_path, log) as (cluster, process, _):
        cluster.hire()
        cluster.workers[0].kill()
        status, said = ended(process)
    assert status == 0, said
    assert points(tmp_path / "out") == ALL
    counts = {text: begun(log).count(text) for text in (CODE.strip(), "wait once", "c")}
    assert counts == {CODE.strip(): 1, "wait once": 2, "c": 1}
    until(lambda: not clerks_of(log))


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_command_that_ended_goes_on(
    tmp_path: Path, log: Path, number: signal.Signals
) -> None:
    """The cluster is still there, and does what was under way once more."""
    with waiting(tmp_path, log) as (cluster, process, path):
        process.send_signal(number)
        status, said = ended(process)
        assert status in (-number, 128 + number)
        assert ("goes on" in said) == (number == signal.SIGINT)
        # The first worker waits for ever over what nobody wants to know any more.
        cluster.hire()
        cluster.workers[0].kill()
        status, said = ended(started(path, log, cluster.address))
    assert status == 0, said
    assert points(tmp_path / "out") == ALL


def test_a_lost_scheduler_ends_the_command(tmp_path: Path, log: Path) -> None:
    """What was graded is kept, and the same command goes on with another cluster."""
    with waiting(tmp_path, log) as (cluster, process, path):
        assert cluster.scheduler is not None
        cluster.scheduler.kill()
        status, said = ended(process)
        assert status == 3
        assert "does not answer any more" in said
        assert "the same command goes on" in said
        assert (tmp_path / "out/class.csv").exists()
        kept = points(tmp_path / "out")
        assert set(kept) < set(ALL)
        # The first worker waits for ever for a scheduler that is gone.
        cluster.workers[0].kill()
        cluster.begin()
        cluster.hire()
        status, said = ended(started(path, log, cluster.address))
    assert status == 0, said
    assert points(tmp_path / "out") == ALL
    assert begun(log).count(CODE.strip()) == 1


def test_real_submissions_get_the_same_grade(tmp_path: Path, cache: Path) -> None:
    """One right, one wrong, one that does not compile; one of two workers dies over them."""
    given = {
        "Ada Lovelace_11_assignsubmission_file/exercise03.cpp": RIGHT,
        "Ben Berg_12_assignsubmission_file/mine.cpp": WRONG,
        "Cy Clo_13_assignsubmission_file/exercise03.cpp": b"int main() {",
    }
    path = folder_of(tmp_path, "class", given)
    near = batch(path, "-o", tmp_path / "near", cache=cache)
    assert near.returncode == 0, near.stderr
    with machines(tmp_path / "machines", BVHGRADE_CACHE=str(cache)) as cluster:
        where = ("--scheduler", cluster.address)
        process = typed(path, "-o", tmp_path / "far", *where, cache=cache)
        first = cluster.workers[0]
        until(lambda: bool(named("grader.sandbox.clerk", descendants(first.pid))))
        first.kill()
        status, said = ended(process)
    assert status == 0, said
    assert "workers 2, submissions at a time 2" in said
    assert comparable(tmp_path / "far") == comparable(tmp_path / "near")
