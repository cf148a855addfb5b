"""Where is the one `exercise03.cpp` in a file, a folder, a zip or a tar.gz?

Nothing is extracted and no link is followed: what a student packed must not make the grader
read a file of ours.
"""

import os
import stat
from collections.abc import Iterator
from functools import partial
from io import BytesIO
from pathlib import Path

from grader.errors import UsageError
from grader.intake.archive import from_tar, from_zip
from grader.intake.candidates import MOST_ENTRIES, Candidate, Fault, choose, is_junk, is_source
from grader.intake.screen import SOURCE_NAME, printable, screen
from grader.model.stages import Rejected, Submission

LARGEST_ARCHIVE = 128 * 2**20
"""Bytes of an archive that are read: it is searched in memory."""

DEEPEST = 16
"""Folders inside folders that are searched."""

_SOURCE_ENDINGS = {".cpp", ".cc", ".cxx"}
_ARCHIVE_ENDINGS = (".tar.gz", ".tgz", ".tar", ".zip")
_NOT_A_FILE = Fault("this is a link, a pipe or a device; hand in the file itself")


def locate(path: Path, source_limit: int) -> Submission | Rejected:
    """Find and read the one source file of a submission.

    Args:
        path: A C++ file of any name, a folder or an archive.
        source_limit: Largest source file in bytes.

    Raises:
        UsageError: If there is nothing at `path`, or it may not be read.
    """
    student = _student(path)
    try:
        mode = path.lstat().st_mode
        if stat.S_ISDIR(mode):
            return _screened(student, _in_folder(path), source_limit)
        if path.suffix.lower() in _SOURCE_ENDINGS:
            alone = Candidate(SOURCE_NAME, lambda most: _read_file(path, most))
            return _screened(student, alone, source_limit)
        content = _read_file(path, LARGEST_ARCHIVE + 1)
        if isinstance(content, Fault):
            return Rejected(student, content.reason)
        return _screened(student, _in_archive(content, source_limit + 1), source_limit)
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or str(fault)
        raise UsageError(
            f"{printable(str(path))}: {why}, but a C++ file, a folder, a .zip or a .tar.gz "
            f"with one {SOURCE_NAME} is expected"
        ) from fault


def _screened(
    student: str, found: Candidate | Fault, source_limit: int
) -> Submission | Rejected:
    if isinstance(found, Fault):
        return Rejected(student, found.reason)
    shown = printable(found.path)
    content = found.read(source_limit + 1)
    if isinstance(content, Fault):
        return Rejected(student, f"{shown}: {content.reason}")
    return screen(student, shown, content, source_limit)


def _student(path: Path) -> str:
    name = path.name or path.absolute().name
    ending = next((e for e in _ARCHIVE_ENDINGS if name.lower().endswith(e)), "")
    if not ending and path.suffix.lower() in _SOURCE_ENDINGS:
        ending = path.suffix
    return printable(name[: len(name) - len(ending)]) or "submission"


def _read_file(path: Path, most: int) -> bytes | Fault:
    """Read a regular file; a link is not followed, and a pipe does not make us wait."""
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        if stat.S_ISREG(path.lstat().st_mode):
            raise
        return _NOT_A_FILE
    with os.fdopen(handle, "rb") as file:
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            return _NOT_A_FILE
        return file.read(most)


def _in_archive(content: bytes, most: int) -> Candidate | Fault:
    if len(content) > LARGEST_ARCHIVE:
        return Fault(f"larger than {LARGEST_ARCHIVE // 2**20} MiB; hand in only {SOURCE_NAME}")
    if content.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        return from_zip(BytesIO(content))
    if content.startswith(b"\x1f\x8b") or content[257:262] == b"ustar":
        return from_tar(BytesIO(content), most)
    return Fault(
        "neither a C++ file nor a folder, .zip or .tar.gz; "
        f"hand in {SOURCE_NAME} or a .zip with it"
    )


def _in_folder(folder: Path) -> Candidate | Fault:
    found: list[Candidate] = []
    others: list[str] = []
    for count, path in enumerate(_walk(folder)):
        if count >= MOST_ENTRIES:
            return Fault(f"more than {MOST_ENTRIES:,} files; hand in only {SOURCE_NAME}")
        inside = str(path.relative_to(folder))
        others.append(inside)
        if is_source(inside):
            found.append(Candidate(inside, partial(_read_file, path)))
    return choose(found, others)


def _walk(folder: Path) -> Iterator[Path]:
    """Every entry that is not a folder, in sorted order, hidden ones and junk left out."""
    waiting = [(folder, 0)]
    while waiting:
        here, depth = waiting.pop()
        with os.scandir(here) as entries:
            inside = sorted(entries, key=lambda entry: entry.name)
        for entry in inside:
            if is_junk(entry.name):
                continue
            if not entry.is_dir(follow_symlinks=False):
                yield Path(entry.path)
            elif depth < DEEPEST:
                waiting.append((Path(entry.path), depth + 1))
