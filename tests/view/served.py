"""A door to a desk, as `view --web` opens one, and what a browser says to it."""

import http.client
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page

from grader.cli.progress import silent
from grader.options import Options
from grader.view.desk import Desk
from grader.view.page import written
from grader.view.server import Door
from grader.view.service import Service
from grader.view.study import Study
from grader.view.subject import of_scene

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
            with Door(service, written(file, ["soup", "nested"], "en")) as door:
                ready.append(Open(door, service))
                there.set()
                service.serve()
            study.close()
        over.set()

    threading.Thread(target=serve, daemon=True).start()
    assert there.wait(120)
    try:
        yield ready[0]
    finally:
        ready[0].service.is_over = True
        assert over.wait(120)


def shown(house: Open, browser: Browser, noticed: list[str]) -> Page:
    """Open the page in a browser, and note what goes wrong there."""
    # What playwright waits for is evaluated, which the page's own policy forbids.
    found = browser.new_page(viewport={"width": 1200, "height": 1000}, bypass_csp=True)
    found.set_default_timeout(PATIENCE)
    found.on("console", lambda one: noticed.extend([one.text] * (one.type == "error")))
    found.on("pageerror", lambda error: noticed.append(str(error)))
    found.goto(house.door.address)
    return found
