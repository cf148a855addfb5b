"""What a report shows of a submission: pictures, and what can be turned in space.

Nothing in here moves a point.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from grader.model.mesh import Bytes, Floats, FrozenArrays, Integers, Mesh

if TYPE_CHECKING:
    # It imports this module, because a counterexample has a model.
    from grader.model.counterexample import NodeTable


@dataclass(frozen=True, slots=True, eq=False)
class Drawing(FrozenArrays):
    """A picture as the submission sees it, row by row from the top left pixel.

    H and W are its height and width.
    """

    yours: Bytes
    """(H, W, 3) uint8, sRGB."""

    difference: Bytes
    """(H, W) uint8, the FLIP error of each pixel, 255 for an error of 1."""

    wrong: Bytes
    """(H, W) uint8, 1 at each pixel that the check of pictures counts as wrong."""

    tests: Integers
    """(H, W) int64, box tests and triangle tests together."""

    flip: float
    """Mean FLIP error, 0 to 1."""

    box_tests: float
    """Mean per ray."""

    triangle_tests: float
    """Mean per ray."""

    without_shadows: bool
    """True if the shadow rays did not come back."""


@dataclass(frozen=True, slots=True, eq=False)
class Picture(FrozenArrays):
    """A scene, as Mitsuba renders it and as the submission does."""

    scene: str
    title: str
    reference: Bytes
    """(H, W, 3) uint8, sRGB."""

    drawing: Drawing | None
    """None if the submission brought no picture."""


@dataclass(frozen=True, slots=True)
class Step:
    """One call of a given test on the way of a ray."""

    node: int
    """-1 if it is not known, or if it was a triangle's."""

    face: int
    """-1 if it was a box, or a triangle that is not in the mesh."""

    hit: bool
    t_max: float
    """Of the ray as it was tested."""


@dataclass(frozen=True, slots=True)
class ShownRay:
    """A ray with a wrong result."""

    origin: tuple[float, float, float]
    direction: tuple[float, float, float]
    t_min: float
    t_max: float
    expected: float
    """Where it surely hits; infinite if nowhere."""

    got: float
    face: int
    """What it should hit; -1 if nothing."""

    lost: int
    """Node at which the hit was lost; -1 if there is none."""

    sentence: str
    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Model(FrozenArrays):
    """A mesh with the boxes of a tree over it."""

    check: str
    """Id of the check whose counterexample it is; empty if it is a scene."""

    title: str
    mesh: Mesh
    """What is shown; a large mesh is shown coarsened."""

    faces: int
    """Of the mesh before that."""

    low: Floats
    """(N, 3) float32, lower corners of the tree's first nodes; NaN in empty slots."""

    high: Floats
    """(N, 3) float32, upper corners."""

    node: int
    """Node that is wrong; -1 if none is."""

    right_box: tuple[float, ...]
    """Minimum and maximum that the box of `node` should have; empty if it is right."""

    marked: Integers
    """(K,) int64, faces that the mistake is about."""

    ray: ShownRay | None


@dataclass(frozen=True, slots=True)
class Views:
    """All of it."""

    pictures: tuple[Picture, ...]
    models: tuple[Model, ...]
    """The most telling one first."""

    tables: tuple[tuple[str, "NodeTable"], ...] = ()
    """Trees of small counterexamples, node by node, with the id of the check."""
