"""Where do results lie, and of which of them is it sure that the grader wrote them?"""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from grader.errors import UsageError
from grader.gradebook.known import is_students
from grader.gradebook.marks import HANDED_IN
from grader.output import OUTPUT, RESULT, STORE, STUDENTS
from grader.plain import as_name


def result_paths(folder: Path) -> list[Path]:
    """Find every result below a folder, in the order of their folders; no link is followed.

    Nothing in a result says who wrote it: a submission may hold a forged one, or an honest one
    of its author's own `bvhgrade check`. So none is taken where submissions lie, nor where two
    could be of one student. Where `bvhgrade batch` keeps a class, only the folders of its
    students are looked at: the download may lie beside them.

    Raises:
        UsageError: There is none, or it is not sure that all are the grader's.
    """
    found: list[Path] = []
    is_class = (folder / STORE).is_file()
    for here, folders, files in os.walk(folder, onerror=_unread):
        folders.sort()
        if is_class and Path(here) == folder:
            folders[:] = [name for name in folders if name == STUDENTS]
            continue
        if handed_in := [name for name in files if name.lower().endswith(HANDED_IN)]:
            raise _not_apart(folder, Path(here) / min(handed_in))
        if RESULT in files:
            found.append(Path(here) / RESULT)
    if not found:
        raise UsageError(f"{folder}: no {RESULT} below it; name the folder of the results")
    _require_one_each(found)
    return found


def strays_in(home: Path) -> Iterator[Path]:
    """Find results beside the students' folders of a class, but none of a download.

    Args:
        home: Folder of the class.
    """
    for top in sorted(home.iterdir()):
        if top.name == RESULT:
            yield top
        if top.name == STUDENTS or top.is_symlink():
            continue
        walked = list(os.walk(top))
        names = [name.lower() for _, _, files in walked for name in files]
        if not any(name.endswith(HANDED_IN) for name in names):
            yield from sorted(
                Path(here) / RESULT for here, _, files in walked if RESULT in files
            )


def _require_one_each(found: Sequence[Path]) -> None:
    """Refuse results of which one lies in the folder of another.

    Raises:
        UsageError: Two do.
    """
    whose = {owner(path): path for path in found}
    for path in found:
        own = owner(path)
        for above in (own, *own.parents):
            if whose.get(above, path) != path:
                raise _two_of_one(path, whose[above])


def owner(path: Path) -> Path:
    """Find the folder that is called after the student."""
    here = path.parent
    # Where `grade` writes by itself, the folder above is the student's; in a class it is not.
    return here.parent if here.name == OUTPUT and not is_students(here.parent) else here


def _not_apart(folder: Path, file: Path) -> UsageError:
    shown = as_name(file.relative_to(folder).as_posix())
    return UsageError(
        f"{folder}: a submission lies there (`{shown}`), and with it could have come any "
        f"{RESULT}; grade into a folder apart from the submissions (-o) and name that one"
    )


def _two_of_one(first: Path, second: Path) -> UsageError:
    return UsageError(
        f"{first} and {second}: one lies in the folder of the other, so one of them may have "
        "been handed in; remove it, or grade into an empty folder"
    )


def _unread(fault: OSError) -> None:
    raise UsageError(f"{fault.filename}: {fault.strerror}, but results may lie there")
