"""Which source file is in what a learning system keeps of a student?

A file that was handed in alone lies in a folder there, or has a new name. It is looked at as
the student handed it in: a C++ file of any name, or an archive. Several are searched together.
"""

from collections.abc import Callable, Iterator
from errno import ENOENT
from io import BytesIO
from pathlib import PurePosixPath

from grader.intake.candidates import (
    Candidate,
    Damage,
    Entry,
    Fault,
    choose,
    is_junk,
    is_source,
    parts,
)
from grader.intake.locate import LARGEST_ARCHIVE, in_file, judged
from grader.model.stages import Rejected, Submission
from grader.plain import as_name


def handed_in(
    student: str, entries: Callable[[], Iterator[Entry]], source_limit: int
) -> Submission | Rejected:
    """Find and read the one source file of a submission.

    Args:
        student: A stranger's name.
        entries: Lists what there is, as often as it is called.
        source_limit: Largest source file in bytes.

    Raises:
        OSError: Some of it is gone, or may not be read.
    """
    return judged(as_name(student), _found(entries, source_limit + 1), source_limit)


def _found(entries: Callable[[], Iterator[Entry]], most: int) -> Candidate | Fault:
    try:
        alone = _alone(entries())
        if not alone or is_source(alone):
            return choose(entries(), most)
        return _in_lone_file(alone, entries(), most)
    except Damage as damage:
        return damage.fault


def _alone(entries: Iterator[Entry]) -> str:
    """Name the only file; empty if there is none, or more than one."""
    alone = ""
    for entry in entries:
        if entry.path.endswith("/") or is_junk(entry.path):
            continue
        if alone:
            return ""
        alone = entry.path
    return alone


def _in_lone_file(path: str, entries: Iterator[Entry], most: int) -> Candidate | Fault:
    for entry in entries:
        if entry.path == path:
            content = entry.read(LARGEST_ARCHIVE + 1)
            if isinstance(content, Fault):
                return content
            return in_file(PurePosixPath(parts(path)[-1]).suffix, BytesIO(content), most)
    raise FileNotFoundError(ENOENT, "it was there a moment ago, and is gone")
