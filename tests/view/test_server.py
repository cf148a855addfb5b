"""The page of this machine alone: who may ask, what is answered, and how it looks."""

import html
import http.client
import json
import socket
import struct
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

from grader.cli.progress import silent
from grader.options import Options
from grader.view.desk import Desk
from grader.view.server import HERE, Door, written
from grader.view.service import Service
from grader.view.study import Study
from grader.view.subject import of_scene
from tests.view import sources

OPTIONS = Options(41, None, (), silent, isolated=False)
PATIENCE = 240_000
"""Milliseconds; only a machine that is much too busy needs more than a few seconds."""


@dataclass(frozen=True)
class Open:
    """A door, and the service behind it, which runs in a thread."""

    door: Door
    service: Service

    def ask(self, method: str, place: str, body: Any = None, **headers: str) -> tuple[int, Any]:  # noqa: ANN401 - JSON
        """Ask, and return status and answer."""
        talk = http.client.HTTPConnection("127.0.0.1", self.door.port, timeout=120)
        try:
            data = body if isinstance(body, str | None) else json.dumps(body)
            talk.request(method, place, data, headers)
            answer = talk.getresponse()
            text = answer.read()
        finally:
            talk.close()
        if answer.getheader("Content-Type") == "application/json":
            return answer.status, json.loads(text)
        return answer.status, text

    def at(self, what: str) -> str:
        """Put the secret part in front."""
        return f"/{self.door.token}/{what}"


@contextmanager
def opened(file: Path) -> Iterator[Open]:
    """Serve a desk in a thread of its own."""
    ready: list[Open] = []
    there, over = threading.Event(), threading.Event()

    def serve() -> None:
        with Desk(file, OPTIONS, lambda: of_scene("soup")) as desk:
            study = Study(desk)
            service = Service(desk, study, str)
            with Door(service, written(desk, ["soup", "nested"], str)) as door:
                ready.append(Open(door, service))
                there.set()
                service.serve()
            study.close()
        over.set()

    threading.Thread(target=serve, daemon=True).start()
    assert there.wait(120)
    yield ready[0]
    ready[0].service.is_over = True
    assert over.wait(120)


@pytest.fixture(scope="module")
def house(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Open]:
    """Serve a right submission."""
    file = tmp_path_factory.mktemp("web") / "exercise03.cpp"
    file.write_text(sources.reference())
    with opened(file) as found:
        yield found


def test_the_page_is_given_to_who_knows_the_secret(house: Open) -> None:
    """With a policy that lets nothing of a stranger run."""
    status, text = house.ask("GET", house.at(""))
    assert status == 200
    told = html.unescape(text.decode())
    assert "connect-src 'self'" in told
    assert "default-src 'none'" in told


@pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "", "127.0.0.1.evil:1"])
def test_another_host_is_refused(house: Open, host: str) -> None:
    """A page that gives its own name our address learns nothing."""
    assert house.ask("GET", house.at("state"), Host=host) == (403, b"")
    assert house.ask("POST", house.at("do"), {"what": "next-node"}, Host=host)[0] == 403


@pytest.mark.parametrize("token", ["", "x", "%C3%A9", "x" * 5000])
def test_another_secret_is_refused(house: Open, token: str) -> None:
    """Nobody finds it by trying."""
    assert house.ask("GET", f"/{token}/state") == (404, b"")


@pytest.mark.parametrize(
    "body",
    [
        "",
        "[]",
        "{",
        "[" * 60_000,
        {"what": "nothing"},
        {"what": "node", "node": "7"},
        {"what": "node", "node": 1e300},
        {"what": "mode", "mode": "wrong"},
        {"what": "follow", "at": [1]},
        {"what": "follow", "at": [True, 0]},
        "x" * 70_000,
    ],
    ids=str,
)
def test_what_cannot_be_asked_is_refused(house: Open, body: Any) -> None:  # noqa: ANN401 - JSON
    """And the program goes on."""
    assert house.ask("POST", house.at("do"), body)[0] == 400
    assert house.ask("GET", house.at("state"))[0] == 200


def test_a_fault_of_ours_costs_one_answer(house: Open, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is told in a sentence, and the next question is answered."""

    def state() -> None:
        raise ValueError("on purpose")

    with monkeypatch.context() as patch:
        patch.setattr(house.service, "state", state)
        status, told = house.ask("GET", house.at("state"))
        assert status == 500
        assert "on purpose" in told
        assert house.ask("POST", house.at("do"), {"what": "next-node"})[0] == 500
    assert house.ask("GET", house.at("state"))[0] == 200


def test_a_browser_that_goes_away_leaves_no_traceback(
    house: Open, capfd: pytest.CaptureFixture[str]
) -> None:
    """Whoever closes a page does so in the middle of an answer."""
    for _ in range(3):
        with socket.create_connection((HERE, house.door.port)) as line:
            # Nothing is read, and what is left unsent is dropped with a reset.
            line.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            path = house.at("model")
            line.sendall(f"GET {path} HTTP/1.1\r\nHost: {HERE}:1\r\n\r\n".encode())
    assert house.ask("GET", house.at("state"))[0] == 200
    assert "Traceback" not in capfd.readouterr().err


@pytest.fixture
def page(house: Open, browser: Browser) -> Iterator[Page]:
    """Open the page in a browser in which nothing may go wrong."""
    noticed: list[str] = []
    # What playwright waits for is evaluated, which the page's own policy forbids.
    found = browser.new_page(viewport={"width": 1200, "height": 1000}, bypass_csp=True)
    found.set_default_timeout(PATIENCE)
    found.on("console", lambda one: noticed.extend([one.text] * (one.type == "error")))
    found.on("pageerror", lambda error: noticed.append(str(error)))
    found.goto(house.door.address)
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
