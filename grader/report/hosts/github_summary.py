"""What stands in the summary of a step on GitHub? The score, a table, and every failure.

GitHub takes 1 MiB of Markdown from a step, and drops a larger text as a whole.
"""

from collections.abc import Iterator

from grader.language import Words
from grader.plain import printable
from grader.report.as_json import Json
from grader.report.escape import SHORTER, code_for_markdown, for_html, for_markdown
from grader.report.hosts.told import (
    Entry,
    entries,
    headline,
    unbuilt,
    whole_parts,
    worst_first,
    worth,
)

LARGEST = 1_000_000
"""Bytes; the limit is 1,048,576 of all that a step writes."""

SIGNS = {"pass": "✅", "fail": "❌", "blocked": "\N{EN DASH}", "broken": "⚠️"}


def to_text(result: Json, words: Words = str) -> str:
    """Write the summary; texts are cut until it fits."""
    written = ""
    for limit in SHORTER:
        written = "\n".join([*paragraphs(result, limit, words), ""])
        if len(written.encode()) <= LARGEST:
            break
    return written


def paragraphs(result: Json, limit: int, words: Words) -> Iterator[str]:
    """Write all paragraphs, each with an empty line before the next."""
    shown = entries(result, words)
    yield f"## {for_markdown(headline(result, words))}\n"
    if not result["build"]["ok"]:
        yield block(unbuilt(result, words), limit)
    yield "| | | |\n| --- | --- | ---: |"
    for part in whole_parts(result):
        whole = Entry("", part["id"], "", "", part["score"], part["max_score"], "")
        title = for_markdown(f"{part['id']}) {words(part['title'])}")
        yield f"| | **{title}** | **{for_markdown(worth(whole, words))}** |"
    for entry in shown:
        statement = f"{code_for_markdown(entry.id)} {for_markdown(entry.title)}"
        if entry.text and entry.verdict != "fail":
            statement += f": {code_for_markdown(printable(entry.text, limit))}"
        yield f"| {SIGNS[entry.verdict]} | {statement} | {for_markdown(worth(entry, words))} |"
    for entry in worst_first(shown):
        yield f"\n### {for_markdown(f'{words(entry.verdict)}')} {code_for_markdown(entry.id)}\n"
        yield block(f"{entry.title}\n{entry.text}", limit)


def block(text: str, limit: int) -> str:
    """Write a stranger's lines as they are: only `</pre>` would end them, and `<` is coded."""
    return f"<pre>{for_html(printable(text, limit))}</pre>\n"
