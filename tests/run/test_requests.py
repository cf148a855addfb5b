"""What a worker delivers for each kind of trial, with the model solution and a counting one."""

import os
from pathlib import Path

import numpy as np
import pytest

from grader.model.cases import (
    AlteredCase,
    DepthCase,
    HitCase,
    ImageCase,
    RebuildCase,
    RepeatCase,
    TreeCase,
    WorkCase,
)
from grader.model.mesh import Bvh, Hits, Mesh, Rays
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial, RebuildTrial, Trial, WorkTrial
from grader.run import session, transfer
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.requests import request
from grader.run.session import Engine, run_job
from grader.run.transfer import (
    give_mesh,
    give_tree,
    read_mesh,
    read_tree,
    replace_mesh,
    trace,
)
from tests.compiled import PATIENT
from tests.verify.builder import altered, build, failed, mesh_of, soup
from tests.verify.trials import every_trial

COUNT = 50


def rays(seed: int = 5) -> Rays:
    """Make rays from outside through the soup."""
    rng = np.random.default_rng(seed)
    origin = rng.normal(size=(COUNT, 3)).astype(np.float32) * 9
    direction = rng.uniform(-3, 3, (COUNT, 3)).astype(np.float32) - origin
    return Rays(
        origin, direction, np.zeros(COUNT, np.float32), np.full(COUNT, np.inf, np.float32)
    )


def delivered(trial: Trial, engine: Engine) -> tuple[Ending, object]:
    """Run a trial; its last ending and its only case, None if it delivers none."""
    asked = request(trial)
    results = []
    for job in asked.jobs:
        ending, result = run_job(job, engine, PATIENT)
        assert result, ending
        results.append(result)
    return ending, next(iter(asked.read(results, ending)), None)


@pytest.mark.parametrize("faces", [0, 1, 4, 5, 37, 600])
def test_a_tree_comes_back_as_it_was_built(reference: Engine, faces: int) -> None:
    """The model solution's trees pass every check after their way through the files."""
    mesh = soup(faces)
    _, case = delivered(ConstructTrial("soup", mesh), reference)
    assert isinstance(case, TreeCase)
    assert failed(mesh, case.bvh) == set()
    assert case.bvh.node_count == len(case.bvh.end)
    assert not case.bvh.low.flags.writeable


@pytest.mark.parametrize(
    ("faces", "sanitized", "kinds"),
    [
        (256, True, set()),
        (257, True, {DepthCase, TreeCase}),
        (257, False, {TreeCase}),
    ],
)
def test_trees_at_the_small_limit_are_looked_at_twice(
    reference: Engine, faces: int, sanitized: bool, kinds: set[type]
) -> None:
    """For their depth and like any other; smaller ones of that build for memory only."""
    asked = request(ConstructTrial("soup", soup(faces), sanitized))
    ((ending, result),) = (run_job(job, reference, PATIENT) for job in asked.jobs)
    assert result
    assert {type(case) for case in asked.read([result], ending)} == kinds


@pytest.mark.parametrize("tree", [build(soup(37)), build(mesh_of(np.zeros((0, 3, 3))))])
def test_a_tree_of_ours_is_set_bit_for_bit(reference: Engine, tree: Bvh) -> None:
    """Not-a-number, negative zero and numbers out of range go in and come out unchanged."""
    odd = tree.low.copy()
    odd[0] = np.array([0x7FC12345, 0x80000000, 0x00000001], np.uint32).view(np.float32)
    given = altered(tree, low=odd, begin=tree.begin + 7)
    job, mesh = Job(), soup(37)
    slot = give_mesh(job, mesh)
    give_tree(job, slot, given)
    read = read_tree(job, slot, mesh)
    _, result = run_job(job, reference, PATIENT)
    assert result
    back = read(result)
    for name in ("low", "high", "begin", "end", "order"):
        mine, yours = getattr(given, name), getattr(back, name)
        assert mine.tobytes() == yours.tobytes()
        assert mine.shape == yours.shape


@pytest.mark.parametrize("nodes", [0, 1, 5, 12])
def test_nodes_are_laid_out_as_in_the_library(
    nodes: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Six coordinates and a range for each node, in blocks that do and do not fit."""
    monkeypatch.setattr(transfer, "BLOCK", 5)
    rng = np.random.default_rng(nodes)
    corners = rng.normal(size=(nodes, 6)).astype(np.float32)
    begin, end = ends = rng.integers(1 << 32, size=(2, nodes), dtype=np.uint32)
    job = Job()
    give_tree(job, 0, Bvh(corners[:, :3], corners[:, 3:], begin, end, end, nodes))
    with job.files() as (given, _):
        content = os.pread(given, 1 << 16, 0)
    table = np.concatenate([corners.view(np.uint32), ends.T], axis=1)
    assert np.ascontiguousarray(table).tobytes() in content


def test_a_tree_that_is_too_large_is_cut_and_counted(reference: Engine) -> None:
    """No more is read than was reserved, and the true number of nodes is told."""
    mesh, count = soup(2), 5000
    zeros = np.zeros((count, 3), np.float32)
    ends = np.arange(count, dtype=np.uint32)
    big = Bvh(zeros, zeros, ends, ends, np.arange(99, dtype=np.uint32), count)
    job = Job()
    slot = give_mesh(job, mesh)
    give_tree(job, slot, big)
    read = read_tree(job, slot, mesh)
    _, result = run_job(job, reference, PATIENT)
    assert result
    back = read(result)
    assert (len(back.end), back.node_count, len(back.order)) == (1024, count, 3)
    assert (back.end == ends[:1024]).all()
    assert back.order.tolist() == [0, 1, 2]


def test_a_rebuild_gives_seven_trees_and_both_meshes(reference: Engine) -> None:
    """Each tree belongs to its mesh, and the meshes come back byte for byte."""
    first, second = soup(37), soup(12, seed=9)
    _, case = delivered(RebuildTrial("rebuild", first, second), reference)
    assert isinstance(case, RebuildCase)
    assert [mesh is first for _, mesh, _ in case.trees] == [
        True,
        True,
        False,
        False,
        True,
        False,
        False,
    ]
    for _, mesh, bvh in (*case.trees, ("alone", second, case.alone)):
        assert failed(mesh, bvh) == set()
    for _, given, after in case.meshes:
        assert given.vertices.tobytes() == after.vertices.tobytes()
        assert given.faces.tobytes() == after.faces.tobytes()


def test_a_mesh_is_replaced_where_it_lies(reference: Engine) -> None:
    """The slot holds the other mesh then, and no tree."""
    first, second = soup(37), soup(12, seed=9)
    job = Job()
    slot = give_mesh(job, first)
    job.do(Op.CONSTRUCT, slot, slot)
    replace_mesh(job, slot, second)
    tree, mesh = read_tree(job, slot, second), read_mesh(job, slot, second)
    ending, result = run_job(job, reference, PATIENT)
    assert result, ending
    assert tree(result).node_count == 0
    assert mesh(result).vertices.tobytes() == second.vertices.tobytes()
    assert mesh(result).faces.tobytes() == second.faces.tobytes()


def test_every_kind_of_trial_comes_back(reference: Engine) -> None:
    """Small trials of each kind finish, and deliver cases of their kind."""
    kinds = set()
    for trial in every_trial():
        _, case = delivered(trial, reference)
        kinds.add(type(case))
    assert kinds - {type(None)} == {
        AlteredCase, DepthCase, HitCase, ImageCase, RebuildCase, RepeatCase, TreeCase, WorkCase
    }  # fmt: skip


def traced(
    engine: Engine, mesh: Mesh, threads: int = 1
) -> tuple[tuple[Hits, ...], tuple[float, float]]:
    """Trace the rays on our tree."""
    job = Job()
    slot = give_mesh(job, mesh)
    give_tree(job, slot, build(mesh))
    read = trace(job, slot, rays(), threads)
    ending, result = run_job(job, engine, PATIENT)
    assert result, ending
    found = read(result)
    return found.hits, found.tests


def test_every_thread_brings_its_own_hits(reference: Engine) -> None:
    """Hits of several threads are those of one, bit for bit."""
    mesh = soup(200)
    (alone,), _ = traced(reference, mesh)
    together, _ = traced(reference, mesh, threads=3)
    assert len(together) == 3
    assert 0 < np.isfinite(alone.t).sum() < COUNT
    for hits in together:
        for name in ("point", "t", "normal"):
            assert getattr(hits, name).tobytes() == getattr(alone, name).tobytes()


@pytest.mark.parametrize("threads", [1, 2])
def test_rays_and_hits_are_laid_out_field_by_field(
    hostile: tuple[Engine, Engine], threads: int
) -> None:
    """A library that answers with the ray itself shows that no field is exchanged."""
    mesh = soup(30)
    found, tests = traced(hostile[0], mesh, threads)
    for hits in found:
        assert (hits.point == rays().origin).all()
        assert set(hits.t.tolist()) == {0.0, 100.0}
    # The second box test is only made if the first one hits.
    assert tests == pytest.approx((1 + np.mean(found[0].t == 100), 1))


def test_no_rays_are_no_work(reference: Engine) -> None:
    """An empty batch gives empty hits and no tests."""
    job, none = Job(), np.zeros((0, 3), np.float32)
    slot = give_mesh(job, soup(9))
    read = trace(job, slot, Rays(none, none, none[:, 0], none[:, 0]))
    _, result = run_job(job, reference, PATIENT)
    assert result
    assert read(result).tests == (0.0, 0.0)
    assert read(result).hits[0].t.shape == (0,)


def test_work_is_measured_from_outside(reference: Engine) -> None:
    """Processor time is that of the worker's process, and tests are a plausible number."""
    mesh = soup(600)
    trial = WorkTrial("work", mesh, build(mesh), rays(), 1.0, 1.0)
    ending, case = delivered(trial, reference)
    assert isinstance(case, WorkCase)
    assert case.cpu_seconds == ending.cpu_seconds > 0
    assert 1 < case.box_tests < 600
    assert case.triangle_tests < 300


def test_the_worker_sees_no_answer_and_loads_no_arrays(
    tmp_path: Path, reference: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Arguments, environment and input of a worker hold data, no names, seeds or answers."""
    real, *others = session.MODULES
    spy = tmp_path / real.name
    spy.write_text(
        real.read_text()
        + """
import sys

carry_on = main


def main(arguments):
    print(sys.argv, dict(os.environ), os.pread(int(arguments[1]), 1 << 20, 0))
    os._exit = lambda code: print(sorted(sys.modules), flush=True)
    carry_on(arguments)
"""
    )
    monkeypatch.setenv("SECRET_TOKEN", "token of ours")
    monkeypatch.setattr(session, "MODULES", (spy, *others))
    asked = request(ConstructTrial("secret name of the trial", soup(9)))
    ending, _ = run_job(asked.jobs[0], reference, PATIENT)
    assert ending.stop is Stop.FINISHED, ending
    assert "'ctypes'" in ending.output
    for word in ("numpy", "grader.", "secret", "SECRET", "seed", "bvh.", "hits.", "HOME"):
        assert word not in ending.output


def test_operations_in_the_wrong_order_are_no_crash_of_ours(reference: Engine) -> None:
    """A row that names no slot ends the worker with a status, and the grader lives."""
    job = Job()
    job.do(Op.CONSTRUCT, 3, 3)
    ending, result = run_job(job, reference, PATIENT)
    assert (ending.stop, result) == (Stop.CRASHED, None)
