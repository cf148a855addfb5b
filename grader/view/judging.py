"""The nodes of a tree are judged aside, while somebody already looks at it."""

from concurrent.futures import Future, ThreadPoolExecutor

from grader.errors import GraderError
from grader.model.mesh import Bvh
from grader.view.aside import outcome
from grader.view.inspector import Judgement, judgement
from grader.view.stage import Stage

JUDGED_AT_ONCE = 50_000
"""Faces of a mesh; the nodes of a larger tree are judged once somebody looks at one."""


class Judging:
    """What is known of the nodes of one tree after the other."""

    def __init__(self) -> None:
        """Judge nothing yet."""
        self._aside = ThreadPoolExecutor(1)
        self._coming: Future[Judgement] | None = None
        self._of: Bvh | None = None
        self.known: Judgement | None = None
        self.failed = ""
        """Why nothing will be known, which is our fault; empty if nothing is in the way."""

    @property
    def is_busy(self) -> bool:
        """Whether a judgement is still to come."""
        return self._coming is not None

    def close(self) -> None:
        """End the thread."""
        self._aside.shutdown(wait=True, cancel_futures=True)

    def forget(self) -> None:
        """Know nothing any more."""
        self._coming = self._of = self.known = None
        self.failed = ""

    def advance(self, stage: Stage, wanted: bool) -> bool:
        """Have the stage's tree judged; tells whether it just was.

        Args:
            stage: What is looked at.
            wanted: Whether somebody looks at a node, so that a large tree is judged, too.
        """
        # A tree that the subject brings along is ours, and may be altered on purpose.
        mesh = stage.subject.mesh
        tree = stage.tree if stage.subject.tree is None else None
        wanted = wanted or len(mesh.faces) <= JUDGED_AT_ONCE
        if tree is not None and self._of is not tree and wanted:
            self._of = tree
            self._coming = self._aside.submit(judgement, mesh, tree)
        if self._coming is None or not self._coming.done():
            return False
        coming, self._coming = self._coming, None
        came = outcome(coming)
        if isinstance(came, GraderError):
            self.failed = str(came)
        else:
            self.known = came
        return True
