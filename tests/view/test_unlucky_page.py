"""The page where answers fail, come late or not at all, and where the submission ends."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Route

from grader.view.desk import Desk
from grader.view.stage import Stage
from tests.view import sources
from tests.view.served import Open, opened, shown
from tests.view.shown import until


@pytest.mark.parametrize("what", ["state", "model"])
def test_what_fails_once_is_asked_again(house: Open, browser: Browser, what: str) -> None:
    """Also what cannot be read, and a refusal is told in its own words."""
    page = shown(house, browser, [])
    page.locator("#traced[data-share='1']").wait_for()
    left = ["abort", "text", "abort"]

    def fail(route: Route) -> None:
        how = left.pop() if left else ""
        if how == "abort":
            route.abort()
        elif how:
            route.fulfill(status=200, body="{")
        else:
            route.continue_()

    page.route(f"**/{what}", fail)
    for scene, faces in (("nested", "11,008 faces"), ("soup", "1,200 faces")):
        before = page.evaluate("document.body.dataset.shown")
        page.locator("#scene").select_option(scene)
        page.locator("#scene").blur()
        page.get_by_text(faces).wait_for()
        page.wait_for_function("old => document.body.dataset.shown !== old", arg=before)
    assert not left
    assert page.locator("#trouble").is_hidden()
    page.locator("#node").fill("1e300")
    page.locator("#node").blur()
    page.get_by_text("node must be a number").wait_for()
    page.close()


def test_a_mesh_that_comes_late_is_seen_from_its_own_place(
    house: Open, browser: Browser
) -> None:
    """The tree is there before it; the camera is not that of the scene before."""
    page = shown(house, browser, [])
    page.locator("#traced[data-share='1']").wait_for()
    page.locator("#stage").focus()
    for _ in range(4):
        page.keyboard.press("ArrowLeft")
    before = house.ask("GET", house.at("state"))[1]
    held: list[Route] = []
    page.route("**/model", lambda route: held.append(route), times=1)
    page.locator("#scene").select_option("nested")
    page.locator("#scene").blur()
    until(lambda: bool(held), lambda: page.wait_for_timeout(20))
    desk = house.service._desk
    first = desk.stage
    assert house.ask("POST", house.at("do"), {"what": "again"})[0] == 200
    until(lambda: has_new_tree(house, first), lambda: page.wait_for_timeout(20))
    page.keyboard.press("n")
    page.get_by_text("11,008 faces").wait_for()
    later = f"document.body.dataset.shown.startsWith('{before['subject'] + 1}.')"
    page.wait_for_function(later)
    held[0].continue_()
    until(lambda: is_home(desk), lambda: page.wait_for_timeout(20))
    page.close()


def test_a_mesh_that_is_lost_is_asked_for_again(house: Open, browser: Browser) -> None:
    """Also if something else was told meanwhile."""
    page = shown(house, browser, [])
    page.locator("#traced[data-share='1']").wait_for()
    before = page.evaluate("document.body.dataset.shown")
    held: list[Route] = []
    page.route("**/model", lambda route: held.append(route), times=1)
    assert house.ask("POST", house.at("do"), {"what": "again"})[0] == 200
    until(lambda: bool(held), lambda: page.wait_for_timeout(20))
    page.locator("#stage").focus()
    with page.expect_response("**/do"):
        page.keyboard.press("n")
    page.wait_for_timeout(200)
    held[0].abort()
    page.wait_for_function("old => document.body.dataset.shown !== old", arg=before)
    page.close()


def has_new_tree(house: Open, old: Stage | None) -> bool:
    """Tell whether another run than the old one has a tree, and the page may hear of it."""
    stage, known = house.service._desk.stage, house.service._tree
    return stage is not None and stage is not old and known is stage.tree is not None


def is_home(desk: Desk) -> bool:
    """Tell whether the camera is where that of the scene begins."""
    orbit, subject = desk.orbit, desk.subject
    return orbit is not None and subject is not None and orbit.yaw == subject.home.yaw


def test_a_program_that_is_gone_is_told(house: Open, browser: Browser) -> None:
    """After a few more questions."""
    page = shown(house, browser, [])
    page.locator("#traced[data-share='1']").wait_for()
    page.route("**/state", lambda route: route.abort())
    page.get_by_text("The program has ended").wait_for()
    page.close()


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize(
    ("source", "told"),
    [
        (sources.CRASHES_AT_THE_RIGHT, "SIGSEGV"),
        (sources.HANGS_AT_THE_RIGHT, "did not come back"),
    ],
    ids=["crash", "hang"],
)
def test_the_page_outlives_the_submission(
    browser: Browser, tmp_path: Path, source: str, told: str
) -> None:
    """It says what happened, runs it again, and shows the next build once that is saved."""
    noticed: list[str] = []
    file = tmp_path / "exercise03.cpp"
    file.write_text(source)
    with opened(file) as house:
        page = shown(house, browser, noticed)
        trouble, again = page.locator("#trouble"), page.locator("#again")
        trouble.filter(has_text=told).wait_for()
        assert "intersect, pixel (" in (trouble.text_content() or "")
        before = page.evaluate("document.body.dataset.shown")
        again.click()
        page.wait_for_function("old => document.body.dataset.shown !== old", arg=before)
        trouble.filter(has_text=told).wait_for()
        file.write_text(sources.reference())
        trouble.wait_for(state="hidden")
        page.locator("#traced[data-share='1']").wait_for()
        assert again.is_hidden()
        page.close()
    assert not noticed
