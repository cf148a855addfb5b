"""How does a caller want a submission graded?"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grader.model.grade import Limits

Progress = Callable[[str, int, int], None]
"""Is told a stage, and how much of it is done out of how much; zeros if nobody counts."""


@dataclass(frozen=True, slots=True)
class Options:
    """How to grade."""

    seed: int
    rubric: Path | None
    only: tuple[str, ...]
    """Ids of the checks to run; empty for all."""

    progress: Progress
    time_limit: float | None = None
    """Wall seconds after which the grade is there, whatever the submission does; None takes
    the rubric's."""

    counterexamples: bool = False
    """Whether to look for the smallest input that fails each check that failed."""

    views: bool = False
    """Whether to draw what a report shows: pictures, and models to be turned."""

    isolated: bool = True
    """False only if the caller insists on running code without isolation."""

    for_student: bool = False
    """Leave out whatever the rubric hides from students."""

    quick: bool = False
    """Leave out the trials that take long: sanitizers, pictures, threads and large meshes."""

    def most_seconds(self, limits: Limits) -> float:
        """Wall seconds of a whole grade."""
        return self.time_limit or limits.total_seconds
