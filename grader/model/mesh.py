"""What a mesh, a ray, a tree and a hit look like as arrays.

Shape letters, used in every docstring of this project: V vertices, F faces, N nodes, R rays,
C candidates, K a selection. Arrays are read-only from the moment they enter a record.
"""

from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float32]
Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.uint32]
Integers = npt.NDArray[np.int64]
Bytes = npt.NDArray[np.uint8]
Mask = npt.NDArray[np.bool_]


class FrozenArrays:
    """Base of records that hold arrays: entering the record makes them read-only."""

    __slots__ = ()

    def __post_init__(self) -> None:
        """Clear the write flag of every array field."""
        for field in fields(self):  # type: ignore[arg-type]  # only dataclasses derive from it
            value = getattr(self, field.name)
            if isinstance(value, np.ndarray):
                value.setflags(write=False)


@dataclass(frozen=True, slots=True, eq=False)
class Mesh(FrozenArrays):
    """Triangles over shared vertices."""

    vertices: Floats
    """(V, 3) float32, world space."""

    faces: Indices
    """(F, 3) uint32, vertex indices, all below V."""


@dataclass(frozen=True, slots=True, eq=False)
class Rays(FrozenArrays):
    """Rays with their valid interval; directions need not be unit vectors."""

    origin: Floats
    """(R, 3) float32, world space."""

    direction: Floats
    """(R, 3) float32, world space; `t` counts in multiples of its length."""

    t_min: Floats
    """(R,) float32."""

    t_max: Floats
    """(R,) float32."""


@dataclass(frozen=True, slots=True, eq=False)
class Bvh(FrozenArrays):
    """A tree as read back from memory: nothing in a student's one is trusted."""

    low: Floats
    """(N, 3) float32, lower box corners; row i is node i, children at 2i+1 and 2i+2."""

    high: Floats
    """(N, 3) float32, upper box corners."""

    begin: Indices
    """(N,) uint32, the node's first entry of `order`."""

    end: Indices
    """(N,) uint32, one past the node's last entry of `order`; 0 marks an empty slot."""

    order: Indices
    """(K,) uint32, the face indices; K equals F in a right tree."""

    node_count: int
    """How many nodes the submission said it has; larger than N if not all were read."""


@dataclass(frozen=True, slots=True, eq=False)
class Hits(FrozenArrays):
    """What `intersect` returned for each ray."""

    point: Floats
    """(R, 3) float32, world space."""

    t: Floats
    """(R,) float32, infinite for a miss."""

    normal: Floats
    """(R, 3) float32."""


@dataclass(frozen=True, slots=True, eq=False)
class Answers(FrozenArrays):
    """What the rule of closest hits says of each ray (float64 on float32 inputs).

    Candidates are grouped by ray: those of ray r are `first[r]:first[r + 1]`. Kept are all
    SOLID and EDGE triangles up to `limit`, and every WILD one that the ray may touch.
    """

    limit: Doubles
    """(R,) float64, the smallest t + tolerance of a SOLID triangle; infinite if none."""

    first: Integers
    """(R + 1,) int64, offsets into the candidate arrays."""

    face: Integers
    """(C,) int64, face index of the candidate."""

    t: Doubles
    """(C,) float64."""

    tolerance: Doubles
    """(C,) float64, how far a float32 triangle test may be off in t."""

    kind: Bytes
    """(C,) uint8, one of SOLID, EDGE, WILD."""


SOLID, EDGE, WILD = 0, 1, 2
"""Kinds of a candidate: surely hit, at the border of float32, or edge-on and undecidable."""
