"""One folder or one file may be a class, or what a single student handed in."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from grader.batch.runner import Batch
from grader.batch.store import opened_store
from grader.intake.handed_in import handed_in
from grader.model.stages import Rejected, Submission
from tests.batch.classes import CODE, Files, Made, Seen, class_of, folder_of, found_in
from tests.batch.platforms import CANVAS, FLAT, GITHUB, MOODLE, PLAIN
from tests.batch.stand_in import job

NOBODY = 65534


def test_a_folder_around_the_class_is_entered(made: Made, tmp_path: Path) -> None:
    """As many programs pack it; but the only student of a class is one."""
    wrapped = {f"class/{name}": content for name, content in PLAIN.items()}
    assert len(found_in(made(tmp_path, "x", wrapped))[1]) == 3
    alone = {"ada/src/exercise03.cpp": CODE, "ada/include/bvh.h": "x"}
    assert found_in(made(tmp_path, "y", alone))[1] == {"ada": ("", "", CODE)}


@pytest.mark.parametrize(
    ("files", "layout", "count"),
    [(MOODLE, "Moodle", 4), (CANVAS, "Canvas", 4), (PLAIN, "plain", 3)],
)
def test_an_output_folder_inside_is_nobody(
    tmp_path: Path, files: Files, layout: str, count: int
) -> None:
    """`-o` may lie in the class's own folder; it is named, like all that is not graded."""
    results = {"out/batch.sqlite": "", "out/students/ada/result.json": "{}"}
    path = folder_of(tmp_path, "class", {**files, **results})
    told, found = found_in(path)
    assert (told, len(found)) == (layout, count)
    with class_of(path) as class_:
        assert "out" in class_.others


def test_whoever_hands_in_a_store_is_graded_too(tmp_path: Path) -> None:
    """A submission is no output, whatever lies in it."""
    files = {"ada.cpp": CODE, "cy/exercise03.cpp": "c", "cy/batch.sqlite": ""}
    _, found = found_in(folder_of(tmp_path, "class", files))
    assert {name: text for name, (_, _, text) in found.items()} == {"ada": CODE, "cy": "c"}


def test_a_lone_file_is_taken_as_it_was_handed_in(tmp_path: Path) -> None:
    """Several are searched for the one name, as a folder is."""
    path = folder_of(
        tmp_path, "class", {"ada/mine.cpp": CODE, "ben/mine.cpp": "b", "ben/notes.txt": "n"}
    )
    with class_of(path) as class_:
        ada, ben = (
            handed_in(place.name, partial(place.entries, class_.source), 1 << 16)
            for place in class_.places
        )
    assert isinstance(ada, Submission)
    assert isinstance(ben, Rejected)
    assert "mine.cpp" in ben.reason


@pytest.mark.parametrize(
    ("name", "folder", "student"),
    [
        ("class", f"Eve Adams_99{FLAT}", "Eve Adams"),
        ("class", "submission_99", "submission_99"),
        ("bvh-submissions", "bvh-eve", "eve"),
    ],
)
def test_the_only_student_s_folder_is_not_entered(
    made: Made, tmp_path: Path, name: str, folder: str, student: str
) -> None:
    """A platform made it; what is in it Eve named after Ada."""
    path = made(tmp_path, name, {f"{folder}/Ada Lovelace_101{FLAT}x.cpp": "eve"})
    assert found_in(path)[1].keys() == {student}


def test_a_lone_folder_with_the_file_in_it_is_a_student(made: Made, tmp_path: Path) -> None:
    """Whatever else lies beside it; two students would be two folders or files."""
    files: Files = {"ada/exercise03.cpp": CODE, "ada/helper.cpp": "h"}
    assert found_in(made(tmp_path, "class", files))[1] == {"ada": ("", "", CODE)}
    files = {"ada/exercise03.cpp": CODE, f"ada/Ben_9{FLAT}x.cpp": "h"}
    assert found_in(made(tmp_path, "other", files))[1] == {"ada": ("", "", CODE)}


@pytest.mark.parametrize("name", ["bvh-submissions", "download"])
@pytest.mark.parametrize("around", ["", "bvh-submissions/"], ids=["once", "twice"])
def test_the_folder_of_a_clone_is_no_student(
    made: Made, tmp_path: Path, name: str, around: str
) -> None:
    """It begins as the folders of students do, whatever the zip is called."""
    files = {f"{around}{path}": content for path, content in GITHUB.items()}
    layout, found = found_in(made(tmp_path, name, files))
    assert layout == "GitHub Classroom"
    assert found == {"ada": ("ada", "", CODE), "ben-b": ("ben-b", "", "b")}
    only = {path: content for path, content in files.items() if "-ada/" in path}
    (tmp_path / "one").mkdir()
    assert found_in(made(tmp_path / "one", name, only))[1].keys() == {"ada"}


@pytest.mark.parametrize(
    "files",
    [
        {f"class/{name}/exercise03.cpp": CODE for name in ("ada", "ben", "cy")},
        {f"class/{name}/work.zip": CODE for name in ("ada", "ben", "cy")},
        {f"class/{name}.zip": CODE for name in ("ada", "ben", "cy")},
    ],
    ids=["files", "archives in folders", "archives"],
)
def test_who_handed_in_nothing_to_grade_changes_nothing_for_others(
    made: Made, tmp_path: Path, files: dict[str, str]
) -> None:
    """The class lies in one folder, and two are named with the reason why they have none."""
    odd = {"class/di/x.rar": "x", "class/eve/readme.pdf": "x"}
    _, found = found_in(made(tmp_path, "class", {**files, **odd}))
    assert found.keys() == {"ada", "ben", "cy", "di", "eve"}
    assert "hand in exercise03.cpp" in found["di"][2]
    assert "hand in exercise03.cpp" in found["eve"][2]


def test_a_clone_of_which_one_handed_in_is_a_class(made: Made, tmp_path: Path) -> None:
    """What ends with -submissions was made for a class, whatever is in it."""
    files = {"ex3-submissions/ada/exercise03.cpp": CODE, "ex3-submissions/ben/x.rar": "x"}
    assert found_in(made(tmp_path, "download", files))[1].keys() == {"ada", "ben"}


@pytest.mark.parametrize("around", ["", "class/"])
def test_a_folder_that_may_not_be_entered_is_one_student_s(around: str) -> None:
    """The others go on, and the reason stands beside the name."""
    with TemporaryDirectory() as parent, not_root(Path(parent)):
        files = {f"{around}{name}/exercise03.cpp": name for name in ("ada", "ben", "cy")}
        path = folder_of(Path(parent), "download", files)
        out = job(Path(parent))
        (path / around / "ben").chmod(0)
        try:
            with class_of(path) as class_, opened_store(out.folder) as store:
                Batch(out, store, Seen()).read(class_)
                faults = {one.name: one.fault for one in store.students()}
        finally:
            (path / around / "ben").chmod(0o700)
    assert faults == {"ada": "", "ben": "it could not be read: Permission denied", "cy": ""}


@contextmanager
def not_root(folder: Path) -> Iterator[None]:
    """Let the kernel ask for rights meanwhile, in a folder of one's own."""
    if os.geteuid() != 0:
        yield
        return
    os.chown(folder, NOBODY, NOBODY)
    os.seteuid(NOBODY)
    try:
        yield
    finally:
        os.seteuid(0)
