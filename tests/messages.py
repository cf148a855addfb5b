"""What the grader says in several languages: `python -m tests.messages` lists every text."""

import ast
import re
import tomllib
from collections.abc import Collection, Iterator

from grader.diagnose import every_hypothesis
from grader.errors import FAILED_HERE
from grader.model.verdict import Verdict
from grader.report.facts import BEGIN, NOT_STARTED
from grader.report.hints import LABELS, told
from grader.report.nodes import LABELS as NODE_LABELS
from grader.resources import scenes_folder
from grader.score.rubric import load_rubric
from grader.verify import every_check
from tests.own_files import ROOT

TRANSLATES = {"words"}
"""Functions whose first argument is translated."""

TEMPLATED = re.compile(r'\b_\("([^"]*)"\)')
"""Texts in a template, which calls the same function `_`."""

LABELLED = {"beside", "command"}
"""Those whose first argument is a label, and translated too."""


def messages() -> list[str]:
    """List each text once, in a fixed order."""
    texts = [
        NOT_STARTED,
        BEGIN,
        FAILED_HERE,
        *LABELS,
        "example",
        *(verdict.value for verdict in Verdict),
    ]
    texts += written_in_code()
    texts += written_in_templates()
    texts += [each.title for each in every_check()]
    texts += titles_of_scenes()
    texts += [title for _, title in load_rubric(None).titles]
    texts += [each.sentence for each in every_hypothesis()]
    texts += [text for hint in told().values() for text in (hint["question"], hint["trial"])]
    return list(dict.fromkeys(text for text in texts if text))


def titles_of_scenes() -> list[str]:
    """List what stands above the pictures of the scenes that come with the package."""
    text = (scenes_folder() / "scenes.toml").read_text(encoding="utf-8")
    return [each["title"] for each in tomllib.loads(text)["scene"]]


def labels() -> set[str]:
    """Name what stands beside the gutter of a terminal."""
    return {*LABELS, *NODE_LABELS, "example", *written_in_code(LABELLED)} - {""}


def written_in_code(names: Collection[str] = (*TRANSLATES, *LABELLED)) -> Iterator[str]:
    """Find the texts that the reports, the viewer and the command line write.

    Args:
        names: Functions whose first argument is looked for.
    """
    folders = (ROOT / "grader" / name for name in ("report", "view", "cli"))
    for path in (path for folder in folders for path in sorted(folder.rglob("*.py"))):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and node.args and _name(node) in names:
                first = node.args[0]
                if isinstance(first, ast.Constant) and isinstance(first.value, str):
                    yield first.value


def written_in_templates() -> Iterator[str]:
    """Find the texts of the pages."""
    for path in sorted((ROOT / "grader" / "report").rglob("*.html")):
        yield from TEMPLATED.findall(path.read_text(encoding="utf-8"))


def _name(call: ast.Call) -> str:
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


if __name__ == "__main__":
    for message in messages():
        print(message)  # noqa: T201 - a script
