"""What one ray tested on its way through a tree, as the submission's process tells it."""

from dataclasses import dataclass

from grader.model.mesh import Floats, FrozenArrays, Indices, Mask

NO_NODE = 2**32 - 1
"""Node of a box test whose box is a copy, and of every triangle test."""


@dataclass(frozen=True, slots=True, eq=False)
class Path(FrozenArrays):
    """Calls of the given tests, in order; nothing of it is trusted, and it moves no point."""

    is_box: Mask
    """(S,) bool, True for box tests, False for triangle tests."""

    hit: Mask
    """(S,) bool, what the test said."""

    node: Indices
    """(S,) uint32, the node whose box it was; `NO_NODE` if that is not known."""

    t: Floats
    """(S,) float32, where a triangle was hit."""

    t_min: Floats
    """(S,) float32, of the ray as it was tested."""

    t_max: Floats
    """(S,) float32, of the ray as it was tested."""

    corners: Floats
    """(S, 9) float32, the box's corners and three zeros, or the triangle's corners."""

    found: float
    """The t that `intersect` returned in the end."""

    total: int
    """How many tests there were, all in all; only the first ones are kept."""
