"""Where do results go? Into a folder that was tried first, as whole files or not at all."""

import os
import secrets
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from grader.errors import OutputFault, UsageError
from grader.model.grade import Grade

RESULT = "result.json"


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
