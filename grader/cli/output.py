"""Where do results go? Into a folder that was tried first, as whole files or not at all."""

import json
import os
import secrets
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from grader.errors import OutputFault, UsageError
from grader.model.grade import Grade

if TYPE_CHECKING:
    from grader.report.as_json import Json

RESULT = "result.json"
VIEWS = "views.json"
"""What can be seen of the submission: `report.html` is made from it and from the result."""

PAGE = "report.html"


def ready(folder: Path, name: str = RESULT) -> Path:
    """Create an output folder and prove that a result can be written into it.

    Raises:
        UsageError: It cannot be, so grading need not start.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if (folder / name).is_dir():
            raise UsageError(f"{folder / name} is a folder, but the result goes there.")
        trial = folder / f".{name}-{secrets.token_hex(8)}"
        trial.touch(exist_ok=False)
        trial.unlink()
    except OSError as fault:
        reason = fault.strerror or "it cannot be written"
        raise UsageError(
            f"{folder}: {reason}, but the result goes there; name another folder with -o."
        ) from fault
    return folder


def write_whole(path: Path, text: str) -> None:
    """Write a file of text so that a reader sees the old one or the new one, never a part."""
    write_bytes_whole(path, text.encode("utf-8"), "grade again into another folder")


def write_bytes_whole(path: Path, data: bytes, remedy: str) -> None:
    """Write a file so that a reader sees the old one or the new one, never a part.

    Raises:
        OutputFault: It could not be written; what was there before is untouched.
    """
    unfinished = path.with_name(f".{path.name}-{secrets.token_hex(8)}")
    try:
        with unfinished.open("xb") as file:
            file.write(data)
        if path.exists():
            # Who may read a gradebook stays as it was.
            unfinished.chmod(path.stat().st_mode & 0o777)
        unfinished.replace(path)
    except OSError as fault:
        raise OutputFault(
            f"{path} could not be written: {fault.strerror}; {remedy}."
        ) from fault
    finally:
        with suppress(OSError):
            unfinished.unlink()


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
