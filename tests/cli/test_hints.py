"""`check --hints 0` tells the facts and nothing else, in the terminal and on the page."""

import json
from html import unescape
from pathlib import Path

import pytest

from grader.cli.order import Order
from grader.cli.watching import Watch
from grader.report.facts import BEGIN
from grader.report.hints import told
from tests.cli.calls import FILE, WRITTEN, Pipeline, call
from tests.report import samples

CAUSE = "A child gets the box of its parent."
QUESTION = told()["bvh.boxes-are-tight"]["question"]


def test_the_next_call_keeps_language_and_hints(
    pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """But `--replay` refuses hints; and what is usual anyway is not written."""
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
    monkeypatch.setenv("COLUMNS", "200")
    pipeline.answer = samples.failing
    printed = call("check", FILE, "--hints", "3", "--language", "de").output
    again = f"bvhgrade check {FILE} --seed 41 --language de"
    assert f"{again} --only hits.closest-wins --hints 3\n" in printed
    assert f"{again} --replay bvhgrade-out/counterexamples/hits.closest-wins.json\n" in printed
    assert f"bvhgrade view {FILE} --language de --check bvhgrade-out/" in printed
    printed = call("check", FILE, "--hints", "1", "--language", "en").output
    assert f"bvhgrade check {FILE} --seed 41 --only hits.closest-wins\n" in printed


@pytest.mark.parametrize("more", [[], ["--watch"]])
@pytest.mark.parametrize(("step", "is_told"), [("0", False), ("1", True)])
def test_the_starter_is_told_where_to_begin(
    pipeline: Pipeline,
    monkeypatch: pytest.MonkeyPatch,
    more: list[str],
    step: str,
    is_told: bool,
) -> None:
    """In the terminal, after a save, and on the page: no failure says it."""
    pipeline.answer = samples.starter
    monkeypatch.setattr("grader.cli.watching.watch", once)
    printed = call("check", FILE, "--hints", step, *more).output
    page = unescape(Path("bvhgrade-out/report.html").read_text())
    for text in (printed, page):
        assert (BEGIN in text) == is_told


def once(order: Order, actions: Watch) -> None:
    """Tell of one run of a watch."""
    actions.tell(actions.grade(order), order)


@pytest.mark.parametrize(("step", "is_told"), [("0", False), ("1", True), ("3", True)])
def test_a_page_has_hints_if_they_were_asked_for(
    pipeline: Pipeline, step: str, is_told: bool
) -> None:
    """The page lets a reader unfold them; `result.json` has the cause, as for everybody."""
    pipeline.answer = samples.failing
    call("check", FILE, "--hints", step)
    page = unescape(Path("bvhgrade-out/report.html").read_text())
    for text in (CAUSE, QUESTION):
        assert (text in page) == is_told, text
    assert "node 1 box.max = (1.25, 1, 0)" in page
    hints = [one["hint"] for one in json.loads(Path(WRITTEN).read_text())["checks"]]
    assert any(CAUSE in hint for hint in hints)
