"""The readers of every format, as strict as those that will read our output.

Each takes text that was escaped for its format, reads it as that format's own reader does, and
returns what it understood; whatever it would act on fails the test.
"""

import csv
import io
import json
import re
import unicodedata
from html.parser import HTMLParser
from typing import Any
from xml.etree import ElementTree

from markdown_it import MarkdownIt

FORMULA = re.compile(r"\s*[=+\-@\uff1d\uff0b\uff0d\uff20]")
NUMBER = re.compile(r"\s*[+-][\d.]+(e[+-]?\d+)?\s*([)\]].*)?", re.DOTALL)


GFM = MarkdownIt("commonmark", {"html": True}).enable("table")
"""Markdown with tables and raw HTML, which GitHub renders too."""


class _Elements(HTMLParser):
    """Remembers what a browser would see."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.seen: list[object] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.append((tag, attrs))

    def handle_endtag(self, tag: str) -> None:
        self.seen.append(f"/{tag}")

    def handle_data(self, data: str) -> None:
        self.text += data

    def handle_comment(self, data: str) -> None:
        self.seen.append(f"!{data}")

    def handle_decl(self, decl: str) -> None:
        self.seen.append(f"!{decl}")

    def handle_pi(self, data: str) -> None:
        self.seen.append(f"?{data}")

    def unknown_decl(self, data: str) -> None:
        self.seen.append(f"![{data}")


def html_reader(escaped: str) -> str:
    """Read it as the content and as an attribute of one element."""
    browser = _Elements()
    browser.feed(f"<p title=\"{escaped}\" lang='{escaped}'>{escaped}</p>")
    browser.close()
    attributes = [("title", browser.text), ("lang", browser.text)]
    assert browser.seen == [("p", attributes), "/p"]
    return browser.text


def script_reader(escaped: str) -> Any:  # noqa: ANN401 - parsed JSON
    """Read JSON inside a script, which no `<` may end or turn into a comment."""
    assert not set("<>&\u2028\u2029") & set(escaped)
    browser = _Elements()
    browser.feed(f"<script type='application/json'>{escaped}</script><p>")
    browser.close()
    assert browser.seen[1:] == ["/script", ("p", [])]
    return json_reader(browser.text)


def xml_reader(escaped: str) -> str:
    """Read it as the content and as an attribute of one element."""
    head = '<?xml version="1.0" encoding="UTF-8"?>'
    file = f"{head}<t a=\"{escaped}\" b='{escaped}'>{escaped}</t>".encode()
    root = ElementTree.fromstring(file)  # noqa: S314 - our own output
    assert not list(root)
    text = root.text or ""
    assert root.attrib == {"a": text, "b": text}
    return text


def json_reader(text: str) -> Any:  # noqa: ANN401 - parsed JSON
    """Read strict JSON in UTF-8."""

    def refuse(name: str) -> float:
        raise AssertionError(name)

    value = json.loads(text.encode("utf-8").decode("utf-8"), parse_constant=refuse)
    assert not commands(text)
    return value


def csv_reader(escaped: str) -> str:
    """Read it as a cell between two others, also as a spreadsheet that splits elsewhere."""
    line = f'"a",{escaped},"b"'
    for sign in ",;\t|":
        for row in csv.reader(io.StringIO(line, newline=""), delimiter=sign):
            for cell in row:
                # A number is one, and a bracket that was never opened ends every formula.
                assert not FORMULA.match(cell) or NUMBER.fullmatch(cell)
    rows = list(csv.reader(io.StringIO(line, newline=""), strict=True))
    assert len(rows) == 1
    assert len(rows[0]) == 3
    return rows[0][1]


def autolab_reader(text: str) -> Any:  # noqa: ANN401 - parsed JSON
    """Read a line as Autolab does: it puts quotes around words before a colon, then parses."""
    assert len(text.splitlines()) == 1
    quoted = re.sub(r"([a-zA-Z0-9]+):", r'"\1":', text)
    assert quoted == text
    return json_reader(quoted)


def markdown_reader(escaped: str) -> str:
    """Read it in a paragraph, a heading and a cell of a table, where it may only be text."""
    cells = f"| {escaped} | b |\n| --- | --- |\n| {escaped} | {escaped} |\n"
    browser = _Elements()
    browser.feed(GFM.render(f"a {escaped} b\n\n# {escaped}\n\n{cells}"))
    browser.close()
    tags = {tag[0] if isinstance(tag, tuple) else str(tag).lstrip("/") for tag in browser.seen}
    assert tags <= {"p", "h1", "table", "thead", "tbody", "tr", "th", "td", "code"}
    first, heading, *_ = browser.text.split("\n")
    assert first == f"a {heading} b"
    assert browser.seen.count("/td") == 2
    assert browser.seen.count("/th") == 2
    assert browser.text.count(heading) >= 4
    return heading


def moodle_reader(escaped: str) -> list[str]:
    """Read a cell of CSV, and then its text as HTML with line breaks in it."""
    browser = _Elements()
    lines = []
    for line in csv_reader(escaped).split("<br>"):
        browser.text = ""
        browser.feed(f"<p>{line}</p>")
        lines.append(browser.text)
    browser.close()
    assert browser.seen == [("p", []), "/p"] * len(lines)
    return lines


def terminal_reader(text: str) -> str:
    """Read it as a terminal and as the log of a workflow, of which neither may act."""
    for character in text:
        kind = unicodedata.category(character)
        assert character in "\n\t" or kind not in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")
    assert not commands(text)
    return text


def workflow_reader(message: str, value: str) -> tuple[str, str]:
    """Read the message and a property of one annotation."""
    line = f"::error file={value},title={value}::{message}"
    assert len(line.splitlines()) == 1
    (found,) = commands(line)
    name, properties, data = found
    assert name == "error"
    given, last = properties.get("file", ""), properties.get("title", "")
    assert given.rstrip(" \t") == last
    return data, given


def commands(log: str) -> list[tuple[str, dict[str, str], str]]:
    """Find the commands that a GitHub runner would carry out, whatever they are called.

    Source: actions/runner, src/Runner.Common/ActionCommand.cs (TryParseV2, then TryParse).
    """
    lines = re.split("\r\n|\r|\n", log)
    return [found for line in lines if (found := _second(line) or _first(line))]


def _second(line: str) -> tuple[str, dict[str, str], str] | None:
    line = line.lstrip()
    end = line.find("::", 2)
    if not line.startswith("::") or end < 0:
        return None
    name, _, given = line[2:end].partition(" ")
    pairs = [pair.split("=", 1) for pair in given.strip().split(",") if pair]
    escapes = {"%0D": "\r", "%0A": "\n", "%3A": ":", "%2C": ",", "%25": "%"}
    properties = {pair[0]: _decoded(pair[1], escapes) for pair in pairs if len(pair) == 2}
    return name, properties, _decoded(line[end + 2 :], {"%0D": "\r", "%0A": "\n", "%25": "%"})


def _first(line: str) -> tuple[str, dict[str, str], str] | None:
    start = re.search(r"##\w*\[", line)  # Azure and TeamCity have a word between
    end = line.find("]", start.start()) if start else -1
    return ("", {}, line[end + 1 :]) if end >= 0 else None


def _decoded(text: str, escapes: dict[str, str]) -> str:
    """Decode one kind after the other, as the runner does."""
    for code, character in escapes.items():
        text = text.replace(code, character)
    return text
