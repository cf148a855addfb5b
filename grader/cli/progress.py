"""How a long grading shows that it is alive: one transient line, and only in a terminal."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from grader.report.escape import line_for_terminal

Progress = Callable[[str, int, int], None]


@contextmanager
def shown_progress() -> Iterator[Progress]:
    """Yield a callback that moves a bar on standard error, or does nothing in a pipe."""
    if not sys.stderr.isatty():
        yield silent
        return
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(bar_width=24),
        TimeElapsedColumn(),
    )
    with Bars(*columns, console=Console(stderr=True), transient=True) as bars:
        task = bars.add_task("starting", total=None)

        def move(stage: str, done: int, total: int) -> None:
            bars.update(
                task, description=line_for_terminal(stage), completed=done, total=total or None
            )

        yield move


@contextmanager
def shown(work: str) -> Iterator[None]:
    """Show in a terminal that work of one piece goes on."""
    with shown_progress() as progress:
        progress(work, 0, 0)
        yield


def silent(stage: str, done: int, total: int) -> None:
    """Show nothing."""
