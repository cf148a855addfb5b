"""The report is read in another language, on paper, and where a browser can do less."""

import re
from typing import Any

from playwright.sync_api import Playwright, expect

from grader.model.views import Views
from grader.report.as_json import to_json
from grader.report.html.submission import to_html
from grader.report.views import to_json as views_json
from tests.browser import chromium
from tests.report import samples
from tests.report.html.conftest import Visit, ready
from tests.report.html.pages import spoilt
from tests.report.html.shown import flat_model


def test_the_script_speaks_german(visit: Visit, views: dict[str, Any]) -> None:
    """It names the scene, and counts the faces of its coarser mesh with a point."""
    page = ready(visit(to_html(to_json(samples.failing()), views, "de")))
    page.locator("#model").select_option("2")
    assert page.locator("#model option").nth(2).inner_text().startswith("Stanford-Drache, ")
    expect(page.locator("#told")).to_have_text(re.compile(r"gezeigt mit \d+\.\d{3} Dreiecken"))


def test_without_webgl_a_sentence_stands_there(
    playwright: Playwright, visit: Visit, report: str
) -> None:
    """And the steps of the ray can still be read."""
    blind = playwright.chromium.launch(executable_path=chromium(), args=["--disable-3d-apis"])
    page = ready(visit(report, within=blind))
    expect(page.get_by_text("This browser has no WebGL 2")).to_be_visible()
    expect(page.locator("#stage")).to_be_hidden()
    page.locator("#model").select_option("1")
    expect(page.locator("#steps li").first).to_have_text("box of node 0: hit")
    blind.close()


def test_paper_shows_everything(visit: Visit, report: str) -> None:
    """Both pictures side by side, failures unfolded, no controls."""
    page = ready(visit(report))
    folded = page.locator(".failure").nth(1).locator(".happened")
    expect(folded).to_be_hidden()
    page.emulate_media(media="print")
    expect(folded).to_be_visible()
    expect(page.locator(".copy img").first).to_be_visible()
    expect(page.locator(".compare input").first).to_be_hidden()
    expect(page.locator("#drawn")).to_be_hidden()
    whole = page.locator(".yours").first.evaluate("one => getComputedStyle(one).clipPath")
    assert whole == "none"
    assert page.pdf().startswith(b"%PDF")


def test_the_page_says_what_is_wrong_without_javascript(visit: Visit, report: str) -> None:
    """Failures, images and table need none; the view says that it does."""
    page = visit(report, java_script_enabled=False)
    expect(page.locator(".happened").first).to_be_visible()
    expect(page.locator(".reference").first).to_be_visible()
    expect(page.get_by_text("The 3D view needs JavaScript.")).to_be_visible()


def test_a_model_without_extent_is_no_error(visit: Visit, views: dict[str, Any]) -> None:
    """A mesh in one point and a tree of empty slots."""
    flat = views_json(Views(pictures=(), models=(flat_model(),)))
    page = ready(visit(to_html(to_json(samples.failing()), flat, "en")))
    expect(page.locator("#told")).to_contain_text("node 2")


def test_hostile_texts_stay_texts(visit: Visit, views: dict[str, Any]) -> None:
    """Nothing of them runs or changes the page, in HTML or in what the script writes."""
    bad = '</script><b>x</b><img src=x onerror="document.title=1">'
    page = ready(visit(spoilt(bad, views)))
    page.locator("#model").select_option("1")
    expect(page.locator("#told")).to_contain_text(bad)
    expect(page.locator("h1")).to_have_text(bad)
    assert page.locator("main b:not(.messages b)").count() == 0
    assert page.locator("main img[onerror]").count() == 0
    assert page.title() == f"BVH exercise: {bad}"
