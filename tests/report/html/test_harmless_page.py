"""A page runs nothing of a stranger's, and does not grow."""

import base64
import hashlib
import json
import re
from html import unescape
from typing import Any

import pytest

from grader.errors import OutputFault
from grader.report.as_json import to_json
from grader.report.html.page import joined
from grader.report.html.submission import to_html
from tests.report import samples
from tests.report.hostile import HOSTILE
from tests.report.html.pages import Reader, page_of, spoilt

BIGGEST_MODULE = 10_000


BIGGEST_PAGE = 600_000


BIGGEST_FRAME = 70_000
"""Bytes of a page without images and models."""


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_texts_bring_no_tag_and_no_script(name: str, views: dict[str, Any]) -> None:
    """Names, messages, compiler output and titles: the same tags as with harmless ones."""
    harmless = Reader(spoilt("harmless", views))
    other = Reader(spoilt(HOSTILE[name], views))
    kinds = [tag for tag in other.tags if tag[0] not in {"code", "p"}]
    assert kinds == [tag for tag in harmless.tags if tag[0] not in {"code", "p"}]


def test_the_policy_names_our_style_and_our_script(report: str) -> None:
    """By their hashes, and allows nothing else."""
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', report)
    parts = dict(part.strip().split(" ", 1) for part in unescape(policy).split(";"))
    assert parts["default-src"] == "'none'"
    assert parts["img-src"] == "data: blob:"
    for name, tag in (("style-src", "style"), ("script-src", "script")):
        (text,) = re.findall(rf"<{tag}>(.*?)</{tag}>", report, re.DOTALL)
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert parts[name] == f"'sha256-{digest}'"
    assert " style=" not in report
    assert " onload=" not in report


@pytest.mark.parametrize("bad", ['"><img src=x onerror=alert(1)>', "AAAA\n", "a b", "=AAA"])
def test_data_that_is_not_packed_is_refused(views: dict[str, Any], bad: str) -> None:
    """It stands in the page unescaped."""
    seen = json.loads(json.dumps(views))
    seen["pictures"][0]["images"]["cost"] = bad
    with pytest.raises(OutputFault, match="not base64"):
        to_html(to_json(samples.failing()), seen, "en")
    seen = json.loads(json.dumps(views))
    seen["models"][0]["mesh"]["data"] = bad
    with pytest.raises(OutputFault, match="not base64"):
        to_html(to_json(samples.failing()), seen, "en")


def test_too_large_views_are_refused(views: dict[str, Any]) -> None:
    """With both numbers."""
    seen = json.loads(json.dumps(views))
    seen["models"][0]["mesh"]["data"] = "A" * 900_000
    with pytest.raises(OutputFault, match="a page takes 900,000"):
        to_html(to_json(samples.failing()), seen, "en")


def test_the_page_of_the_dragon_is_small(report: str) -> None:
    """With 871,414 faces behind it; ours is a tenth of that."""
    assert len(report.encode()) <= BIGGEST_PAGE
    assert "871,414 faces" in report
    assert len(page_of("failing").encode()) <= BIGGEST_FRAME


def test_the_module_for_three_dimensions_is_small(report: str) -> None:
    """As it stands in the page."""
    module = joined(["space.js"])
    assert module in report
    assert len(module.encode()) <= BIGGEST_MODULE
