"""How does `check --watch` go on? It grades at every save, and tells one problem at a time.

Theory of operation. What is handed in is read and hashed several times a second, so that it
does not matter how an editor saves: in place, by renaming another file over it, or by deleting
it first. It counts as saved once two looks in a row agree. A save during a run ends that run,
whose result is dropped. After a failure the next save runs the failed check only; once that one
passes, everything is run again to find the next one.
"""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from grader.errors import Interrupted, UsageError
from grader.intake.saved import GLANCE_SECONDS, GONE, state_of
from grader.model.grade import Grade
from grader.model.verdict import Verdict
from grader.report.facts import worst
from grader.sandbox.launch import start_again, stop_everything

if TYPE_CHECKING:
    from grader.cli.order import Order


@dataclass(frozen=True, slots=True)
class Watch:
    """What a watch does at every save."""

    grade: "Callable[[Order], Grade]"
    tell: "Callable[[Grade, Order], None]"
    """Prints the worst problem of a grade."""


def watch(order: "Order", actions: Watch) -> NoReturn:
    """Grade at every save until it is interrupted.

    Raises:
        KeyboardInterrupt: Somebody pressed Ctrl-C.
        GraderError: Our own fault.
    """
    focus: tuple[str, ...] = ()
    seen = settled(order.path, GONE)
    while True:
        this = replace(order, only=focus or order.only)
        result = undisturbed(seen, this, actions.grade)
        if result is None:
            seen = settled(order.path, GONE)
            continue
        if focus and not fails(result, focus[0]):
            focus = ()
            continue
        actions.tell(result, this)
        problem = worst(result)
        focus = (problem.check,) if problem else ()
        seen = settled(order.path, seen)


def settled(path: Path, before: str) -> str:
    """Wait until something else than `before` is there and stays the same for two looks."""
    last = GONE
    while True:
        now = state_of(path)
        if now == last and now not in (GONE, before):
            return now
        last = now
        time.sleep(GLANCE_SECONDS)


def undisturbed(seen: str, order: "Order", grade: "Callable[[Order], Grade]") -> Grade | None:
    """Grade what was seen; None if it was saved again before the end."""
    with ended_by_a_save(order.path, seen) as saved:
        try:
            result = patient(order, grade)
        except Interrupted:
            if not saved.is_set():
                raise
            return None
    return None if saved.is_set() else result


def patient(order: "Order", grade: "Callable[[Order], Grade]") -> Grade:
    """Grade, even if the file is away at the very moment when it is read."""
    try:
        return grade(order)
    except UsageError:
        settled(order.path, GONE)
        # If this one fails too, it is not because of the file.
        return grade(order)


@contextmanager
def ended_by_a_save(path: Path, seen: str) -> Iterator[threading.Event]:
    """End every process of a run as soon as something else than `seen` was saved."""
    saved, over = threading.Event(), threading.Event()

    def look() -> None:
        while not over.wait(GLANCE_SECONDS):
            if state_of(path) not in (GONE, seen):
                saved.set()
                stop_everything()
                return

    looking = threading.Thread(target=look, daemon=True)
    looking.start()
    try:
        yield saved
    finally:
        over.set()
        looking.join()
    if saved.is_set():
        start_again()


def fails(result: Grade, check: str) -> bool:
    """Tell whether a check surely still fails."""
    verdicts = {score.check: score.verdict for score in result.checks}
    return verdicts.get(check) is Verdict.FAIL
