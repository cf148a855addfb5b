"""How each kind of trial becomes a job, and a result becomes the case that checks look at."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from grader.model.cases import (
    AlteredCase,
    Case,
    DepthCase,
    HitCase,
    ImageCase,
    RebuildCase,
    RepeatCase,
    TreeCase,
    WorkCase,
)
from grader.model.mesh import Bvh, Hits, Rays
from grader.model.stages import Ending
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.run.job import Job, Result
from grader.run.protocol import Op
from grader.run.transfer import (
    give_mesh,
    give_tree,
    on_tree,
    read_mesh,
    read_tree,
    replace_mesh,
    trace,
)
from grader.tolerances import depth_limit, reaches_the_limit

THREADS = 4
ROUNDS = 4
"""A race shows only where two threads meet in the same few nanoseconds."""

Read = Callable[[Sequence[Result], Ending], tuple[Case, ...]]
"""Makes cases from the results of all jobs and the ending of the last worker."""

ReadOne = Callable[[Result, Ending], tuple[Case, ...]]
"""Makes the cases of one trial from the result of a job that may hold others."""

Single = ConstructTrial | TraceTrial | AlteredTrial | WorkTrial | ImageTrial
"""Trials that need one process, which may serve others too where that does not matter."""


@dataclass(frozen=True, slots=True)
class Request:
    """The jobs of a trial, each for a process of its own, and how to read their results."""

    jobs: tuple[Job, ...]
    read: Read


def request(trial: Trial) -> Request:
    """Lay out the job of a trial."""
    match trial:
        case RebuildTrial():
            return _rebuild(trial)
        case RepeatTrial():
            return _repeat(trial)
        case AlteredTrial() if trial.sound is not None:
            return _altered(trial, trial.sound)
    job = Job()
    read = asked(job, trial)
    return Request((job,), lambda results, ending: read(results[0], ending))


def asked(job: Job, trial: Single) -> ReadOne:
    """Append a trial to a job that may hold others; returns how to read its cases."""
    match trial:
        case ConstructTrial():
            return _construct(job, trial)
        case WorkTrial():
            return _work(job, trial)
    return _trace(job, trial)


def _construct(job: Job, trial: ConstructTrial) -> ReadOne:
    slot = give_mesh(job, trial.mesh)
    job.do(Op.CONSTRUCT, slot, slot)
    tree = read_tree(job, slot, trial.mesh)
    limited = reaches_the_limit(len(trial.mesh.faces), trial.sanitized)

    def read(result: Result, _: Ending) -> tuple[Case, ...]:
        made: tuple[Case, ...] = ()
        if limited:
            limit = depth_limit(trial.sanitized)
            made = (DepthCase(trial.name, trial, tree(result), limit),)
        # At the small limit a tree is looked at like any other; the huge one takes too long.
        if limited == trial.sanitized:
            made += (TreeCase(trial.name, trial, tree(result)),)
        return made

    return read


def _rebuild(trial: RebuildTrial) -> Request:
    """A into its own tree, then A, B, A into one tree while another one, of B, is alive.

    Then both meshes are read. A second process builds B alone, to tell what is left over from
    what is always so.
    """
    job = Job()
    first, second = give_mesh(job, trial.first), give_mesh(job, trial.second)
    again, other = job.make(Op.TREE), job.make(Op.TREE)
    readers = []
    for label, tree, slot, mesh in (
        ("first call, mesh A", first, first, trial.first),
        ("a second tree, mesh A", again, first, trial.first),
        ("another tree, mesh B", other, second, trial.second),
        ("second call, mesh B", again, second, trial.second),
        ("third call, mesh A", again, first, trial.first),
    ):
        job.do(Op.CONSTRUCT, tree, slot)
        readers.append((label, mesh, read_tree(job, tree, mesh)))
    # As a program does that loads a model: `mesh = Mesh(...)`, then `bvh.construct(mesh)`.
    moved = give_mesh(job, trial.first)
    job.do(Op.CONSTRUCT, moved, moved)
    replace_mesh(job, moved, trial.second)
    job.do(Op.CONSTRUCT, moved, moved)
    replaced = read_tree(job, moved, trial.second)
    readers.append(("mesh B in the place where A was", trial.second, replaced))
    readers.append(("the other tree, later", trial.second, read_tree(job, other, trial.second)))
    meshes = [
        (label, mesh, read_mesh(job, slot, mesh))
        for label, mesh, slot in (("A", trial.first, first), ("B", trial.second, second))
    ]

    if trial.sanitized:
        return Request((job,), _no_cases)
    alone = Job()
    slot = give_mesh(alone, trial.second)
    alone.do(Op.CONSTRUCT, slot, slot)
    untouched = read_tree(alone, slot, trial.second)

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        result, fresh = results
        trees = tuple((label, mesh, tree(result)) for label, mesh, tree in readers)
        return (
            RebuildCase(
                trial.name,
                trial,
                trees,
                untouched(fresh),
                tuple((label, mesh, back(result)) for label, mesh, back in meshes),
            ),
        )

    return Request((job, alone), read)


def _trace(job: Job, trial: TraceTrial | AlteredTrial | ImageTrial) -> ReadOne:
    hits = trace(job, on_tree(job, trial.mesh, trial.tree), trial.rays)

    def read(result: Result, _: Ending) -> tuple[Case, ...]:
        traced = hits(result)
        (found,) = traced.hits
        match trial:
            case TraceTrial():
                return () if trial.sanitized else (HitCase(trial.name, trial, found),)
            case AlteredTrial():
                return (AlteredCase(trial.name, trial, found),)
        return (ImageCase(trial.name, trial, found, traced.counts),)

    return read


def _altered(trial: AlteredTrial, sound: Bvh) -> Request:
    """The same rays on both trees, each in a process that never sees the other one."""
    job, beside = Job(), Job()
    altered = trace(job, on_tree(job, trial.mesh, trial.tree), trial.rays)
    whole = trace(beside, on_tree(beside, trial.mesh, sound), trial.rays)

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        found, before = (each(one) for each, one in zip((altered, whole), results, strict=True))
        return (AlteredCase(trial.name, trial, found.hits[0], before.hits[0]),)

    return Request((job, beside), read)


def _work(job: Job, trial: WorkTrial) -> ReadOne:
    traced = trace(job, on_tree(job, trial.mesh, trial.tree), trial.rays)

    def read(result: Result, ending: Ending) -> tuple[Case, ...]:
        found = traced(result)
        hits, (boxes, triangles) = found.hits[0], found.tests
        # Whoever grades puts the reference's time and t in place of the own ones.
        reference = ending.cpu_seconds, hits.t
        counts = boxes, triangles, ending.cpu_seconds
        return (WorkCase(trial.name, trial, hits, *counts, *reference),)

    return read


def _repeat(trial: RepeatTrial) -> Request:
    """The same rays: forwards, backwards, again, after another mesh's rays, from threads.

    Once also with the mesh where the other one was, and once each ray twice in a row, which is
    the same object then. In a second process the threads come first: nothing was prepared by a
    ray before.
    """
    if trial.sanitized:
        return _repeat_sanitized(trial)
    job = Job()
    slot = on_tree(job, trial.mesh, trial.tree)
    other = on_tree(job, trial.other_mesh, trial.other_tree)
    rays = trial.rays
    first = trace(job, slot, rays)
    backwards = trace(job, slot, _reversed(rays))
    again = trace(job, slot, rays)
    elsewhere = trace(job, other, rays)
    replace_mesh(job, other, trial.mesh)
    give_tree(job, other, trial.tree)
    # The ray that was last there comes first.
    moved = trace(job, other, _reversed(rays))
    after = trace(job, slot, rays)
    twice = trace(job, slot, _each_twice(rays))
    together = [trace(job, slot, rays, THREADS) for _ in range(ROUNDS)]
    cold = Job()
    at_once = trace(cold, on_tree(cold, trial.mesh, trial.tree), rays, THREADS)

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        result, unprepared = results
        repeats = [
            ("in reverse order", _reversed_hits(backwards(result).hits[0])),
            ("a second time", again(result).hits[0]),
            ("after rays on another mesh", after(result).hits[0]),
            ("the second time in a row", _second_of_two(twice(result).hits[0])),
            ("where another mesh was", _reversed_hits(moved(result).hits[0])),
            *(
                (f"from {THREADS} threads at once", hits)
                for threads in together
                for hits in threads(result).hits
            ),
            *(
                (f"from {THREADS} threads before any other ray", hits)
                for hits in at_once(unprepared).hits
            ),
        ]
        begun, other_hits = first(result).hits[0], elsewhere(result).hits[0]
        return (RepeatCase(trial.name, trial, begun, tuple(repeats), other_hits),)

    return Request((job, cold), read)


def _repeat_sanitized(trial: RepeatTrial) -> Request:
    """The other mesh, the mesh, and the other one again: each larger or smaller than before."""
    job = Job()
    other = on_tree(job, trial.other_mesh, trial.other_tree)
    slot = on_tree(job, trial.mesh, trial.tree)
    for each in (other, slot, other):
        trace(job, each, trial.rays)
    return Request((job,), _no_cases)


def _no_cases(_: Sequence[Result], __: Ending) -> tuple[Case, ...]:
    """Of a worker of the sanitized build only its end is looked at."""
    return ()


def _each_twice(rays: Rays) -> Rays:
    parts = (rays.origin, rays.direction, rays.t_min, rays.t_max)
    return Rays(*(part.repeat(2, axis=0) for part in parts))


def _second_of_two(hits: Hits) -> Hits:
    return Hits(hits.point[1::2], hits.t[1::2], hits.normal[1::2])


def _reversed(rays: Rays) -> Rays:
    return Rays(rays.origin[::-1], rays.direction[::-1], rays.t_min[::-1], rays.t_max[::-1])


def _reversed_hits(hits: Hits) -> Hits:
    return Hits(hits.point[::-1], hits.t[::-1], hits.normal[::-1])
