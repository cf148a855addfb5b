"""Where is the one `exercise03.cpp` in a file, a folder, a zip or a tar.gz?

Nothing is extracted and no link is followed: what a student packed must not make the grader
read a file of ours.
"""

import os
import stat
from io import BufferedReader
from pathlib import Path
from typing import BinaryIO

from grader.errors import UsageError
from grader.intake.candidates import Candidate, Damage, Fault, choose
from grader.intake.folder import folder_entries, opened
from grader.intake.gunzip import GZIP_MARK, Gunzip
from grader.intake.screen import screen
from grader.intake.tar import TAR_MARK, TAR_MARK_PLACE, tar_entries
from grader.intake.zip import ZIP_MARKS, zip_entries
from grader.model.stages import SOURCE_NAME, Rejected, Submission
from grader.plain import as_name

LARGEST_ARCHIVE = 128 * 2**20
"""Bytes of an archive that is searched."""

LARGEST_TAR = 128 * 2**20
"""Unpacked bytes of a tar.gz that are searched: less than a second of work."""

_SOURCE_ENDINGS = {".cpp", ".cc", ".cxx"}
_ARCHIVE_ENDINGS = (".tar.gz", ".tgz", ".tar", ".zip")


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
        found = _found(path, source_limit + 1)
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or str(fault)
        raise UsageError(
            f"{as_name(str(path))}: {why}, but a C++ file, a folder, a .zip or a .tar.gz "
            f"with one {SOURCE_NAME} is expected"
        ) from fault
    return judged(student, found, source_limit)


def judged(student: str, found: Candidate | Fault, source_limit: int) -> Submission | Rejected:
    """Accept what was found, or say why it is no submission."""
    if isinstance(found, Fault):
        return Rejected(student, found.reason)
    shown = as_name(found.path)
    if isinstance(found.content, Fault):
        return Rejected(student, f"{shown}: {found.content.reason}")
    return screen(student, shown, found.content, source_limit)


def _student(path: Path) -> str:
    name = path.name or path.absolute().name
    ending = next((e for e in _ARCHIVE_ENDINGS if name.lower().endswith(e)), "")
    if not ending and path.suffix.lower() in _SOURCE_ENDINGS:
        ending = path.suffix
    return as_name(name[: len(name) - len(ending)]) or "submission"


def _found(path: Path, most: int) -> Candidate | Fault:
    handle = opened(path)
    if isinstance(handle, Fault):
        return handle
    if stat.S_ISDIR(os.fstat(handle).st_mode):
        try:
            return _in_folder(handle, most)
        finally:
            os.close(handle)
    with os.fdopen(handle, "rb") as file:
        return in_file(path.suffix, file, most)


def _in_folder(folder: int, most: int) -> Candidate | Fault:
    """Search a folder; where some of it may not be read, nothing is not an answer."""
    unread: list[OSError] = []
    found = choose(folder_entries(folder, unread), most)
    if isinstance(found, Fault) and unread:
        raise unread[0]
    return found


def in_file(ending: str, file: BinaryIO, most: int) -> Candidate | Fault:
    """Take a source file, or search an archive.

    Args:
        ending: Of the file's name; a source file may have any name that ends so.
        file: It can be sought in.
        most: Bytes of a source file that are read.
    """
    if ending.lower() in _SOURCE_ENDINGS:
        return Candidate(SOURCE_NAME, file.read(most))
    size = file.seek(0, os.SEEK_END)
    file.seek(0)
    if size > LARGEST_ARCHIVE:
        return Fault(f"larger than {LARGEST_ARCHIVE // 2**20} MiB; hand in only {SOURCE_NAME}")
    try:
        return _in_archive(file, most)
    except Damage as damage:
        return damage.fault


def _in_archive(file: BinaryIO, most: int) -> Candidate | Fault:
    start = file.read(TAR_MARK_PLACE + len(TAR_MARK))
    file.seek(0)
    if start.startswith(ZIP_MARKS):
        return choose(zip_entries(file), most)
    if start.startswith(GZIP_MARK):
        unpacked = BufferedReader(Gunzip(file, LARGEST_TAR))
        return choose(tar_entries(unpacked), most)
    if start.endswith(TAR_MARK):
        return choose(tar_entries(file), most)
    return Fault(
        "neither a C++ file nor a folder, .zip or .tar.gz; "
        f"hand in {SOURCE_NAME} or a .zip with it"
    )
