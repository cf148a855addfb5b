"""How does a teacher see a class being graded? As a live table, or as few lines in a pipe."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from rich.live import Live
    from rich.table import Table

    from grader.batch.records import Student

LINES = 20
"""How many lines a class takes in a pipe, whatever its size."""


class Lines:
    """Says now and then how far it is; what goes wrong is said at once."""

    def __init__(self) -> None:
        """Nothing was done yet."""
        self.done = self.total = 0

    def reading(self, done: int, total: int) -> None:
        """Say that everybody's file was read."""
        if done == total:
            self.say(f"read {total:,} submissions")

    def grading(self, total: int) -> None:
        """Say how much there is to do."""
        self.done, self.total = 0, total
        self.say(f"grading {total:,} different files")

    def stage(self, student: "Student", stage: str) -> None:
        """Say nothing."""

    def finished(self, student: "Student", score: float | None, most: float) -> None:
        """Say it of every twentieth part."""
        self.done += 1
        step = max(1, self.total // LINES)
        if self.done % step == 0 or self.done == self.total:
            self.say(f"{self.done:,} of {self.total:,}  {worded(student, score, most)}")

    def notice(self, sentence: str) -> None:
        """Say it at once."""
        self.say(sentence)

    def trouble(self, sentence: str) -> None:
        """Say it at once."""
        self.say(f"bvhgrade: {sentence}")

    def say(self, line: str) -> None:
        """Print one line on standard error."""
        click.echo(line_for_terminal(line), err=True)


class LiveTable(Lines):
    """Shows each clerk's submission and stage, how far the class is, and how fast."""

    def __init__(self, live: "Live", clock: Callable[[], float] = time.monotonic) -> None:
        """Take the place where it is shown."""
        super().__init__()
        self._live, self._clock = live, clock
        self._began = clock()
        self._withheld = 0
        self._stages: dict[str, tuple[str, str]] = {}

    def reading(self, done: int, total: int) -> None:
        """Show how many files were read."""
        self._live.update(f"reading {done:,} of {total:,}")

    def grading(self, total: int) -> None:
        """Begin to measure how fast it is."""
        super().grading(total)
        self._began, self._withheld = self._clock(), 0

    def stage(self, student: "Student", stage: str) -> None:
        """Show what happens to a submission."""
        self._stages[student.slug] = (student.told, stage)
        self._show()

    def finished(self, student: "Student", score: float | None, most: float) -> None:
        """Print the points above the table."""
        self.done += 1
        self._withheld += score is None
        self._stages.pop(student.slug, None)
        self.say(worded(student, score, most))
        self._show()

    def say(self, line: str) -> None:
        """Print one line above the table."""
        self._live.console.print(line_for_terminal(line), markup=False, highlight=False)

    def _show(self) -> None:
        from rich.console import Group
        from rich.text import Text

        # No title of the table: it would be broken to the width of few short names.
        self._live.update(Group(Text(self._state()), self._table()))

    def _state(self) -> str:
        """Count what is done, running and withheld; tell how fast it goes and how long yet."""
        parts = [f"{self.done:,} of {self.total:,} graded", f"{len(self._stages):,} running"]
        parts += [f"{self._withheld:,} withheld"]
        seconds = self._clock() - self._began
        if self.done and seconds > 0:
            parts += [f"{60 * self.done / seconds:.1f} a minute"]
            parts += [left((self.total - self.done) * seconds / self.done)]
        return ", ".join(parts)

    def _table(self) -> "Table":
        from rich.table import Table
        from rich.text import Text

        table = Table()
        table.add_column("submission", max_width=40, no_wrap=True)
        table.add_column("stage", min_width=20, no_wrap=True)
        for name, stage in list(self._stages.values()):
            table.add_row(Text(line_for_terminal(name)), Text(line_for_terminal(stage)))
        return table


def left(seconds: float) -> str:
    """Word how long it will take, as exactly as one knows."""
    minutes = round(seconds / 60)
    if minutes < 1:
        return "less than a minute left"
    hours, rest = divmod(minutes, 60)
    return f"about {f'{hours} h ' if hours else ''}{rest} min left"


def worded(student: "Student", score: float | None, most: float) -> str:
    """Word the points of a submission."""
    if score is None:
        return f"withheld  {student.told}"
    return f"{score:g} of {most:g}  {student.told}"


@contextmanager
def shown_class() -> Iterator[Lines]:
    """Show a class on standard error."""
    if not sys.stderr.isatty():
        yield Lines()
        return
    from rich.console import Console
    from rich.live import Live

    with Live(console=Console(stderr=True), transient=True, refresh_per_second=4) as live:
        yield LiveTable(live)
