"""What does the command line leave behind? The files of one grade, and what it prints."""

import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from grader.model.grade import Grade
from grader.output import PAGE, RESULT, VIEWS, ready, write_whole

if TYPE_CHECKING:
    from grader.report.as_json import Json


def stored(folder: Path, result: Grade, language: str) -> Path:
    """Write a result with everything that belongs to it, and say where the report lies."""
    from grader.report.as_json import to_text
    from grader.report.views import to_text as views_text

    store_counterexamples(folder, result)
    told = to_text(result)
    write_whole(folder / RESULT, told)
    views = None if result.views is None else views_text(result.views)
    if views is None:
        (folder / VIEWS).unlink(missing_ok=True)
    else:
        write_whole(folder / VIEWS, views)
    return store_page(folder, json.loads(told), json.loads(views) if views else None, language)


def store_page(folder: Path, result: "Json", views: "Json | None", language: str) -> Path:
    """Write the page of a result, and say where it lies."""
    from grader.report.html.submission import to_html

    path = folder / PAGE
    write_whole(path, to_html(result, views, language))
    return path


def store_counterexamples(folder: Path, result: Grade) -> None:
    """Write the files that result.json names, and remove those of an earlier grade."""
    from grader.counterexample.written import to_text
    from grader.report.facts import FOLDER, counterexample_file

    for score in result.checks:
        path = folder / counterexample_file(score)
        if score.counterexample is not None:
            ready(folder / FOLDER)
            write_whole(path, to_text(score.counterexample))
        elif path.is_file():
            path.unlink()


@contextmanager
def patient_stdout() -> Iterator[None]:
    """Let a reader go away early: what was graded keeps its result and its exit status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        with Path(os.devnull).open("wb") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
