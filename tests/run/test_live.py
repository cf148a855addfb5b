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
    wait(lambda: made.is_ready)
    yield made
    made.close()


def wait(holds: Callable[[], bool]) -> None:
    """Wait until something holds."""
    end = time.monotonic() + 240
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.002)


def test_batches_bring_what_one_job_brings(live: Live, reference: Engine) -> None:
    """The same hits and the same counts, whatever the size of a batch."""
    table = ray_table(rays())
    for first in range(0, COUNT, 30):
        live.trace(table[first : first + 30], first)
    wait(lambda: live.rays_done() == COUNT)
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
    wait(lambda: not live.is_busy)
    live.clear()
    assert live.rays_done() == 0
    live.trace(table[:7], 0)
    wait(lambda: not live.is_busy)
    assert live.rays_done() == 7


def test_the_way_of_a_ray_is_told(live: Live) -> None:
    """Also while other rays are on their way."""
    table = ray_table(rays())
    live.trace(table, 0)
    row = live.record(table[3])
    wait(lambda: live.rows_done > row)
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
