"""The page as a browser shows it: what hands do to it."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

from tests.view.served import Open, shown

if TYPE_CHECKING:
    from playwright.sync_api import FilePayload

LEFT, RIGHT = (20, 23, 28), (24, 26, 31)
"""Colours of what is empty."""


@pytest.fixture
def page(house: Open, browser: Browser) -> Iterator[Page]:
    """Open the page in a browser in which nothing may go wrong."""
    noticed: list[str] = []
    found = shown(house, browser, noticed)
    before = house.ask("GET", house.at("state"))[1]["subject"]
    for wish in ({"what": "scene", "scene": "soup"}, {"what": "mode", "mode": "shaded"}):
        assert house.ask("POST", house.at("do"), wish)[0] == 200
    # Or what is waited for would hold of what is there before it is loaded anew.
    loaded = f"!document.body.dataset.shown.startsWith('{before}.')"
    found.wait_for_function(f"document.body.dataset.shown && {loaded}")
    found.get_by_text("1,200 faces").wait_for()
    found.locator("#traced[data-share='1']").wait_for()
    yield found
    found.close()
    assert not noticed


def test_the_page_does_what_hands_want(page: Page) -> None:
    """Turn, follow a ray, step, look at a node, change the picture and the scene."""
    box = page.locator("#traced").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.locator("#steps li").first.wait_for()
    page.locator("#after").click()
    page.locator("#steps [aria-current]").wait_for()
    page.locator("#node").fill("2")
    page.locator("#node").blur()
    page.get_by_text("level 1, faces").wait_for()
    page.locator("#mode").select_option("cost")
    page.locator("#mode").blur()
    page.locator("#scale").wait_for()
    before = page.evaluate("document.getElementById('traced').toDataURL()")
    page.locator("#stage").focus()
    for _ in range(4):
        page.keyboard.press("ArrowLeft")
    page.wait_for_function(
        "before => document.getElementById('traced').toDataURL() !== before", arg=before
    )
    page.locator("#scene").select_option("nested")
    page.locator("#scene").blur()
    page.get_by_text("11,008 faces").wait_for()


def test_the_page_has_the_keys_and_buttons_of_the_window(page: Page) -> None:
    """Steps by comma and period; W moves what is seen, and so does the right button."""
    stage = page.locator("#stage").bounding_box()
    traced = page.locator("#traced").bounding_box()
    assert stage is not None
    assert traced is not None
    page.mouse.click(traced["x"] + traced["width"] / 2, traced["y"] + traced["height"] / 2)
    page.locator("#steps li").nth(2).wait_for()
    page.keyboard.press(".")
    page.keyboard.press(".")
    page.locator("#steps li:nth-child(2)[aria-current]").wait_for()
    page.keyboard.press(",")
    page.locator("#steps li:nth-child(1)[aria-current]").wait_for()
    picture = "document.getElementById('traced').toDataURL()"
    page.locator("#stage").focus()
    before = page.evaluate(picture)
    page.keyboard.press("w")
    page.wait_for_function(f"before => {picture} !== before", arg=before)
    page.locator("#traced[data-share='1']").wait_for()
    before = page.evaluate(picture)
    page.mouse.move(stage["x"] + 200, stage["y"] + 200)
    page.mouse.down(button="right")
    page.mouse.move(stage["x"] + 260, stage["y"] + 200, steps=3)
    page.mouse.up(button="right")
    page.wait_for_function(f"before => {picture} !== before", arg=before)
    assert page.locator("#again").is_hidden()


def test_what_is_told_again_is_left_alone(page: Page) -> None:
    """A button under a mouse that is held down, the focus, and where the list was scrolled."""
    traced = page.locator("#traced").bounding_box()
    assert traced is not None
    page.mouse.click(traced["x"] + traced["width"] / 2, traced["y"] + traced["height"] / 2)
    page.locator("#steps li").nth(20).wait_for()
    page.locator("#steps li").nth(9).click()
    page.locator("#steps li:nth-child(10)[aria-current]").wait_for()
    page.locator("#node").fill("1")
    page.locator("#node").blur()
    page.get_by_text("level 1, faces").wait_for()
    parent = page.get_by_role("button", name="parent 0")
    parent.focus()
    page.evaluate("document.getElementById('steps').scrollTop = 3")
    parent.hover()
    page.mouse.down()
    for _ in range(3):
        with page.expect_response("**/state"):
            pass
    assert page.evaluate("document.activeElement.textContent") == "parent 0"
    assert page.evaluate("document.getElementById('steps').scrollTop") == 3
    page.mouse.up()
    page.get_by_text("level 0, faces").wait_for()


def test_both_halves_show_the_same(page: Page, tmp_path: Path) -> None:
    """The scene's up is z, and neither half is rolled against the other."""
    page.locator("#level").focus()
    page.keyboard.press("Home")
    page.get_by_text("\N{EN DASH}", exact=True).wait_for()
    with page.expect_download() as saved:
        page.locator("#save").click()
    path = tmp_path / "both.png"
    saved.value.save_as(path)
    both = np.asarray(Image.open(path).convert("RGB")).astype(int)
    side = (both.shape[1] - 8) // 2
    drawn, traced = (
        (np.abs(half - empty) > 3).any(axis=2)
        for half, empty in ((both[:, :side], LEFT), (both[:, -side:], RIGHT))
    )
    assert 0.1 < traced.mean() < 0.9
    assert 0.1 < drawn.mean() < 0.9
    assert (drawn == traced).mean() > 0.97


def test_what_the_program_knows_is_shown(page: Page, house: Open) -> None:
    """How many pixels differ, the level that it chose, and why it does not do a thing."""
    page.locator("#mode").select_option("difference")
    page.locator("#mode").blur()
    page.get_by_text("0 pixels differ", exact=True).wait_for()
    assert (
        house.ask("POST", house.at("do"), {"what": "level", "level": 3, "only": True})[0] == 200
    )
    page.wait_for_function("document.getElementById('level').value === '3'")
    assert page.locator("#only").is_checked()
    level = page.locator("#level")
    level.focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function("document.getElementById('level-told').value === '4'")
    assert house.ask("GET", house.at("state"))[1]["level"] == 4
    page.locator("#only").uncheck()


DROP = """text => {
    const data = new DataTransfer();
    data.items.add(new File(["not this one"], "first.txt"));
    data.items.add(new File([text], "two.obj"));
    const how = { dataTransfer: data, bubbles: true, cancelable: true };
    document.getElementById("stage").dispatchEvent(new DragEvent("drop", how));
}"""


def test_a_file_can_be_dropped_or_chosen(page: Page, tmp_path: Path) -> None:
    """The last of several; the faces of its node are marked, and what will not do is told."""
    page.evaluate(DROP, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    page.locator("#status").filter(has_text=re.compile("^2 faces")).wait_for()
    page.locator("#remark").filter(has_text="scaled into the cube").wait_for()
    page.locator("#traced[data-share='1']").wait_for()
    # Of a number that stands there already the page would hear nothing.
    for node in ("7", "0"):
        page.locator("#node").fill(node)
        page.locator("#node").blur()
    page.get_by_text("level 0, faces [0, 2)").wait_for()
    with page.expect_download() as saved:
        page.locator("#save").click()
    saved.value.save_as(tmp_path / "both.png")
    both = np.asarray(Image.open(tmp_path / "both.png").convert("RGB")).astype(int)
    red, _, blue = both[:, : (both.shape[1] - 8) // 2].transpose(2, 0, 1)
    assert ((red > 80) & (blue < red / 5)).mean() > 0.05
    for name, size, told in (
        (
            "notes.txt",
            1,
            "notes.txt: a mesh (.obj, .ply, .stl, .gltf, .glb) or a counterexample",
        ),
        ("big.json", 1_000_001, "big.json has more than 1,000,000 bytes."),
    ):
        chosen = {"name": name, "mimeType": "text/plain", "buffer": b" " * size}
        page.locator("#file").set_input_files(cast("FilePayload", chosen))
        page.locator("#trouble").filter(has_text=told).wait_for()
