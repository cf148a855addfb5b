"""A student opens the report from disk and understands it: by mouse, by keyboard, on paper."""

import io
import json
import re
from typing import Any

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from PIL import Image
from playwright.sync_api import Locator, Page, Playwright, expect

from grader.model.views import Views
from grader.report.as_json import to_json
from grader.report.html.submission import to_html
from grader.report.views import to_json as views_json
from tests.browser import chromium
from tests.report import samples
from tests.report.html.conftest import Visit
from tests.report.html.pages import spoilt
from tests.report.html.shown import flat_model, undrawn_views

RED, GREEN = (0, 85), (1, 55)
"""Channels of a wrong box and of what it should be, and how far each outshines the others."""

EDGE = 6
"""Pixels in which a browser draws who has the focus."""


def ready(page: Page) -> Page:
    """Wait until a model is shown."""
    page.locator("#room[data-shown]").wait_for()
    return page


def picture(place: Locator) -> Image.Image:
    """Take a picture of an element, without its edge."""
    image = Image.open(io.BytesIO(place.screenshot())).convert("RGB")
    return image.crop((EDGE, EDGE, image.width - EDGE, image.height - EDGE))


def pixels(image: Image.Image, colour: tuple[int, int]) -> int:
    """Count pixels in which one channel outshines both others."""
    channel, least = colour
    values = np.asarray(image, np.int16)
    others = np.delete(values, channel, axis=2).max(axis=2)
    return int((values[..., channel] - others > least).sum())


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nobody_is_shut_out(visit: Visit, report: str, scheme: str) -> None:
    """An audit by axe finds neither too little contrast nor a control without a name."""
    page = ready(visit(report, color_scheme=scheme))
    for details in page.locator("details").all():
        details.evaluate("one => { one.open = true; }")
    found = Axe().run(page)
    assert found.violations_count == 0, found.generate_report()


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize("name", ["broken", "starter", "uncompiled", "rejected", "perfect"])
def test_every_ending_is_a_page(visit: Visit, name: str) -> None:
    """Whatever there is to tell, axe and the browser have nothing against it."""
    seen = undrawn_views() if name in {"starter", "broken"} else None
    page = visit(to_html(to_json(samples.EVERY[name]()), seen, "de"))
    found = Axe().run(page)
    assert found.violations_count == 0, found.generate_report()
    assert page.locator("html").get_attribute("lang") == "de"


def test_the_script_speaks_german(visit: Visit, views: dict[str, Any]) -> None:
    """It names the scene, and counts the faces of its coarser mesh with a point."""
    page = ready(visit(to_html(to_json(samples.failing()), views, "de")))
    page.locator("#model").select_option("2")
    assert page.locator("#model option").nth(2).inner_text().startswith("Stanford-Drache, ")
    expect(page.locator("#told")).to_have_text(re.compile(r"gezeigt mit \d+\.\d{3} Dreiecken"))


@pytest.mark.parametrize("width", [360, 800, 1400])
def test_the_page_fits(visit: Visit, report: str, width: int) -> None:
    """Nothing sticks out at the side."""
    page = ready(visit(report, viewport={"width": width, "height": 800}))
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_light_and_dark_can_be_switched(visit: Visit, report: str) -> None:
    """The system decides first, then the button."""
    page = visit(report, color_scheme="dark")
    colour = "getComputedStyle(document.body).backgroundColor"
    dark = page.evaluate(colour)
    page.get_by_role("button", name="Switch theme").press("Enter")
    light = page.evaluate(colour)
    assert light == "rgb(255, 255, 255)"
    assert dark != light
    page.get_by_role("button", name="Switch theme").press("Enter")
    assert page.evaluate(colour) == dark


def test_the_worst_is_open_and_the_others_unfold_by_keyboard(visit: Visit, report: str) -> None:
    """Enter opens a failure, and a link from the table does."""
    page = visit(report)
    failures = page.locator(".failure")
    assert failures.count() == 3
    opened = [one.evaluate("one => one.open") for one in failures.all()]
    assert opened == [True, False, False]
    failures.nth(1).locator("> summary").press("Enter")
    assert failures.nth(1).evaluate("one => one.open")
    page.locator(".checks a").last.press("Enter")
    expect(page.locator("[id='fix-hits.survives-every-ray']")).to_have_js_property("open", True)


def test_the_slider_moves_by_keyboard_and_by_mouse(visit: Visit, report: str) -> None:
    """Further right, more of the student's picture is seen."""
    page = visit(report)
    figure = page.locator(".compare").first
    yours, slider = figure.locator(".yours"), figure.locator("input")
    before = picture(figure.locator(".layers"))
    slider.focus()
    for _ in range(9):
        page.keyboard.press("ArrowRight")
    assert yours.evaluate("one => one.style.clipPath") == "inset(0px 41% 0px 0px)"
    slider.press("End")
    assert yours.evaluate("one => one.style.clipPath").startswith("inset(0px")
    after = picture(figure.locator(".layers"))
    assert pixels(after, RED) > pixels(before, RED) + 20
    figure.locator(".layers").click(position={"x": 2, "y": 40})
    assert int(slider.input_value()) < 5


def test_the_wrong_box_is_seen(visit: Visit, report: str) -> None:
    """In the snapshot beside the failure and in the view, with the box as it should be."""
    page = ready(visit(report, viewport={"width": 1000, "height": 800}))
    failure = page.locator("[id='fix-bvh.boxes-are-tight']")
    failure.locator("> summary").press("Enter")
    snapshot = failure.locator("[data-model] img:not([hidden])")
    snapshot.evaluate("one => one.decode()")
    page.locator("#level").fill("-1")
    page.locator("#model").select_option("0")
    for place in (snapshot, page.locator("#stage")):
        seen = picture(place)
        # A dash of a snapshot is one or two pixels wide.
        assert pixels(seen, RED) > 60
        assert pixels(seen, GREEN) > 10
    expect(page.locator("#told")).to_contain_text("The box of node 1 is wrong")


def test_show_in_3d_leads_to_the_model(visit: Visit, report: str) -> None:
    """The button of a failure chooses its model, and the keyboard turns it at once."""
    page = ready(visit(report))
    page.locator("[id='fix-hits.closest-wins'] > summary").evaluate(
        "one => { one.parentElement.open = true; }"
    )
    page.locator("[id='fix-hits.closest-wins'] [data-model]").press("Enter")
    page.locator("#room[data-shown='1']").wait_for()
    assert page.evaluate("document.activeElement.id") == "stage"
    assert page.locator("#model").input_value() == "1"


def test_the_view_turns_by_keyboard_and_by_mouse(visit: Visit, report: str) -> None:
    """Each way changes what is seen, and 0 brings the beginning back."""
    page = ready(visit(report))
    stage = page.locator("#stage")
    stage.focus()
    first = picture(stage)
    for key in ("ArrowLeft", "ArrowUp", "+"):
        page.keyboard.press(key)
        assert picture(stage).tobytes() != first.tobytes(), key
        page.keyboard.press("0")
        assert picture(stage).tobytes() == first.tobytes(), key
    box = stage.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 100, box["y"] + 100)
    page.mouse.down()
    page.mouse.move(box["x"] + 160, box["y"] + 120)
    page.mouse.up()
    assert picture(stage).tobytes() != first.tobytes()
    page.get_by_role("button", name="Reset view").click()
    assert picture(stage).tobytes() == first.tobytes()


def test_boxes_are_shown_level_by_level(visit: Visit, report: str) -> None:
    """More levels are more lines; only one level is fewer."""
    page = ready(visit(report))
    page.locator("#model").select_option("2")
    page.locator("#room[data-shown='2']").wait_for()
    stage = page.locator("#stage")
    page.locator("#only").uncheck()
    seen = []
    for level in ("0", "3", "6"):
        page.locator("#level").fill(level)
        seen.append(picture(stage).tobytes())
        assert page.locator("#level-told").inner_text() == level
    assert len(set(seen)) == 3
    page.locator("#only").check()
    assert picture(stage).tobytes() != seen[-1]


def test_a_ray_is_walked_step_by_step(visit: Visit, report: str) -> None:
    """The list says what each step tested, and where the hit is lost; keys go on and back."""
    page = ready(visit(report))
    page.locator("#model").select_option("1")
    page.locator("#room[data-shown='1']").wait_for()
    steps = page.locator("#steps li")
    assert steps.first.inner_text() == "box of node 0: hit"
    expect(page.locator("#steps .lost")).to_contain_text("here the hit is lost")
    assert page.locator("#steps .lost[aria-current=step]").count() == 1
    before = picture(page.locator("#stage"))
    page.locator("#after").press("Enter")
    told = page.locator("#step-told")
    total = steps.count()
    now = page.locator("#steps [aria-current=step]")
    second = now.inner_text()
    assert picture(page.locator("#stage")).tobytes() != before.tobytes()
    page.locator("#before").press("Enter")
    assert now.inner_text() != second
    page.locator("#step").focus()
    page.keyboard.press("End")
    expect(told).to_have_text(f"step {total} of {total}")
    steps.nth(0).click()
    expect(told).to_have_text(f"step 1 of {total}")


def test_a_node_that_was_never_visited_is_lost_at_its_parent(
    visit: Visit, views: dict[str, Any]
) -> None:
    """The list marks the last step on the way, and the view draws the box in red."""
    seen = json.loads(json.dumps(views))
    (ray,) = [one["ray"] for one in seen["models"] if one["ray"]]
    ray["steps"] = [one for one in ray["steps"] if one["node"] in {0, 2}]
    page = ready(visit(to_html(to_json(samples.failing()), seen, "en")))
    before = picture(page.locator("#stage"))
    page.locator("#model").select_option("1")
    page.locator("#room[data-shown='1']").wait_for()
    expect(page.locator("#steps .lost")).to_contain_text("box of node 0: hit")
    assert picture(page.locator("#stage")).tobytes() != before.tobytes()
    assert pixels(picture(page.locator("#stage")), RED) > 60


def test_everything_can_be_reached_by_tab(visit: Visit, report: str) -> None:
    """From the first button to the last control of the view."""
    page = ready(visit(report))
    page.locator("#model").select_option("1")
    page.locator("#room[data-shown='1']").wait_for()
    page.locator("body").evaluate("one => { document.activeElement.blur(); }")
    reached = set()
    for _ in range(70):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.id || document.activeElement.type"))
    wanted = {"theme", "range", "model", "stage", "level", "only", "nearer", "farther", "anew"}
    assert wanted | {"before", "after", "step", "steps"} <= reached


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
