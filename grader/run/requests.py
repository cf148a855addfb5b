"""How each kind of trial becomes a job, and a result becomes the case that checks look at."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

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
from grader.model.mesh import Bvh, Floats, Hits, Mesh, Rays
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
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH, NODE_CAPACITY, SMALL_MAX_DEPTH

NODE_BYTES, RAY_BYTES, HIT_BYTES = 32, 32, 28
THREADS = 4
ROUNDS = 4
"""A race shows only where two threads meet in the same few nanoseconds."""

Read = Callable[[Sequence[Result], Ending], tuple[Case, ...]]
"""Makes cases from the results of all jobs and the ending of the last worker."""


@dataclass(frozen=True, slots=True)
class Request:
    """The jobs of a trial, each for a process of its own, and how to read their results."""

    jobs: tuple[Job, ...]
    read: Read


def request(trial: Trial) -> Request:
    """Lay out the job of a trial."""
    match trial:
        case ConstructTrial():
            return _construct(trial)
        case RebuildTrial():
            return _rebuild(trial)
        case WorkTrial():
            return _work(trial)
        case RepeatTrial():
            return _repeat(trial)
    return _trace(trial)


def give_mesh(job: Job, mesh: Mesh) -> int:
    """Hand a mesh to the worker; returns its slot."""
    vertices, faces = job.give(mesh.vertices), job.give(mesh.faces)
    return job.make(Op.MESH, vertices, len(mesh.vertices), faces, len(mesh.faces))


def read_tree(job: Job, slot: int, mesh: Mesh) -> Callable[[Result], Bvh]:
    """Have a tree copied out; returns how to read it."""
    faces = len(mesh.faces)
    # A right tree has fewer nodes than faces; a wrong one may have more, but what lies
    # beyond eight times as many cannot be reached without breaking the leaf rule first.
    capacity = min(NODE_CAPACITY, max(1024, 8 * faces))
    nodes = job.reserve(capacity * NODE_BYTES)
    order = job.reserve((faces + 1) * 4)
    counts = job.reserve(16)
    job.do(Op.READ_TREE, slot, nodes, capacity, order, faces + 1, counts)

    def read(result: Result) -> Bvh:
        node_count, order_count = result.number(counts), result.number(counts + 8)
        kept = min(node_count, capacity)
        table = result.array(nodes, 8 * kept, np.uint32).reshape(kept, 8)
        corners = np.ascontiguousarray(table[:, :6]).view(np.float32)
        return Bvh(
            low=corners[:, :3],
            high=corners[:, 3:],
            begin=np.ascontiguousarray(table[:, 6]),
            end=np.ascontiguousarray(table[:, 7]),
            order=result.array(order, min(order_count, faces + 1), np.uint32),
            node_count=node_count,
        )

    return read


def give_tree(job: Job, slot: int, tree: Bvh) -> None:
    """Put a tree of ours into a slot."""
    table = np.empty((len(tree.begin), 8), np.uint32)
    table[:, 0:3] = tree.low.view(np.uint32)
    table[:, 3:6] = tree.high.view(np.uint32)
    table[:, 6], table[:, 7] = tree.begin, tree.end
    order = job.give(tree.order)
    job.do(Op.SET_TREE, slot, job.give(table), len(table), order, len(tree.order))


@dataclass(frozen=True, slots=True)
class Traced:
    """Hits of each thread, and the counted calls of the given tests."""

    hits: tuple[Hits, ...]
    tests: tuple[float, float]
    """Mean calls per ray of the box test and of the triangle test."""


def trace(job: Job, slot: int, rays: Rays, threads: int = 1) -> Callable[[Result], Traced]:
    """Have rays traced; returns how to read what came back."""
    count = len(rays.t_min)
    table = np.empty((count, 8), np.float32)
    table[:, 0:3], table[:, 3:6] = rays.origin, rays.direction
    table[:, 6], table[:, 7] = rays.t_min, rays.t_max
    hits, tests = job.reserve(threads * count * HIT_BYTES), job.reserve(threads * count * 8)
    done = job.reserve(8)
    job.do(Op.TRACE, slot, job.give(table), count, hits, tests, done, threads)

    def read(result: Result) -> Traced:
        every = result.array(hits, threads * count * 7, np.float32).reshape(threads, count, 7)
        counts = result.array(tests, threads * count * 2, np.uint32).reshape(-1, 2)
        boxes, triangles = counts.mean(axis=0, dtype=np.float64) if count else (0.0, 0.0)
        return Traced(tuple(hits_of(part) for part in every), (float(boxes), float(triangles)))

    return read


def hits_of(table: Floats) -> Hits:
    """Split (R, 7) float32 rows into point, t and normal."""
    point, t, normal = table[:, 0:3], table[:, 3], table[:, 4:7]
    return Hits(*(np.ascontiguousarray(part) for part in (point, t, normal)))


def _construct(trial: ConstructTrial) -> Request:
    job = Job()
    slot = give_mesh(job, trial.mesh)
    job.do(Op.CONSTRUCT, slot, slot)
    tree = read_tree(job, slot, trial.mesh)
    max_depth = SMALL_MAX_DEPTH if trial.sanitized else MAX_DEPTH
    limited = len(trial.mesh.faces) > FACES_PER_LEAF << max_depth

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        (result,) = results
        if limited:
            return (DepthCase(trial.name, trial, tree(result), max_depth),)
        return () if trial.sanitized else (TreeCase(trial.name, trial, tree(result)),)

    return Request((job,), read)


def _rebuild(trial: RebuildTrial) -> Request:
    """A, B, A into one tree while another one, of B, is alive; then both meshes are read.

    A second process builds B alone, to tell what is left over from what is always so.
    """
    job = Job()
    first, second = give_mesh(job, trial.first), give_mesh(job, trial.second)
    again, other = job.make(Op.TREE), job.make(Op.TREE)
    readers = []
    for label, tree, slot, mesh in (
        ("first call, mesh A", again, first, trial.first),
        ("another tree, mesh B", other, second, trial.second),
        ("second call, mesh B", again, second, trial.second),
        ("third call, mesh A", again, first, trial.first),
    ):
        job.do(Op.CONSTRUCT, tree, slot)
        readers.append((label, mesh, read_tree(job, tree, mesh)))
    readers.append(("the other tree, later", trial.second, read_tree(job, other, trial.second)))
    meshes = [
        (label, mesh, _read_mesh(job, slot, mesh))
        for label, mesh, slot in (("A", trial.first, first), ("B", trial.second, second))
    ]

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


def _read_mesh(job: Job, slot: int, mesh: Mesh) -> Callable[[Result], Mesh]:
    vertex_room, face_room = len(mesh.vertices) + 1, len(mesh.faces) + 1
    vertices, faces = job.reserve(vertex_room * 12), job.reserve(face_room * 12)
    counts = job.reserve(16)
    job.do(Op.READ_MESH, slot, vertices, vertex_room, faces, face_room, counts)

    def read(result: Result) -> Mesh:
        vertex_count = min(result.number(counts), vertex_room)
        face_count = min(result.number(counts + 8), face_room)
        return Mesh(
            result.array(vertices, 3 * vertex_count, np.float32).reshape(-1, 3),
            result.array(faces, 3 * face_count, np.uint32).reshape(-1, 3),
        )

    return read


def _on_tree(job: Job, mesh: Mesh, tree: Bvh) -> int:
    slot = give_mesh(job, mesh)
    give_tree(job, slot, tree)
    return slot


def _trace(trial: TraceTrial | AlteredTrial | ImageTrial) -> Request:
    job = Job()
    hits = trace(job, _on_tree(job, trial.mesh, trial.tree), trial.rays)

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        (result,) = results
        (found,) = hits(result).hits
        match trial:
            case TraceTrial():
                return () if trial.sanitized else (HitCase(trial.name, trial, found),)
            case AlteredTrial():
                return (AlteredCase(trial.name, trial, found),)
        return (ImageCase(trial.name, trial, found),)

    return Request((job,), read)


def _work(trial: WorkTrial) -> Request:
    job = Job()
    traced = trace(job, _on_tree(job, trial.mesh, trial.tree), trial.rays)

    def read(results: Sequence[Result], ending: Ending) -> tuple[Case, ...]:
        (result,) = results
        found = traced(result)
        boxes, triangles = found.tests
        seconds = ending.cpu_seconds
        return (WorkCase(trial.name, trial, found.hits[0], boxes, triangles, seconds, seconds),)

    return Request((job,), read)


def _repeat(trial: RepeatTrial) -> Request:
    """The same rays: forwards, backwards, again, after another mesh's rays, from threads."""
    job = Job()
    slot = _on_tree(job, trial.mesh, trial.tree)
    other = _on_tree(job, trial.other_mesh, trial.other_tree)
    rays = trial.rays
    first = trace(job, slot, rays)
    backwards = trace(job, slot, _reversed(rays))
    again = trace(job, slot, rays)
    elsewhere = trace(job, other, rays)
    after = trace(job, slot, rays)
    together = [trace(job, slot, rays, THREADS) for _ in range(ROUNDS)]

    def read(results: Sequence[Result], _: Ending) -> tuple[Case, ...]:
        (result,) = results
        repeats = [
            ("in reverse order", _reversed_hits(backwards(result).hits[0])),
            ("a second time", again(result).hits[0]),
            ("after rays on another mesh", after(result).hits[0]),
            *(
                (f"from {THREADS} threads at once", hits)
                for threads in together
                for hits in threads(result).hits
            ),
        ]
        begun, other_hits = first(result).hits[0], elsewhere(result).hits[0]
        return (RepeatCase(trial.name, trial, begun, tuple(repeats), other_hits),)

    return Request((job,), read)


def _reversed(rays: Rays) -> Rays:
    return Rays(rays.origin[::-1], rays.direction[::-1], rays.t_min[::-1], rays.t_max[::-1])


def _reversed_hits(hits: Hits) -> Hits:
    return Hits(hits.point[::-1], hits.t[::-1], hits.normal[::-1])
