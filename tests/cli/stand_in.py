"""A whole `bvhgrade` process whose pipeline answers without building anything.

The first argument names a sample, or `sleep` for a grading that never ends.
"""

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from grader.cli import main
from grader.model.grade import Grade
from tests.report import samples


@dataclass(frozen=True, slots=True)
class Options:
    """The pipeline's options."""

    seed: int
    rubric: Path | None
    only: tuple[str, ...]
    progress: Callable[[str, int, int], None]
    time_limit: float | None
    counterexamples: bool
    hidden: bool
    isolated: bool


class Pipeline(ModuleType):
    """Stands in for the pipeline's module."""

    def __init__(self, sample: str) -> None:
        super().__init__("grader.pipeline")
        self.Options = Options
        self.sample = sample

    def grade_one(self, path: Path, options: Options) -> Grade:
        """Answer with a sample."""
        options.progress("tracing [red]rays[/red]", 1, 4)
        if self.sample == "sleep":
            Path("ready").touch()
            time.sleep(600)
        return samples.EVERY[self.sample]()


if __name__ == "__main__":
    sys.modules["grader.pipeline"] = Pipeline(sys.argv.pop(1))
    main()
