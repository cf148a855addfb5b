"""Everything that the viewer knows, whoever shows it: a window, a page or a file.

It is looked at many times a second and never waits: compiling and loading go on in threads, the
submission in a process of its own. Whatever they do, the desk stays.
"""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import replace
from enum import Enum
from pathlib import Path

from grader.errors import GraderError
from grader.model.mesh import Bvh, Mesh
from grader.options import Options
from grader.run.session import Engine
from grader.sandbox.launch import start_again, stop_everything
from grader.sandbox.nursery import Nursery
from grader.solution import Solution
from grader.view.aside import outcome
from grader.view.boxes import deepest_of
from grader.view.builds import Builds
from grader.view.camera import Orbit
from grader.view.stage import Stage, State, fitting
from grader.view.subject import Subject, of_scene, own_scenes
from grader.view.thinned import thinned
from grader.view.workshop import Product, our_own

USUAL_LEVEL = 6

Load = Callable[[], Subject]


class Mode(Enum):
    """What the right pane shows."""

    SHADED = "shaded"
    COST = "cost"
    REFERENCE = "reference"
    DIFFERENCE = "difference"


COMPARING = (Mode.REFERENCE, Mode.DIFFERENCE)


class Desk:
    """One submission that is looked at; use it as a context, from one thread."""

    subjects = 0
    """Counts subjects, so that a pane notices another one."""

    size = 512, 512
    """Of what is traced, in pixels; the right pane may have more."""

    mode = Mode.SHADED
    level, only = USUAL_LEVEL, False

    def __init__(self, path: Path, options: Options, first: Load) -> None:
        """Begin to compile and to load.

        Args:
            path: The submission.
            options: The rubric and the isolation.
            first: Loads what is shown first.
        """
        self.path, self._options = path, options
        self._held, self._aside = ExitStack(), ThreadPoolExecutor(2)
        self._nursery = self._held.enter_context(Nursery())
        self._builds = Builds(path, options, self._aside)
        self.product: Product | None = None
        """The last build; None as long as there is none."""

        self._model: Engine | None = None
        """The model solution's, once it was wanted."""

        self.subject: Subject | None = None
        self.light: Mesh | None = None
        """A coarser mesh of the subject, for while the camera moves."""

        self.stage: Stage | None = None
        self.rival: Stage | None = None
        """The model solution on the same subject, while it is compared."""

        self.orbit: Orbit | None = None
        self._faults: dict[str, GraderError] = {}
        """By what could not be done: `load`, `build`, `compare` or `run`."""

        self._loading: Future[tuple[Subject, Mesh]] | None = self._aside.submit(_loaded, first)
        self._growing: Future[Bvh] | None = None
        self._comparing: Future[Engine] | None = None
        self.rebuild()

    def __enter__(self) -> "Desk":
        """Begin the block."""
        return self

    def __exit__(self, *_: object) -> None:
        """End every process and thread."""
        self._builds.end()
        # Nobody waits for a compiler, or for a search, when the window is closed.
        stop_everything()
        self._aside.shutdown(wait=True, cancel_futures=True)
        self._clear()
        self._builds.close()
        self._held.close()
        start_again()

    def choose(self, load: Load) -> None:
        """Show something else, once it is loaded."""
        self._faults.pop("load", None)
        self._loading = self._aside.submit(_loaded, load)

    def choose_scene(self, name: str) -> None:
        """Show a stored scene."""
        self.choose(lambda: of_scene(name, own_scenes(self._options)))

    def rebuild(self) -> None:
        """Compile what lies there now."""
        self._faults.pop("build", None)
        self._builds.begin()

    @property
    def fault(self) -> GraderError | None:
        """What could not be done, for our own reason or because of what was asked for."""
        return next(iter(self._faults.values()), None)

    @property
    def lacks_tree(self) -> bool:
        """Whether the submission made no tree, so that the model solution's is to come."""
        stage = self.stage
        if stage is None or not stage.in_construct:
            return False
        return stage.subject.tree is None and not stage.subject.check

    @property
    def is_building(self) -> bool:
        """Whether it is being compiled."""
        return self._builds.is_busy

    @property
    def is_loading(self) -> bool:
        """Whether something else is being loaded, or the model solution to compare with."""
        return self._loading is not None or self._comparing is not None

    @property
    def deepest(self) -> int:
        """The last level of boxes; -1 if there is no tree."""
        return deepest_of(self.stage.tree) if self.stage else -1

    def advance(self) -> bool:
        """Take what is finished; tells whether anything is to be shown anew."""
        changed = self._take_subject() | self._take_product() | self._take_model()
        if self._builds.is_stale:
            self.rebuild()
            changed = True
        for stage in self._tracing():
            changed |= self._advance(stage)
        return changed | self._substitute()

    def run_again(self) -> None:
        """Begin anew with the submission, after it ended."""
        self._restart()

    def look(self, orbit: Orbit) -> None:
        """Move the camera."""
        self.orbit = orbit
        self._show()

    def resize(self, width: int, height: int) -> None:
        """Have another size, in fewer pixels if those are too many to be traced."""
        if width > 0 and height > 0 and fitting(width, height) != self.size:
            self.size = fitting(width, height)
            self._show()

    def compare(self, mode: Mode) -> None:
        """Choose what the right pane shows; the model solution is only run if it is wanted."""
        compared, self.mode = self.mode in COMPARING, mode
        self._faults.pop("compare", None)
        if mode not in COMPARING or self.subject is None:
            return
        if self._model is None:
            self._comparing = self._comparing or self._aside.submit(our_own, self._nursery)
        elif self.rival is None or not compared:
            self.rival = self.rival or self._staged("compare", self.subject, self._model)
            # As long as nobody compared it was shown no other view.
            if self.rival is not None and self.orbit is not None:
                self.rival.show(self.orbit, *self.size)

    def _take_model(self) -> bool:
        if self._comparing is None or not self._comparing.done():
            return False
        came, self._comparing = outcome(self._comparing), None
        if isinstance(came, GraderError):
            self._faults["compare"] = came
            return True
        self._model = came
        self.compare(self.mode)
        return True

    def _tracing(self) -> list[Stage]:
        """Those that take processor time: the model solution only while it is compared."""
        rival = self.rival if self.mode in COMPARING else None
        return [one for one in (self.stage, rival) if one is not None]

    def _advance(self, stage: Stage) -> bool:
        before = stage.state
        try:
            painted = stage.advance()
        except GraderError as fault:
            self._faults["run"] = fault
            stage.state = State.ENDED
            return True
        return painted or stage.state is not before

    def _substitute(self) -> bool:
        """Trace on the model solution's tree where the submission made none."""
        stage = self.stage
        if stage is None or not self.lacks_tree:
            return False
        if self._growing is None:
            mesh = stage.subject.mesh
            self._growing = self._aside.submit(lambda: Solution().trees([mesh])[0])
        if not self._growing.done():
            return False
        came, self._growing = outcome(self._growing), None
        if isinstance(came, GraderError):
            stage.in_construct, self._faults["run"] = False, came
            return True
        self._clear()
        if self._builds.engine is not None:
            subject = replace(stage.subject, tree=came)
            self.stage = self._staged("run", subject, self._builds.engine, stage.trouble)
            self.compare(self.mode)
            self._show()
        return True

    def _show(self) -> None:
        for stage in self._tracing():
            if self.orbit is not None:
                stage.show(self.orbit, *self.size)

    def _take_subject(self) -> bool:
        if self._loading is None or not self._loading.done():
            return False
        came, self._loading = outcome(self._loading), None
        if isinstance(came, GraderError):
            self._faults["load"] = came
            return True
        self.subject, self.light = came
        self.orbit = self.subject.home
        self.subjects += 1
        self._restart()
        return True

    def _take_product(self) -> bool:
        came = self._builds.take()
        if isinstance(came, GraderError):
            self._faults["build"] = came
        elif came is not None:
            self.product = came
            # What does not compile leaves on the stage what did.
            if came.engine is not None:
                self._restart()
                self._builds.settle()
        return came is not None

    def _restart(self) -> None:
        """Have the submission begin anew with what is shown."""
        self._clear()
        self._faults.pop("run", None)
        if self.subject is None or self._builds.engine is None:
            return
        self.stage = self._staged("run", self.subject, self._builds.engine)
        self.compare(self.mode)
        self._show()

    def _staged(
        self, place: str, subject: Subject, engine: Engine, before: str = ""
    ) -> Stage | None:
        """Start a process; None if that fails, which is then told and no end of the window."""
        try:
            return Stage(subject, engine, before)
        except GraderError as fault:
            self._faults[place] = fault
            return None

    def _clear(self) -> None:
        for stage in (self.stage, self.rival):
            if stage is not None:
                stage.close()
        self.stage = self.rival = self._growing = None


def _loaded(load: Load) -> tuple[Subject, Mesh]:
    subject = load()
    return subject, thinned(subject.mesh)
