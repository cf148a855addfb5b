"""How meshes, trees and rays go into a job, and how trees and hits come back."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from grader.model.mesh import Bvh, Floats, Hits, Indices, Mesh, Rays
from grader.model.path import Path
from grader.run.job import Job, Result
from grader.run.protocol import Op
from grader.tolerances import NODE_CAPACITY

NODE_BYTES, RAY_BYTES, HIT_BYTES = 32, 32, 28
NODE = np.dtype([("low", "V12"), ("high", "V12"), ("begin", np.uint32), ("end", np.uint32)])
BLOCK = 8192
"""Nodes that are laid out at a time, so that they stay in the processor's cache."""

STEP_WORDS = 15
MOST_STEPS = 4096
"""Recorded tests of a ray; a path is recorded on small meshes only."""


def give_mesh(job: Job, mesh: Mesh) -> int:
    """Hand a mesh to the worker; returns its slot."""
    vertices, faces = job.give(mesh.vertices), job.give(mesh.faces)
    return job.make(Op.MESH, vertices, len(mesh.vertices), faces, len(mesh.faces))


def replace_mesh(job: Job, slot: int, mesh: Mesh) -> None:
    """Put another mesh where one lies, without a tree."""
    vertices, faces = job.give(mesh.vertices), job.give(mesh.faces)
    job.do(Op.REPLACE, slot, vertices, len(mesh.vertices), faces, len(mesh.faces))


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
    table, order = _node_table(tree), job.give(tree.order)
    job.do(Op.SET_TREE, slot, job.give(table), len(table), order, len(tree.order))


@lru_cache(maxsize=2)
def _node_table(tree: Bvh) -> npt.NDArray[np.void]:
    """Lay nodes out as the library reads them: (N,) NODE.

    The last tables are kept: the two builds get the same tree one after the other.
    """
    table = np.empty(len(tree.begin), NODE)
    low, high = (np.ascontiguousarray(each).view("V12")[:, 0] for each in (tree.low, tree.high))
    for first in range(0, len(table), BLOCK):
        block = slice(first, first + BLOCK)
        rows = table[block]
        rows["low"], rows["high"] = low[block], high[block]
        rows["begin"], rows["end"] = tree.begin[block], tree.end[block]
    table.setflags(write=False)
    return table


@dataclass(frozen=True, slots=True)
class Traced:
    """Hits of each thread, and the counted calls of the given tests."""

    hits: tuple[Hits, ...]
    counts: Indices
    """(R, 2) uint32, calls of the box test and of the triangle test for each ray, thread by
    thread."""

    @property
    def tests(self) -> tuple[float, float]:
        """Mean calls per ray of the box test and of the triangle test."""
        if not len(self.counts):
            return 0.0, 0.0
        boxes, triangles = self.counts.mean(axis=0, dtype=np.float64)
        return float(boxes), float(triangles)


def trace(job: Job, slot: int, rays: Rays, threads: int = 1) -> Callable[[Result], Traced]:
    """Have rays traced; returns how to read what came back."""
    count, table = len(rays.t_min), ray_table(rays)
    hits, tests = job.reserve(threads * count * HIT_BYTES), job.reserve(threads * count * 8)
    done = job.reserve(8)
    job.do(Op.TRACE, slot, job.give(table), count, hits, tests, done, threads)

    def read(result: Result) -> Traced:
        every = result.array(hits, threads * count * 7, np.float32).reshape(threads, count, 7)
        counts = result.array(tests, threads * count * 2, np.uint32).reshape(-1, 2)
        return Traced(tuple(hits_of(part) for part in every), counts)

    return read


def ray_table(rays: Rays) -> Floats:
    """Lay rays out as the library reads them: (R, 8) float32."""
    table = np.empty((len(rays.t_min), 8), np.float32)
    table[:, 0:3], table[:, 3:6] = rays.origin, rays.direction
    table[:, 6], table[:, 7] = rays.t_min, rays.t_max
    return table


def hits_of(table: Floats) -> Hits:
    """Split (R, 7) float32 rows into point, t and normal.

    Signalling NaNs become quiet ones here: later each calculation with one would be reported.
    """
    with np.errstate(invalid="ignore"):
        table = table * np.float32(1)
    point, t, normal = table[:, 0:3], table[:, 3], table[:, 4:7]
    return Hits(*(np.ascontiguousarray(part) for part in (point, t, normal)))


def read_mesh(job: Job, slot: int, mesh: Mesh) -> Callable[[Result], Mesh]:
    """Have a mesh copied out; returns how to read it."""
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


def on_tree(job: Job, mesh: Mesh, tree: Bvh) -> int:
    """Hand a mesh with a tree of ours to the worker; returns its slot."""
    slot = give_mesh(job, mesh)
    give_tree(job, slot, tree)
    return slot


def record(job: Job, slot: int, rays: Rays, ray: int) -> Callable[[Result], Path]:
    """Have the tests of one ray recorded; returns how to read them."""
    table = ray_table(rays)[ray : ray + 1]
    hit, steps = job.reserve(HIT_BYTES), job.reserve(MOST_STEPS * STEP_WORDS * 4)
    count = job.reserve(8)
    job.do(Op.RECORD, slot, job.give(table), hit, steps, MOST_STEPS, count)

    return lambda result: path_of(result, hit, steps, count)


def path_of(result: Result, hit: int, steps: int, count: int) -> Path:
    """Read a recorded path.

    Args:
        result: Where it lies.
        hit: Offset of the hit.
        steps: Offset of the tests.
        count: Offset of their true number.
    """
    total = result.number(count)
    kept = min(total, MOST_STEPS)
    words = result.array(steps, kept * STEP_WORDS, np.uint32).reshape(kept, STEP_WORDS)
    floats = words[:, 3:].view(np.float32)
    return Path(
        is_box=words[:, 0] == 0,
        hit=words[:, 1] != 0,
        node=words[:, 2].copy(),
        t=floats[:, 0].copy(),
        t_min=floats[:, 1].copy(),
        t_max=floats[:, 2].copy(),
        corners=floats[:, 3:].copy(),
        found=float(result.array(hit, 7, np.float32)[3]),
        total=total,
    )
