"""Which formats can a result be written in, and into which files?

`results.json` is what both Gradescope and PrairieLearn look for, so each has a folder.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from grader.language import Words
from grader.report.as_json import Json
from grader.report.hosts import (
    autolab,
    github,
    github_summary,
    gradescope,
    junit,
    prairielearn,
)

Writer = Callable[[Json, Words], str]
"""From `result.json` and a language to the text of one file; nothing else goes in."""


@dataclass(frozen=True, slots=True)
class Written:
    """One file of a format."""

    path: str
    """Relative to the folder of `result.json`."""

    write: Writer


FORMATS: Mapping[str, tuple[Written, ...]] = {
    "json": (),  # result.json is always there: everything else is made from it
    "html": (),  # and so is report.html
    "gradescope": (Written("gradescope/results.json", gradescope.to_text),),
    "prairielearn": (Written("prairielearn/results.json", prairielearn.to_text),),
    "autolab": (Written("autolab.txt", autolab.to_text),),
    "github": (
        Written("github/log.txt", github.log),
        Written("github/summary.md", github_summary.to_text),
        Written("github/output.txt", github.output),
    ),
    "junit": (Written("junit.xml", junit.to_text),),
}
