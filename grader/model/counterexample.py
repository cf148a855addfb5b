"""What a student is shown of the smallest input that fails a check."""

from dataclasses import dataclass

from grader.model.trials import Trial
from grader.model.views import Model


@dataclass(frozen=True, slots=True)
class Column:
    """One node of a table: what is expected there, and what is there."""

    node: int
    expected: str
    got: str


@dataclass(frozen=True, slots=True)
class NodeTable:
    """A tree as the sheet's figure shows one: nodes above, face indices below."""

    columns: tuple[Column, ...]
    expected_faces: str
    got_faces: str
    """Empty where there is nothing to compare: the tree is ours."""

    first_difference: int
    """Index into `columns`; -1 if there is none."""


@dataclass(frozen=True, slots=True)
class Counterexample:
    """A reduced case that fails a check; the model solution passes it."""

    check: str
    trial: Trial
    faces: int
    """Of its mesh, or of both together if there are two."""

    rays: int
    found_in: str
    """Name of the trial that it was reduced from."""

    message: str
    expected: str
    got: str
    explanation: str = ""
    """Where in the tree a hit was lost; empty if nothing is known."""

    table: NodeTable | None = None
    """None for larger meshes."""

    model: Model | None = None
    """To be turned in space; None if neither a tree nor one ray is what fails."""


@dataclass(frozen=True, slots=True)
class Replay:
    """What became of a counterexample."""

    check: str
    title: str
    found: Counterexample | None
    """None if the check passes on it now, or is undecided."""

    undecided: str = ""
    """Why the submission could not be run, or ended before the check could tell."""

    is_ours: bool = False
    """Whether that says nothing of the submission: the clock, or a file that was changed."""
