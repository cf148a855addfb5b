"""What is kept of a grade, and how does it get into a folder?

Everything is written from texts, so that a result that was stored long ago leaves the same
files as one that was just made.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from grader.errors import OutputFault, let_go
from grader.model.grade import Grade
from grader.output import PAGE, RESULT, VIEWS, ready, refuse_link, write_whole
from grader.report.as_json import Json, to_text
from grader.report.facts import FOLDER, counterexample_file, remarked


@dataclass(frozen=True, slots=True)
class Result:
    """What is kept of a grade."""

    text: str
    """Of `result.json`."""

    attachments: tuple[tuple[str, str], ...]
    """Name and text of each further file, relative to `result.json`."""

    traceback: str = ""
    """Of checks of ours that broke, for a maintainer; in no file of the result."""


def kept(grade: Grade) -> Result:
    """Write down all that is known of a grade; pages are made from this, at any time."""
    from grader.counterexample.written import to_text as counterexample
    from grader.report.views import to_text as views_text

    files: dict[str, str] = {}
    for score in grade.checks:
        if score.counterexample is not None:
            name = counterexample_file(score.check)
            grade = _attached(grade, files, name, partial(counterexample, score.counterexample))
            if name not in files:
                grade = _without_example(grade, score.check)
    if grade.views is not None:
        grade = _attached(grade, files, VIEWS, partial(views_text, grade.views))
    return Result(to_text(grade), tuple(files.items()), grade.traceback)


def _attached(
    grade: Grade, files: dict[str, str], name: str, write: Callable[[], str]
) -> Grade:
    """Add a file to those of a grade; our own fault costs that file, and a remark says so."""
    try:
        files[name] = write()
    except Exception as fault:  # noqa: BLE001 - all is decided: it costs the attachment
        let_go(fault)
        kind = type(fault).__name__
        told = f"{name} is missing, which is our own fault ({kind}) and costs no point"
        return remarked(grade, told)
    return grade


def _without_example(grade: Grade, check: str) -> Grade:
    """Take back a counterexample, whose file a result would name."""
    checks = (
        replace(one, counterexample=None) if one.check == check else one for one in grade.checks
    )
    return replace(grade, checks=tuple(checks))


def write_result(folder: Path, result: Result, language: str, hints: bool = True) -> Path:
    """Write a result, its attachments and its page, without those of an earlier result.

    Args:
        folder: Where.
        result: What is kept of a grade.
        language: Of the page.
        hints: Whether the page tells causes and hints; the result always has the cause.

    Returns:
        Where the page lies.

    Raises:
        UsageError: The folder cannot be used.
        OutputFault: Something could not be written.
    """
    refuse_link(folder)
    refuse_link(folder / FOLDER)
    told: Json = json.loads(result.text)
    attached = dict(result.attachments)
    names = [VIEWS, *(counterexample_file(one["id"]) for one in told["checks"])]
    for old in (folder / name for name in names if name not in attached):
        try:
            if old.is_file():
                old.unlink()
        except OSError as fault:
            raise OutputFault(f"{old} cannot be removed: {fault.strerror}") from fault
    if any(name.startswith(f"{FOLDER}/") for name in attached):
        ready(folder / FOLDER, remedy="remove what is there")
    for name, text in attached.items():
        write_whole(folder / name, text)
    write_whole(folder / RESULT, result.text)
    views = json.loads(attached[VIEWS]) if VIEWS in attached else None
    return write_page(folder, told, views, language, hints)


def write_page(
    folder: Path, result: Json, views: Json | None, language: str, hints: bool = True
) -> Path:
    """Write the page of a result, and say where it lies.

    Raises:
        OutputFault: It could not be written.
    """
    from grader.report.html.submission import to_html

    path = folder / PAGE
    write_whole(path, to_html(result, views, language, hints))
    return path
