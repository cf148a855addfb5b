"""A fault of ours costs what nothing hangs on, and no test overlooks it."""

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import NoReturn, cast

import pytest

from grader.counterexample import search
from grader.diagnose import every_hypothesis
from grader.diagnose.causes import weigh
from grader.diagnose.hypothesis import Support
from grader.diagnose.notes import Notes
from grader.errors import Interrupted
from grader.gallery.gallery import Gallery
from grader.kept import kept
from grader.run.session import Engine
from grader.run.trials import Engines
from grader.solution import Solution
from tests.gallery.shown import some_views
from tests.report import samples

Patch = pytest.MonkeyPatch
Guarded = Callable[[Patch, Callable[..., NoReturn]], bool]
"""Breaks something within a guard; tells whether nothing else was lost."""

NOBODY = cast("Engine", None)


def ours(*_: object) -> NoReturn:
    """Fail for our own reason.

    Raises:
        RuntimeError: Always.
    """
    raise RuntimeError("ours")


def interrupted(*_: object) -> NoReturn:
    """Have somebody press Ctrl-C.

    Raises:
        Interrupted: Always.
    """
    raise Interrupted


def example(patch: Patch, breaks: Callable[..., NoReturn]) -> bool:
    """Look for counterexamples."""
    patch.setattr(search, "counterexample", breaks)
    solution = cast("Solution", None)
    wanted = search.Search((), Engines(NOBODY), solution, 0.0, True, lambda _: False)
    checks = search.with_counterexamples(samples.failing(), wanted).checks
    return not any(one.counterexample for one in checks)


def hint(patch: Patch, breaks: Callable[..., NoReturn]) -> bool:
    """Try a hypothesis."""
    notes = cast("Notes", SimpleNamespace(of=lambda _: [None]))
    return weigh(replace(every_hypothesis()[0], decide=breaks), notes) == Support(0, 0)


def picture(patch: Patch, breaks: Callable[..., NoReturn]) -> bool:
    """Draw."""
    patch.setattr(Gallery, "_views", breaks)
    grade = samples.failing()
    return replace(Gallery(NOBODY).shown(grade, (), 60.0), build=grade.build) == grade


def attachment(patch: Patch, breaks: Callable[..., NoReturn]) -> bool:
    """Write down what is kept."""
    patch.setattr("grader.report.views.to_text", breaks)
    return not kept(replace(samples.perfect(), views=some_views())).attachments


guards = pytest.mark.parametrize("guarded", [example, hint, picture, attachment])


@guards
def test_a_fault_is_raised_in_tests(guarded: Guarded, monkeypatch: Patch) -> None:
    """Whatever a guard swallows elsewhere makes them red."""
    with pytest.raises(RuntimeError, match="ours"):
        guarded(monkeypatch, ours)


@guards
@pytest.mark.usefixtures("forgiving")
def test_a_fault_costs_an_extra(guarded: Guarded, monkeypatch: Patch) -> None:
    """Everything else of the grade is there."""
    assert guarded(monkeypatch, ours)


@guards
@pytest.mark.usefixtures("forgiving")
def test_no_guard_keeps_anybody_from_stopping(guarded: Guarded, monkeypatch: Patch) -> None:
    """Ctrl-C is no fault."""
    with pytest.raises(Interrupted):
        guarded(monkeypatch, interrupted)
