"""A second download finds everybody again, whatever the platform calls them or it meanwhile."""

import sqlite3
import unicodedata
from hashlib import sha256
from pathlib import Path

import pytest

from grader.batch.keys import key_of
from grader.batch.records import Student
from grader.batch.runner import Batch
from grader.batch.store import opened_store
from tests.batch.classes import CODE, Files, Seen, class_of, folder_of, packed
from tests.batch.stand_in import job

NOTES = "submission_{}:\n  :submitters:\n  - :name: {}\n    :sid: '{}'\n    :email: {}\n"
UMLAUT = "jörg"


def of_gradescope(*people: tuple[str, str, str, str, str]) -> Files:
    """Write an export: per folder its number, name, sid, e-mail address and the file."""
    files = {f"submission_{one[0]}/exercise03.cpp": one[4] for one in people}
    notes = "".join(NOTES.format(*one[:4]) for one in people)
    return {**files, "submission_metadata.yml": notes}


TWO: dict[str, tuple[Files, Files]] = {
    "Moodle": (
        {"Ada Lovelace_101_assignsubmission_file_/x.cpp": "wrong"},
        {"Ada King_101_assignsubmission_file_x.cpp": CODE},
    ),
    "Canvas": (
        {"lovelaceada_9001_7_x.cpp": "wrong"},
        {"kingada_LATE_9001_8_x.cpp": CODE},
    ),
    "Canvas, anonymous": (
        {"anon_Xy12z_7_x.cpp": "wrong"},
        {"LATE_anon_Xy12z_8_x.cpp": CODE},
    ),
    "Gradescope": (
        of_gradescope(("1", "Ada Lovelace", "9001", "a@uni.example", "wrong")),
        of_gradescope(("2", "Ada King", "9001", "b@uni.example", CODE)),
    ),
    "Gradescope, by address": (
        of_gradescope(("1", "Ada Lovelace", "", "a@uni.example", "wrong")),
        of_gradescope(("2", "Ada King", "", "a@uni.example", CODE)),
    ),
    "GitHub Classroom": (
        {"bvh-ada/exercise03.cpp": "wrong"},
        {"bvh-ada/src/exercise03.cpp": CODE},
    ),
    "plain": ({"ada.cpp": "wrong"}, {"ada.zip": packed({"exercise03.cpp": CODE})}),
    "plain, as a folder": ({"ada.cpp": "wrong"}, {"ada/exercise03.cpp": CODE}),
    "plain, with an umlaut": (
        {unicodedata.normalize("NFC", f"{UMLAUT}.cpp"): "wrong"},
        {unicodedata.normalize("NFD", f"{UMLAUT}.cpp"): CODE},
    ),
}


@pytest.mark.parametrize("name", TWO)
def test_a_second_download_replaces_the_first(tmp_path: Path, name: str) -> None:
    """One student, with the newer file, in the folder of before."""
    first, second = TWO[name]
    (before,) = read(tmp_path, first, name)
    (after,) = read(tmp_path, second, name)
    assert (before.slug, before.sha256) == (after.slug, digest("wrong"))
    assert after.sha256 == digest(CODE)


def test_who_packed_it_otherwise_may_hand_in_again(tmp_path: Path) -> None:
    """Under the same name, whatever it ended with."""
    (before,) = read(tmp_path, {"ada.tar.xz": "x"}, "plain")
    (after,) = read(tmp_path, {"ada.cpp": CODE}, "plain")
    assert (before.slug, before.sha256) == (after.slug, None)
    assert (after.sha256, after.reason) == (digest(CODE), "")


def test_two_of_one_download_stay_two(tmp_path: Path) -> None:
    """Whatever they share: neither is graded in place of the other."""
    person = ("Ada", "9001", "a@uni.example")
    classes: list[Files] = [
        of_gradescope(("1", *person, "a"), ("2", *person, "b")),
        {"ada.cpp": "a", "ada.zip": packed({"exercise03.cpp": "b"})},
        {"lovelaceada_9001_7_x.cpp": "a", "eve_9001_55_8_x.cpp": "b"},
    ]
    for number, files in enumerate(classes):
        with class_of(folder_of(tmp_path, f"class-{number}", files)) as class_:
            assert len({place.key for place in class_.places}) == 2


def test_a_number_means_something_in_its_own_layout_only() -> None:
    """The participant 12 of Moodle has not handed in `12.cpp`."""
    assert key_of("Moodle", "12") != key_of("plain", "12")


OLD: list[tuple[str, str, str, str, str]] = [
    ("Ada Lovelace_101", "Moodle", "Ada Lovelace", "101", ""),
    ("lovelaceada_9001", "Canvas", "lovelaceada", "9001", ""),
    ("anon_Xy12z_Xy12z", "Canvas", "anon_Xy12z", "Xy12z", ""),
    ("submission_1/9001", "Gradescope", "Ada Lovelace", "9001", "a@uni.example"),
    ("bvh-ada", "GitHub Classroom", "ada", "ada", ""),
    ("ada.cpp", "plain", "ada", "", ""),
]
"""Key, layout, name, id and address in a store of version 1, each as of the first download."""


@pytest.mark.parametrize("old", OLD, ids=[one[1] + one[3] for one in OLD])
def test_a_store_of_before_goes_on(tmp_path: Path, old: tuple[str, str, str, str, str]) -> None:
    """Its students are those of today, although their keys were made otherwise."""
    key, layout, name, id, email = old
    first, second = TWO["Canvas, anonymous" if name.startswith("anon") else layout]
    (before,) = read(tmp_path, first, layout)
    assert (before.layout, before.name, before.id, before.email) == (layout, name, id, email)
    as_before(tmp_path, key)
    (after,) = read(tmp_path, second, layout)
    assert (after.slug, after.sha256) == (before.slug, digest(CODE))


def test_who_was_two_before_stays_two_until_somebody_decides(tmp_path: Path) -> None:
    """The last one is replaced from now on; nothing of the other is lost."""
    first, second = TWO["Gradescope"]
    read(tmp_path, first, "Gradescope")
    as_before(tmp_path, "submission_1/9001", version=2)
    read(tmp_path, second, "Gradescope")
    as_before(tmp_path, "submission_2/9001")
    newest = of_gradescope(("3", "Ada King", "9001", "b@uni.example", "newest"))
    found = read(tmp_path, newest, "Gradescope")
    assert {one.sha256 for one in found} == {digest("wrong"), digest("newest")}


def read(parent: Path, files: Files, layout: str) -> list[Student]:
    """Write down what a download holds; all students of the class."""
    name = "bvh-submissions" if layout == "GitHub Classroom" else "class"
    number = len(list(parent.glob("download-*")))
    path = folder_of(parent / f"download-{number}", name, files)
    (parent / "out").mkdir(exist_ok=True)
    with class_of(path) as class_, opened_store(parent / "out") as store:
        Batch(job(parent / "out"), store, Seen()).read(class_)
        return list(store.students())


def digest(text: str) -> str:
    """Name a file by its content."""
    return sha256(text.encode()).hexdigest()


def as_before(parent: Path, key: str, version: int = 1) -> None:
    """Let the store be of a version, and give its last student the key of version 1."""
    with sqlite3.connect(parent / "out/batch.sqlite") as base:
        base.execute(
            "UPDATE student SET key = ? WHERE rowid = (SELECT max(rowid) FROM student)",
            (key.encode(),),
        )
        base.execute(f"PRAGMA user_version = {version}")
    base.close()
