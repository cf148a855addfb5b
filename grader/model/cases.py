"""What a check gets to see: a trial and exactly what its worker delivered.

A case exists only if its worker delivered it, so no check ever tests for None.
"""

from dataclasses import dataclass

from grader.model.mesh import Bvh, Floats, FrozenArrays, Hits, Indices, Mesh
from grader.model.stages import CallGraph, Ending
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


@dataclass(frozen=True, slots=True)
class BuildCase:
    """The build itself: `errors` is empty if the file compiled."""

    name: str
    errors: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SourceCase:
    """The call graph of the student's file."""

    name: str
    graph: CallGraph


@dataclass(frozen=True, slots=True)
class TreeCase:
    """A tree that `construct` built."""

    name: str
    trial: ConstructTrial
    bvh: Bvh


@dataclass(frozen=True, slots=True)
class DepthCase:
    """A tree of a mesh with so many faces that only the depth limit can end it."""

    name: str
    trial: ConstructTrial
    bvh: Bvh
    max_depth: int
    """The depth limit that the build was compiled with."""


@dataclass(frozen=True, slots=True)
class RebuildCase:
    """Trees of repeated calls, and the meshes as they were afterwards."""

    name: str
    trial: RebuildTrial
    trees: tuple[tuple[str, Mesh, Bvh], ...]
    """What was built, for which mesh, and the tree: `second call, mesh B`."""

    alone: Bvh
    """The tree of the second mesh from a process that built no other."""

    meshes: tuple[tuple[str, Mesh, Mesh], ...]
    """Name, mesh as given and mesh as read back."""


@dataclass(frozen=True, slots=True)
class HitCase:
    """Hits on a tree that the reference built."""

    name: str
    trial: TraceTrial
    hits: Hits


@dataclass(frozen=True, slots=True)
class AlteredCase:
    """Hits on an altered tree."""

    name: str
    trial: AlteredTrial
    hits: Hits
    sound: Hits | None = None
    """Hits of the same rays on the tree as it was; None if they were not asked for."""


@dataclass(frozen=True, slots=True)
class WorkCase:
    """How much a ray costs."""

    name: str
    trial: WorkTrial
    hits: Hits
    box_tests: float
    """Mean counted calls of the given box test per ray."""

    triangle_tests: float
    """Mean counted calls of the given triangle test per ray."""

    cpu_seconds: float
    """CPU time of the submission's worker, measured from outside."""

    reference_cpu_seconds: float
    """CPU time of the reference's worker for the same trial in the same run."""

    reference_t: Floats
    """(R,) float32, what the reference returns for the same rays."""


@dataclass(frozen=True, slots=True)
class RepeatCase:
    """The same rays again and again."""

    name: str
    trial: RepeatTrial
    first: Hits
    again: tuple[tuple[str, Hits], ...]
    """In which circumstances, and the hits in the order of `first`."""

    other: Hits
    """Hits of the same rays on the other mesh."""


@dataclass(frozen=True, slots=True, eq=False)
class ImageCase(FrozenArrays):
    """Hits of the pixel centres of a reference picture."""

    name: str
    trial: ImageTrial
    hits: Hits
    tests: Indices
    """(R, 2) uint32, counted calls of the given box test and triangle test for each pixel."""


@dataclass(frozen=True, slots=True)
class SurvivalCase:
    """How a worker of the graded build ended."""

    name: str
    trial: Trial
    ending: Ending


@dataclass(frozen=True, slots=True)
class MemoryCase:
    """How a worker of the sanitized build ended."""

    name: str
    trial: Trial
    ending: Ending


Case = (
    BuildCase
    | SourceCase
    | TreeCase
    | DepthCase
    | RebuildCase
    | HitCase
    | AlteredCase
    | WorkCase
    | RepeatCase
    | ImageCase
    | SurvivalCase
    | MemoryCase
)
