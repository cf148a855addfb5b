"""Pages in a real browser, in which nothing may go wrong."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page

from grader.report.as_json import to_json
from grader.report.html.submission import to_html
from tests.report import samples
from tests.report.html.shown import failing_views

Visit = Callable[..., Page]


@pytest.fixture(scope="session")
def views(cache: Path) -> dict[str, Any]:
    """Draw what a failing submission saw, once."""
    return failing_views()


@pytest.fixture(scope="session")
def report(views: dict[str, Any]) -> str:
    """Write the report of a failing submission."""
    return to_html(to_json(samples.failing()), views, "en")


@pytest.fixture
def visit(browser: Browser, tmp_path: Path) -> Generator[Visit]:
    """Open texts as files, without a network; errors and requests fail the test at its end."""
    noticed: list[str] = []
    contexts = []

    def opened(text: str, within: Browser = browser, **options: Any) -> Page:  # noqa: ANN401 - playwright's own
        file = tmp_path / "page.html"
        file.write_text(text, encoding="utf-8")
        context = within.new_context(offline=True, **options)
        contexts.append(context)
        page = context.new_page()
        watch(page, file.as_uri(), noticed)
        page.goto(file.as_uri())
        return page

    yield opened
    for context in contexts:
        context.close()
    assert not noticed


def ready(page: Page) -> Page:
    """Wait until a model is shown."""
    page.locator("#room[data-shown]").wait_for()
    return page


def watch(page: Page, own: str, noticed: list[str]) -> None:
    """Note errors, and requests for anything but the file and what is inside of it."""

    def hear(message: ConsoleMessage) -> None:
        if message.type == "error":
            noticed.append(message.text)

    def see(url: str) -> None:
        if not url.startswith(("data:", "blob:")) and url.partition("#")[0] != own:
            noticed.append(url)

    page.on("console", hear)
    page.on("pageerror", lambda error: noticed.append(str(error)))
    page.on("request", lambda request: see(request.url))
