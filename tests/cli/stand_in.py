"""A whole `bvhgrade` process whose pipeline answers without building anything.

The first argument names a sample, or `sleep` for a grading that never ends, or `content` for
what the submission's text says: a sample, or `long` for a process that is waited for.
"""

import os
import sys
import time
from dataclasses import replace
from pathlib import Path
from types import ModuleType

from grader.cli import main
from grader.model.grade import Grade
from grader.options import Options
from grader.sandbox.launch import Order, launch
from tests.report import samples


class Pipeline(ModuleType):
    """Stands in for the pipeline's module."""

    def __init__(self, sample: str) -> None:
        super().__init__("grader.pipeline")
        self.sample = sample

    def grade_one(self, path: Path, options: Options) -> Grade:
        """Answer with a sample."""
        options.progress("tracing [red]rays[/red]", 1, 4)
        if self.sample == "sleep":
            Path("ready").touch()
            time.sleep(600)
        if self.sample == "content":
            return told_by(path, options)
        return samples.EVERY[self.sample]()


def told_by(path: Path, options: Options) -> Grade:
    """Answer as the file says, and write down what was asked."""
    sample = path.read_text()
    with Path("asked").open("a") as file:
        file.write(f"{sample} {','.join(options.only) or 'all'}\n")
    while sample == "long":
        # Like no other process of this machine, and too long to be waited for.
        words = ["sleep", f"600.{os.getpid()}"]
        Path("waits").write_text(" ".join(words))
        launch(Order(words, 600.0))
    grade = samples.EVERY[sample]()
    only = options.only or tuple(score.check for score in grade.checks)
    return replace(grade, checks=tuple(one for one in grade.checks if one.check in only))


if __name__ == "__main__":
    sys.modules["grader.pipeline"] = Pipeline(sys.argv.pop(1))
    main()
