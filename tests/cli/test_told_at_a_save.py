"""What `check --watch` says claims no more than was run, and every note is told."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from grader.cli.order import Order
from grader.cli.watching import Watch
from grader.model.grade import Grade
from tests.cli.calls import FILE, Pipeline, call
from tests.report import samples
from tests.test_selection import hiding

QUICK = "This was the quick run; without --quick every check is run."
CHECK = "bvh.boxes-are-tight"

Told = Callable[..., str]


@pytest.fixture
def told(pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch) -> Told:
    """Tell of one run of a watch."""
    del pipeline

    def say(grade: Grade, *words: str) -> str:
        def once(order: Order, actions: Watch) -> NoReturn:
            actions.tell(grade, order)
            raise KeyboardInterrupt

        monkeypatch.setattr("grader.cli.watching.watch", once)
        return " ".join(call("check", FILE, "--watch", *words).output.split())

    return say


def test_everything_passes_where_everything_was_run(told: Told) -> None:
    """And nothing else is to be said."""
    output = told(samples.perfect())
    assert "Everything passes." in output
    assert QUICK not in output


@pytest.mark.parametrize("words", [["--quick"], ["--only", CHECK]])
def test_some_checks_are_not_everything(told: Told, words: list[str]) -> None:
    """Their number is told, and which option left out the others."""
    grade = samples.perfect()
    output = told(grade, *words)
    assert f"All {len(grade.checks)} checks of this run pass." in output
    assert "Everything" not in output
    assert (QUICK in output) == ("--quick" in words)


def test_one_check_is_told_as_one(told: Told) -> None:
    """Not as all of several."""
    grade = samples.perfect()
    assert "The check of this run passes." in told(
        replace(grade, checks=grade.checks[:1]), "--only", CHECK
    )


def test_what_waits_is_told_to_be_shown_later(told: Told) -> None:
    """As many as fail besides, and when."""
    two = "2 more checks fail; they are shown once this one passes."
    assert two in told(samples.failing())
    one = "1 more check fails; it is shown once this one passes."
    assert one in told(samples.changed(c5=samples.loose_boxes(), c8=samples.crash()))


def test_what_the_rubric_hides_was_not_run(told: Told, tmp_path: Path) -> None:
    """A note of the build is told at every save; nothing is called everything."""
    hidden = f"the rubric hides these checks, so they were not run: {CHECK}"
    build = replace(samples.BUILD, remarks=(hidden,))
    grade = replace(samples.perfect(), build=build)
    output = told(grade, "--rubric", str(hiding(tmp_path, CHECK)))
    assert "checks of this run pass." in output
    assert f"Note: {hidden}." in output


def test_a_note_is_told_beside_a_failure(told: Told) -> None:
    """Whatever failed."""
    for grade in (samples.failing(), samples.uncompiled()):
        assert grade.build
        build = replace(grade.build, remarks=("it prints a lot",))
        assert "Note: it prints a lot." in told(replace(grade, build=build), "--quick")
