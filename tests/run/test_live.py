"""A process that stays: it traces batch after batch, and can be ended at any time."""

import time
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from grader.model.mesh import Rays
from grader.model.stages import Stop
from grader.run.job import Job
from grader.run.live import Live
from grader.run.protocol import Op
from grader.run.session import Engine, run_job
from grader.run.transfer import give_mesh, ray_table, read_tree, trace
from tests.compiled import PATIENT
from tests.verify.builder import soup

MESH = soup(60)
COUNT = 200


def rays() -> Rays:
    """Aim at faces from one side."""
    target = MESH.vertices[MESH.faces[np.arange(COUNT) % 60]].mean(axis=1)
    origin = np.tile(np.array([[-5.0, 0.1, 0.2]], np.float32), (COUNT, 1))
    zeros = np.zeros(COUNT, np.float32)
    return Rays(origin, target - origin, zeros, zeros + np.float32(np.inf))


@pytest.fixture
def live(reference: Engine) -> Iterator[Live]:
    """Start one, and wait until it has its tree."""
    job = Job()
    slot = give_mesh(job, MESH)
    job.do(Op.CONSTRUCT, slot, slot)
    read_tree(job, slot, MESH)
    made = Live(job, slot, reference, COUNT)
    wait(made, lambda: made.is_ready)
    yield made
    made.close()


def wait(live: Live, holds: Callable[[], bool]) -> None:
    """Look until something holds."""
    end = time.monotonic() + 240
    while not holds():
        assert time.monotonic() < end
        live.look()
        time.sleep(0.002)


def test_batches_bring_what_one_job_brings(live: Live, reference: Engine) -> None:
    """The same hits and the same counts, whatever the size of a batch."""
    table = ray_table(rays())
    for first in range(0, COUNT, 30):
        live.trace(table[first : first + 30], first)
    wait(live, lambda: live.rays_done() == COUNT)
    hits, tests = live.hits(0, COUNT)
    job = Job()
    slot = give_mesh(job, MESH)
    job.do(Op.CONSTRUCT, slot, slot)
    read = trace(job, slot, rays())
    _, result = run_job(job, reference, PATIENT)
    assert result is not None
    once = read(result)
    assert (hits[:, 3] == once.hits[0].t).all()
    assert (tests == once.counts).all()
    assert live.construct_seconds > 0
    assert live.trace_seconds > 0


def test_a_turn_that_is_over_is_skipped(live: Live) -> None:
    """What was asked for before it is dropped, and the next turn counts from the start."""
    table = ray_table(rays())
    live.trace(table, 0)
    live.turn()
    wait(live, lambda: not live.is_busy)
    live.clear()
    assert live.rays_done() == 0
    live.trace(table[:7], 0)
    wait(live, lambda: not live.is_busy)
    assert live.rays_done() == 7


def test_the_way_of_a_ray_is_told(live: Live) -> None:
    """Also while other rays are on their way."""
    table = ray_table(rays())
    live.trace(table, 0)
    row = live.record(table[3])
    wait(live, lambda: live.rows_done > row)
    walk = live.walk()
    assert walk.total == len(walk.is_box) > 0
    assert walk.node[0] == 0


def test_it_ends_when_it_is_told_to(live: Live) -> None:
    """At once, and nothing of it is left."""
    live.close()
    assert not live.is_running
    assert live.ending is not None
    assert live.ending.stop is Stop.TIMED_OUT
    assert live.fault is None


def test_a_counter_that_flips_only_grows(live: Live, monkeypatch: pytest.MonkeyPatch) -> None:
    """The submission can write it: what was done stays done, and no more than was asked for."""
    live.trace(ray_table(rays()), 0)
    said = iter([2**60, 0, 2**63, 0])  # each look takes one
    counted = live.result.number
    monkeypatch.setattr(
        live.result, "number", lambda at: next(said) if at == 16 else counted(at)
    )
    live.look()
    done = live.rows_done
    assert not live.is_busy
    live.clear()
    live.look()
    assert live.rows_done == done
    assert live.record(ray_table(rays())[0]) == done
    live.look()
    assert live.rows_done == done + 1
    live.look()
    assert live.rows_done == done + 1


def test_two_rays_that_wait_stay_two(live: Live) -> None:
    """The second does not take the place of the first, whose row has not been reached."""
    table = ray_table(rays())
    one, other = live._room.ray, live._first_rows
    rows = [live.record(table[0]), live.record(table[1])]
    assert rows == [other, other + 1]
    wait(live, lambda: live.rows_done > rows[-1])
    kept = live.result.array(one + other * 32, 16, np.float32).reshape(2, 8)
    assert (kept == table[:2]).all()
