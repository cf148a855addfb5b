"""`check --hints 0` tells the facts and nothing else, in the terminal and on the page."""

import json
from html import unescape
from pathlib import Path

import pytest

from grader.report.hints import told
from tests.cli.calls import FILE, WRITTEN, Pipeline, call
from tests.report import samples

CAUSE = "A child gets the box of its parent."
QUESTION = told()["bvh.boxes-are-tight"]["question"]


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
