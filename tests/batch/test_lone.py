"""One folder or one file may be a class, or what a single student handed in."""

from functools import partial
from pathlib import Path

import pytest

from grader.intake.handed_in import handed_in
from grader.model.stages import Rejected, Submission
from tests.batch.classes import CODE, Files, Made, class_of, folder_of, found_in
from tests.batch.platforms import CANVAS, FLAT, MOODLE, PLAIN


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
