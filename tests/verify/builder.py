"""Makes meshes, right and wrong trees of them, and their verdicts, without a compiler."""

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from grader.model.cases import Case, TreeCase
from grader.model.mesh import Bvh, Floats, Mesh
from grader.model.trials import ConstructTrial
from grader.model.verdict import Finding, Verdict
from grader.tolerances import MAX_DEPTH
from grader.verify import every_check
from grader.verify.engine import Examiner

Centre = Callable[[Floats, Floats, Floats], npt.NDArray[np.floating]]
THIRD = np.float32(1) / np.float32(3)

CENTRES: dict[str, Centre] = {
    "sum / 3": lambda a, b, c: (a + b + c) / np.float32(3),
    "sum * (1 / 3)": lambda a, b, c: (a + b + c) * THIRD,
    "thirds": lambda a, b, c: a / np.float32(3) + b / np.float32(3) + c / np.float32(3),
    "sum": lambda a, b, c: a + b + c,
    "double": lambda a, b, c: (a.astype(np.float64) + b + c) / 3,
}
"""The formulas that the sheet leaves room for; (F, 3) from three corners."""


def longest(extent: Floats) -> int:
    """Take the first of the longest axes."""
    return int(np.argmax(extent))


@dataclass(frozen=True, slots=True)
class Reading:
    """How a tree is built; the defaults are one right way."""

    centre: Centre = CENTRES["sum / 3"]
    axis: Callable[[Floats], int] = longest
    """From the (3,) extents of a node's box to the axis of its split."""

    odd_left: bool = False
    """Whether the left half gets the odd face."""

    ties_reversed: bool = False
    shift: int = 0
    """How many faces the middle lies too far to the right."""

    leaf: int = 4
    depth: int = MAX_DEPTH
    """Deepest level, the root being level 0."""

    slots: int = 0
    """How many unused slots follow the last used node."""

    free: int | None = None
    """Seed of what is decided anew at every node: ties of axes and of centres, the side of the
    odd face, the order of the faces of a leaf. None leaves it to the fields above."""


def mesh_of(corners: npt.ArrayLike) -> Mesh:
    """Make a mesh without shared vertices from (F, 3, 3) corners."""
    vertices = np.array(corners, dtype=np.float32).reshape(-1, 3)
    return Mesh(vertices, np.arange(len(vertices), dtype=np.uint32).reshape(-1, 3))


def soup(faces: int, seed: int = 3, scale: float = 1.0) -> Mesh:
    """Make small triangles at random places of a box that is longest along x."""
    rng = np.random.default_rng(seed)
    middle = rng.uniform(-1, 1, (faces, 1, 3)) * (3, 2, 1)
    return mesh_of((middle + rng.uniform(-0.3, 0.3, (faces, 3, 3))) * scale)


def build(mesh: Mesh, reading: Reading | None = None) -> Bvh:
    """Split every node at the median of the centres."""
    reading = reading or Reading()
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    centre = reading.centre(a, b, c)
    order = np.arange(len(mesh.faces))
    ranges = {0: (0, len(order))}
    for i in itertools.takewhile(lambda i: i <= max(ranges), itertools.count()):
        begin, end = ranges.get(i, (0, 0))
        here = _decided(reading, i)
        mine = order[begin:end]
        if end - begin <= reading.leaf or (i + 1).bit_length() > reading.depth:
            order[begin:end] = here.leaf(mine)
            continue
        low, high = box(mesh, mine) if i else whole(mesh)
        order[begin:end] = mine[here.ranked(centre[mine, here.axis(high - low)])]
        middle = begin + (end - begin + here.odd_left) // 2 + reading.shift
        ranges[2 * i + 1], ranges[2 * i + 2] = (begin, middle), (middle, end)
    return _tree(mesh, order, ranges, reading.slots)


@dataclass(frozen=True, slots=True)
class Decided:
    """What is done at one node where several ways are right."""

    axis: Callable[[Floats], int]
    ranked: Callable[[npt.NDArray[np.floating]], npt.NDArray[np.int64]]
    odd_left: bool
    leaf: Callable[[npt.NDArray[np.int64]], npt.NDArray[np.int64]]


def _decided(reading: Reading, node: int) -> Decided:
    """Decide for one node what the sheet leaves free."""
    if reading.free is None:
        return Decided(
            reading.axis,
            lambda key: _ranked(key, reading.ties_reversed),
            reading.odd_left,
            lambda faces: faces,
        )
    rng = np.random.default_rng([reading.free, node])
    return Decided(
        lambda extent: int(rng.choice(np.flatnonzero(extent == extent.max()))),
        lambda key: np.lexsort((rng.random(len(key)), key)),
        bool(rng.integers(2)),
        lambda faces: rng.permutation(faces),
    )


def box(mesh: Mesh, chosen: npt.NDArray[np.integer]) -> tuple[Floats, Floats]:
    """Corners of the box of some faces."""
    points = mesh.vertices[mesh.faces[chosen]].reshape(-1, 3)
    return points.min(axis=0), points.max(axis=0)


def whole(mesh: Mesh) -> tuple[Floats, Floats]:
    """Corners of the mesh's box; the empty box if there is no vertex."""
    initial = np.float32(np.inf)
    low = mesh.vertices.min(axis=0, initial=initial)
    return low, mesh.vertices.max(axis=0, initial=-initial)


def _ranked(key: npt.NDArray[np.floating], ties_reversed: bool) -> npt.NDArray[np.int64]:
    if ties_reversed:
        return np.argsort(-key, kind="stable")[::-1]
    return np.argsort(key, kind="stable")


def _tree(
    mesh: Mesh,
    order: npt.NDArray[np.int64],
    ranges: dict[int, tuple[int, int]],
    slots: int,
) -> Bvh:
    count = max(ranges) + 1 + slots
    low = np.full((count, 3), np.inf, np.float32)
    high, span = -low, np.zeros((count, 2), np.uint32)
    for i, (begin, end) in ranges.items():
        span[i] = begin, end
        if begin < end:
            low[i], high[i] = box(mesh, order[begin:end])
    low[0], high[0] = whole(mesh)
    begin, end = np.ascontiguousarray(span.T)
    return Bvh(low, high, begin, end, order.astype(np.uint32), count)


def altered(bvh: Bvh, **arrays: npt.ArrayLike) -> Bvh:
    """Replace some arrays of a tree; `node_count` follows them unless it is given."""
    kinds = {"low": np.float32, "high": np.float32}
    fields = {name: getattr(bvh, name) for name in ("low", "high", "begin", "end", "order")}
    node_count = arrays.pop("node_count", None)
    fields |= {
        name: np.array(value, dtype=kinds.get(name, np.uint32))
        for name, value in arrays.items()
    }
    count = len(fields["end"]) if node_count is None else int(np.asarray(node_count))
    return Bvh(**fields, node_count=count)


def changed(bvh: Bvh, field: str, where: tuple[int, ...] | int, value: float) -> Bvh:
    """Replace one number of a tree."""
    array = getattr(bvh, field).copy()
    array[where] = value
    return altered(bvh, **{field: array})


def tree_case(mesh: Mesh, bvh: Bvh, full_levels: bool = False) -> TreeCase:
    """Make the case that the checks of part a look at."""
    return TreeCase("mesh", ConstructTrial("mesh", mesh, full_levels=full_levels), bvh)


def findings(*cases: Case) -> dict[str, Finding]:
    """Decide all checks on some cases; the last finding of each."""
    return {found.check: found for found in findings_of(cases)}


def findings_of(cases: Iterable[Case]) -> list[Finding]:
    """Decide all checks on some cases, in the grader's order."""
    return list(Examiner(every_check()).examine(cases))


def failed(mesh: Mesh, bvh: Bvh, full_levels: bool = False) -> set[str]:
    """Ids of the checks that do not pass, without the topic."""
    found = findings(tree_case(mesh, bvh, full_levels)).values()
    assert not [each.reason for each in found if each.verdict is Verdict.BROKEN]
    return {
        each.check.removeprefix("bvh.") for each in found if each.verdict is not Verdict.PASS
    }
