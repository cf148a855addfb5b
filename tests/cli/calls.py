"""Calls of the command line in this process, with a pipeline that says what a test wants."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

from click.testing import CliRunner, Result

from grader.cli import cli
from grader.model.grade import Grade
from grader.options import Options
from tests.report import samples

FILE = "src/exercise03.cpp"
WRITTEN = "bvhgrade-out/result.json"


class Pipeline(ModuleType):
    """Stands in for the pipeline's module and remembers what it was asked."""

    def __init__(self) -> None:
        super().__init__("grader.pipeline")
        self.asked: list[tuple[Path, Options]] = []
        self.answer: Callable[[], Grade] = samples.perfect

    def grade_one(self, path: Path, options: Options) -> Grade:
        """Answer with a grade made by hand."""
        self.asked.append((path, options))
        options.progress("building", 1, 3)
        return self.answer()

    def fail(self, fault: BaseException) -> None:
        """Raise instead of answering."""

        def answer() -> Grade:
            raise fault

        self.answer = answer


class Waiting:
    """Stands in for the line that shows in a terminal that work goes on."""

    def __init__(self) -> None:
        self.works: list[str] = []
        self.is_over = False

    @contextmanager
    def shown(self, work: str) -> Iterator[None]:
        """Remember what was shown, and whether it vanished."""
        self.works.append(work)
        yield
        self.is_over = True


def call(*words: str) -> Result:
    """Run the command line in this process."""
    return CliRunner().invoke(cli, words)
