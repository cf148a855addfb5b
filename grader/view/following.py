"""How is the way of one ray asked for, and what if no answer comes?"""

from dataclasses import dataclass, replace

from grader.model.mesh import Mesh
from grader.view.stage import Stage, State
from grader.view.walking import Followed, Walk, unanswered, walk_of


@dataclass(frozen=True, slots=True)
class _Asked:
    """A ray whose way was asked for."""

    row: int
    of: Followed


@dataclass(frozen=True, slots=True)
class Place:
    """What was looked at when another process took over."""

    mesh: Mesh
    node: int
    """-1 if it was none."""

    ray: Followed | None


class Following:
    """At most one ray of a stage whose way is still to come; a newer one takes its place."""

    def __init__(self) -> None:
        """Ask for nothing."""
        self._asked: _Asked | None = None

    @property
    def pending(self) -> Followed | None:
        """The ray whose answer is still to come."""
        return self._asked.of if self._asked else None

    def forget(self) -> None:
        """Wait for nothing any more."""
        self._asked = None

    def ask(self, stage: Stage, of: Followed) -> bool:
        """Ask for the way of a ray; tells whether the process takes questions."""
        if stage.state is not State.TRACING:
            return False
        self._asked = _Asked(stage.record(of.ray, of.title), of)
        return True

    def take(self, stage: Stage) -> tuple[Followed, Walk] | None:
        """Return what came; a ray that gets no answer any more has no steps."""
        asked, tree = self._asked, stage.tree
        if asked is None or tree is None:
            return None
        if stage.live.rows_done > asked.row:
            self._asked = None
            return asked.of, walk_of(stage.subject.mesh, tree, stage.live.walk(), asked.of)
        if stage.state is not State.ENDED:
            return None
        self._asked = None
        return asked.of, unanswered(asked.of)


def again(of: Followed) -> Followed:
    """The same ray for another build; what was known of the old one's picture is gone."""
    return replace(of, note="")
