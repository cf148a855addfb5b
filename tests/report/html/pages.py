"""Pages of the samples, and what people see of them."""

import json
from html.parser import HTMLParser
from typing import Any

from grader.report.as_json import to_json
from grader.report.html.submission import to_html
from tests.report import samples


class Reader(HTMLParser):
    """Reads tags and visible text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, list[str]]] = []
        self.text = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note a tag and the names of its attributes."""
        self.tags.append((tag, [name for name, _ in attrs]))

    def handle_data(self, data: str) -> None:
        """Note text."""
        self.text += data


def page_of(name: str, language: str = "en") -> str:
    """Write the page of a sample, without views."""
    return to_html(to_json(samples.EVERY[name]()), None, language)


def spoilt(text: str, views: dict[str, Any]) -> str:
    """Write a page with a text wherever a stranger could put one."""
    result = to_json(samples.failing())
    result["submission"] |= {"name": text, "path": "x" + text}
    for check in result["checks"]:
        if check["verdict"] == "fail":
            names = ("message", "expected", "got", "hint")
            check |= {name: f"{name} {text}" for name in names}
            if found := check["counterexample"]:
                names = ("message", "expected", "got", "explanation")
                found |= {name: f"{name} {text}" for name in names}
    result["build"]["diagnostics"] = [
        {"line": 1, "column": 2, "severity": "warning", "text": text}
    ]
    seen = json.loads(json.dumps(views))
    seen["pictures"][0]["title"] = seen["models"][0]["title"] = text
    seen["models"][1]["ray"]["sentence"] = text
    return to_html(result, seen, "en")
