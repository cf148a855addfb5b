"""What is kept of a run, so that a likely cause can be looked for when it is over?"""

from collections import defaultdict
from collections.abc import Callable
from typing import TypeVar

from grader.model.cases import Case, DepthCase, ImageCase, TreeCase

CaseT = TypeVar("CaseT")

MOST_FACES = 5_000
"""Trees over more faces are not kept: small ones tell the same, and sooner."""

MOST_NODES = 1 << 16
"""Nor are trees with more nodes: one over few faces may have any number of them."""


class Notes:
    """The cases of a run that are small enough to be looked at once more."""

    def __init__(self) -> None:
        self._cases: dict[type, list[Case]] = defaultdict(list)

    def note(self, case: Case) -> None:
        """Keep a case, if it is small."""
        if isinstance(case, ImageCase):
            return
        if isinstance(case, TreeCase | DepthCase):
            few = case.trial.sanitized or len(case.trial.mesh.faces) <= MOST_FACES
            if not few or len(case.bvh.end) > MOST_NODES:
                return
        self._cases[type(case)].append(case)

    def only(self, counts: Callable[[Case], bool]) -> "Notes":
        """Return notes of some of the cases."""
        some = Notes()
        for kind, cases in self._cases.items():
            some._cases[kind] = [case for case in cases if counts(case)]
        return some

    def of(self, kind: type[CaseT]) -> list[CaseT]:
        """The cases of one kind, those of small meshes first.

        `Notes` itself is a kind too: of what only several cases together tell.
        """
        if kind is Notes:
            return [self]  # type: ignore[list-item]  # mypy does not know that they are the same
        cases = sorted(self._cases[kind], key=_size)
        return cases  # type: ignore[return-value]  # noqa: RET504 - each list holds its own kind


def _size(case: Case) -> int:
    mesh = getattr(getattr(case, "trial", None), "mesh", None)
    return 0 if mesh is None else len(mesh.faces)
