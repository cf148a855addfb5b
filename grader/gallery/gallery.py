"""What is kept of a run so that it can be drawn, and the drawing itself.

Nothing is decided here any more: our own fault costs a picture, and no point.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from grader.errors import let_go
from grader.gallery.hung import Exhibit, hung
from grader.gallery.models import models
from grader.gallery.pictures import pictures
from grader.model.cases import Case, ImageCase, TreeCase
from grader.model.counterexample import NodeTable
from grader.model.grade import Grade
from grader.model.trials import ImageTrial, Trial
from grader.model.views import Views
from grader.report.facts import remarked
from grader.run.session import Allowance, Engine

PATH_SECONDS = 2.0
"""CPU seconds for the path of one ray through the largest scene."""


LEAST_SECONDS = 5.0
"""Wall time that drawing takes on a busy machine, without a second for the submission."""


class Gallery:
    """The pictures and trees of one submission."""

    def __init__(self, engine: Engine, own: Path | None = None) -> None:
        """Begin with nothing.

        Args:
            engine: Traces shadow rays.
            own: A course's own folder of scenes, used beside the shipped one.
        """
        self._engine = engine
        self._hung = {one.scene.name: one for one in hung(own)}
        self._meshes = {one.scene.mesh for one in self._hung.values()}
        self._seen: dict[str, ImageCase] = {}
        self._trees: dict[str, TreeCase] = {}

    def note(self, case: Case) -> None:
        """Keep a case if something can be drawn from it."""
        if isinstance(case, ImageCase):
            self._seen[case.name] = case
        elif isinstance(case, TreeCase) and case.name in self._meshes:
            self._trees[case.name] = case

    def shown(self, grade: Grade, trials: Sequence[Trial], seconds: float) -> Grade:
        """Add the views to a grade.

        Args:
            grade: All decided.
            trials: The plan's.
            seconds: Wall time that is left of the whole grade.
        """
        if seconds < LEAST_SECONDS:
            return remarked(grade, "nothing was drawn: the time of the whole grade was used up")
        try:
            return replace(grade, views=self._views(grade, trials, seconds - LEAST_SECONDS))
        except Exception as fault:  # noqa: BLE001 - nothing is decided here: it costs the pictures
            let_go(fault)
            name = type(fault).__name__
            told = f"nothing could be drawn, which is our own fault ({name}) and costs no point"
            return remarked(grade, told)

    def _views(self, grade: Grade, trials: Sequence[Trial], seconds: float) -> Views:
        # What a rubric hides is in no report, whoever reads it.
        asked = [one for one in trials if isinstance(one, ImageTrial) and one.shown]
        exhibits = [self._exhibit(one) for one in asked if one.name in self._hung]
        allowed = Allowance(min(PATH_SECONDS, seconds / 4), seconds / 4)
        return Views(
            pictures(exhibits, self._engine, seconds / 2),
            models(grade, exhibits, self._engine, allowed),
            tuple(_tables(grade)),
        )

    def _exhibit(self, trial: ImageTrial) -> Exhibit:
        place = self._hung[trial.name]
        tree = self._trees.get(place.scene.mesh)
        return Exhibit(place, trial, self._seen.get(trial.name), tree)


def _tables(grade: Grade) -> Iterator[tuple[str, NodeTable]]:
    """Return the trees that are small enough to be read node by node."""
    for score in grade.checks:
        found = score.counterexample
        if found is not None and found.table is not None:
            yield score.check, found.table
