"""What a worker is asked to do: one trial is one fresh process.

A trial carries what the trusted side needs to judge it afterwards. The worker sees only the
meshes, trees and rays in it, never an answer and never its name.
"""

from dataclasses import dataclass

from grader.model.mesh import (
    Answers,
    Bvh,
    Floats,
    FrozenArrays,
    Integers,
    Mask,
    Mesh,
    Rays,
)


@dataclass(frozen=True, slots=True)
class ConstructTrial:
    """Call `construct` once and read the tree back."""

    name: str
    mesh: Mesh
    sanitized: bool = False
    """Runs the build with sanitizers, whose depth limit is `SMALL_MAX_DEPTH`."""

    full_levels: bool = False
    """Whether the rubric also accepts trees that stop at the last full level."""


@dataclass(frozen=True, slots=True)
class RebuildTrial:
    """Call `construct` for meshes A, B, A on one tree object while a second one is alive."""

    name: str
    first: Mesh
    second: Mesh
    sanitized: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class TraceTrial(FrozenArrays):
    """Call `intersect` for rays on a tree that the reference built."""

    name: str
    mesh: Mesh
    tree: Bvh
    rays: Rays
    answers: Answers
    families: tuple[str, ...]
    """Names of the ray families in `rays`."""

    family: Integers
    """(R,) int64, index into `families` of each ray."""

    special: bool
    """True if these are the rays of `hits.special-rays`, False for ordinary ones."""

    sanitized: bool = False
    on_borders: bool = False
    """True if every hit lies on the border of its face: some triangle tests find none there."""


@dataclass(frozen=True, slots=True, eq=False)
class AlteredTrial(FrozenArrays):
    """Call `intersect` on a tree with replaced leaves or shrunk inner boxes."""

    name: str
    mesh: Mesh
    tree: Bvh
    """The altered tree."""

    rays: Rays
    answers: Answers
    """The answers on the whole mesh, as if the tree had not been altered."""

    lost: Mask
    """(R,) bool, True where a true traversal cannot find the hit of `answers` any more."""

    change: str
    """What was altered, for the student: `9 of 64 leaves hold the faces of others`."""

    sound: Bvh | None = None
    """The tree as it was, on which the same rays are traced too; None if they are not."""


@dataclass(frozen=True, slots=True)
class WorkTrial:
    """Call `intersect` for ordinary rays, count the calls of the given tests, take the time."""

    name: str
    mesh: Mesh
    tree: Bvh
    rays: Rays
    box_tests: float
    """Mean calls of the box test per ray of a plain traversal without early out."""

    triangle_tests: float
    """Mean calls of the triangle test per ray of the same plain traversal."""

    special: bool = False
    """Rays of kinds for which a right box test may be less sharp."""


@dataclass(frozen=True, slots=True)
class RepeatTrial:
    """Call `intersect` for the same rays: reversed, again, after others, from threads.

    They are also traced on another mesh in between, which must not find what was found before.
    """

    name: str
    mesh: Mesh
    tree: Bvh
    other_mesh: Mesh
    other_tree: Bvh
    rays: Rays
    answers: Answers
    other_answers: Answers
    """Of the same rays on the other mesh."""

    sanitized: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class ImageTrial(FrozenArrays):
    """Call `intersect` for the pixel centres of a picture that Mitsuba rendered."""

    name: str
    mesh: Mesh
    tree: Bvh
    width: int
    height: int
    rays: Rays
    """Row by row from the top left pixel, as Mitsuba's sensor made them."""

    answers: Answers
    mitsuba_t: Floats
    """(R,) float32, Mitsuba's hit distance along the same rays; infinite for a miss."""

    weight: float = 1.0
    """How many ordinary cases it counts for."""

    shown: bool = True
    """Whether students may see it."""


Trial = (
    ConstructTrial
    | RebuildTrial
    | TraceTrial
    | AlteredTrial
    | WorkTrial
    | RepeatTrial
    | ImageTrial
)


def part_of(trial: Trial) -> str:
    """Which part of the exercise a trial calls."""
    return "a" if isinstance(trial, ConstructTrial | RebuildTrial) else "b"
