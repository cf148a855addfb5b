"""Everybody's submission is found in every kind of download, under the right name and id."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from grader.batch.gradescope import submitters
from grader.batch.sources import opened_class
from grader.errors import UsageError
from grader.intake.handed_in import handed_in
from grader.model.stages import Rejected, Submission
from tests.batch.classes import CODE, Files, class_of, folder_of, found_in, packed, zip_of

Made = Callable[[Path, str, Files], Path]

METADATA = """---
submission_101:
  :submitters:
  - :name: Ada Lovelace
    :sid: '9001'
    :email: ada@uni.example
  :created_at: 2026-11-01 10:00:00.000000000 Z
  :results:
    :output: |
      :submitters:
      - :name: nobody
submission_102:
  :submitters:
  - :name: "Zo\\xEB \\"Z\\" Ng"
    :sid: '9002'
    :email: zoe@uni.example
  - :name: 'O''Neil'
    :sid: ''
    :email: neil@uni.example
"""

MOODLE: Files = {
    "Ada Lovelace_657717_assignsubmission_file_/mine.cpp": CODE,
    "Ada Lovelace_657717_assignsubmission_onlinetext_/onlinetext.html": "hello",
    "Ben_B_Berg_657718_assignsubmission_file/b.zip": packed({"x/exercise03.cpp": "b"}),
    "Cy Clo_657719_assignsubmission_file_my own.cpp": "c",
    "Di Da_657720_assignsubmission_onlinetext_/onlinetext.html": "here is my code",
}

CANVAS: Files = {
    "lovelaceada_9001_70001_exercise03-2.cpp": CODE,
    "lovelaceada_9001_70002_notes.txt": "notes",
    "berg_ben_LATE_9002_70003_any name.cpp": "b",
    "anon_Xy12z_70004_exercise03.cpp": "c",
    "LATE_anon_Q1w2e_70005_solution.zip": packed({"exercise03.cpp": "d"}),
}

GRADESCOPE: Files = {
    "assignment_5_export/submission_metadata.yml": METADATA,
    "assignment_5_export/submission_101/exercise03.cpp": CODE,
    "assignment_5_export/submission_102/src/exercise03.cpp": "b",
    "assignment_5_export/submission_103/other.cpp": "c",
}

GITHUB: Files = {
    "bvh-submissions/bvh-ada/.git/HEAD": "ref",
    "bvh-submissions/bvh-ada/src/exercise03.cpp": CODE,
    "bvh-submissions/bvh-ada/README.md": "sheet",
    "bvh-submissions/bvh-ben-b/src/exercise03.cpp": "b",
    "bvh-submissions/bvh-ben-b/README.md": "sheet",
}

PLAIN: Files = {
    "ada.cpp": CODE,
    "ben/exercise03.cpp": "b",
    "ben/readme.txt": "hello",
    "cy.tar.zip": packed({"a/exercise03.cpp": "c"}),
    "grades.csv": "nobody's",
    ".DS_Store": "x",
    "__MACOSX/._ada.cpp": "x",
}


@pytest.fixture(params=[folder_of, zip_of], ids=["folder", "zip"])
def made(request: pytest.FixtureRequest) -> Made:
    """Make a class as a folder, and as a zip."""
    make: Made = request.param
    return make


def test_moodle(made: Made, tmp_path: Path) -> None:
    """Folders and flat names; what was typed is no file."""
    layout, found = found_in(made(tmp_path, "CG-Exercise 3-4711", MOODLE))
    assert layout == "Moodle"
    assert "C++" in found.pop("Di Da")[2]
    assert found == {
        "Ada Lovelace": ("657717", "", CODE),
        "Ben_B_Berg": ("657718", "", "b"),
        "Cy Clo": ("657719", "", "c"),
    }


def test_canvas(made: Made, tmp_path: Path) -> None:
    """Late ones, anonymous ones, and the number that Canvas adds to a second version."""
    layout, found = found_in(made(tmp_path, "submissions", CANVAS))
    assert layout == "Canvas"
    assert found == {
        "lovelaceada": ("9001", "", CODE),
        "berg_ben": ("9002", "", "b"),
        "anon_Xy12z": ("Xy12z", "", "c"),
        "anon_Q1w2e": ("Q1w2e", "", "d"),
    }


def test_gradescope(made: Made, tmp_path: Path) -> None:
    """Names from the notes, both of a group, and a folder of which they say nothing."""
    layout, found = found_in(made(tmp_path, "download", GRADESCOPE))
    assert layout == "Gradescope"
    assert found == {
        "Ada Lovelace": ("9001", "ada@uni.example", CODE),
        'Zoë "Z" Ng': ("9002", "zoe@uni.example", "b"),
        "O'Neil": ("", "neil@uni.example", "b"),
        "submission_103": ("", "", "c"),
    }


def test_half_a_character_in_the_notes_of_gradescope_is_replaced() -> None:
    """No store and no file could take it, and the whole class would end there."""
    text = METADATA.replace("Zo\\xEB", "Zo\\ud800").replace(
        "'9002'", '"9\\udc80\\ud83d\\ude00"'
    )
    zoe, _ = submitters(text.encode().splitlines())["submission_102"]
    assert (zoe.name, zoe.id) == ('Zo? "Z" Ng', "9?\U0001f600")


def test_github_classroom(made: Made, tmp_path: Path) -> None:
    """The login without the name of the assignment."""
    layout, found = found_in(made(tmp_path, "download", GITHUB))
    assert layout == "GitHub Classroom"
    assert found == {"ada": ("ada", "", CODE), "ben-b": ("ben-b", "", "b")}


def test_by_hand(made: Made, tmp_path: Path) -> None:
    """Files, folders and archives; what is nobody's is named, what is hidden is not."""
    path = made(tmp_path, "class", PLAIN)
    layout, found = found_in(path)
    assert layout == "plain"
    texts = {name: text for name, (_, _, text) in found.items()}
    assert texts == {"ada": CODE, "ben": "b", "cy.tar": "c"}
    with class_of(path) as class_:
        assert class_.others == ("grades.csv",)


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


FLAT = "_assignsubmission_file_"


def test_only_moodle_says_whose_a_file_is(made: Made, tmp_path: Path) -> None:
    """Eve's and Mal's files are called as if Moodle had named them after Ada and Ben."""
    files: Files = {
        f"Eve Adams_99{FLAT}_Ada Lovelace_4711{FLAT}exercise03.cpp": "eve",
        f"Ben Berg_12{FLAT}exercise03.cpp": "ben",
        f"Mal Ory_13{FLAT}x_12{FLAT}exercise03.cpp": "mal",
    }
    layout, found = found_in(made(tmp_path, "class", files))
    assert layout == "Moodle"
    assert found == {
        "Eve Adams": ("99", "", "eve"),
        "Ben Berg": ("12", "", "ben"),
        "Mal Ory": ("13", "", "mal"),
    }


@pytest.mark.parametrize(
    ("names", "layout"),
    [
        (
            {
                "lovelaceada_9001_70001_exercise03.cpp": "lovelaceada",
                f"adamseve_9003_70003_a_1{FLAT}exercise03.cpp": "adamseve",
            },
            "Canvas",
        ),
        ({f"adamseve_9003_70003_a_1{FLAT}exercise03.cpp": "adamseve"}, "Canvas"),
        ({"ada.cpp": "ada", f"e_1{FLAT}x.cpp": f"e_1{FLAT}x"}, "plain"),
        (
            {f"Ben Berg_12{FLAT}x_9002_70002_exercise03.cpp": "Ben Berg"},
            "Moodle",
        ),
    ],
    ids=["canvas", "only one", "plain", "moodle"],
)
def test_one_file_s_name_changes_nobody_s_layout(
    made: Made, tmp_path: Path, names: dict[str, str], layout: str
) -> None:
    """Everybody is graded, and under the name that the platform gave."""
    told, found = found_in(made(tmp_path, "class", dict.fromkeys(names, CODE)))
    assert (told, list(found)) == (layout, sorted(names.values()))


@pytest.mark.parametrize(
    ("files", "layout"),
    [(MOODLE, "Moodle"), (GRADESCOPE, "Gradescope"), (GITHUB, "GitHub Classroom")],
)
def test_what_is_not_taken_is_named(
    made: Made, tmp_path: Path, files: Files, layout: str
) -> None:
    """In every layout."""
    top = "" if layout == "Moodle" else next(iter(files)).partition("/")[0] + "/"
    path = made(tmp_path, "class", {**files, f"{top}notes.txt": "mine"})
    with class_of(path) as class_:
        assert (class_.layout, class_.others) == (layout, ("notes.txt",))


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    """Neither a student's file nor a folder of one leads out of the class."""
    secret = folder_of(tmp_path, "secret", {"exercise03.cpp": "secret"})
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "ben/x.txt": "x"})
    (path / "cy.cpp").symlink_to(secret / "exercise03.cpp")
    (path / "di").symlink_to(secret)
    (path / "ben/exercise03.cpp").symlink_to(secret / "exercise03.cpp")
    texts = [text for _, _, text in found_in(path)[1].values()]
    assert texts[0] == CODE
    assert "secret" not in "".join(texts)


@pytest.mark.parametrize(
    "name",
    ["../../etc", "/etc/passwd", "C:\\x\\y", "a\x00b", "\x1b[31m", "=cmd|'/c calc'!A0"],
)
def test_hostile_names_in_a_zip_stay_text(tmp_path: Path, name: str) -> None:
    """They lead nowhere, and what is shown of them is printable."""
    path = zip_of(tmp_path, "class", {f"{name}/exercise03.cpp": CODE, "ada.cpp": "a"})
    with opened_class(path) as source:
        for item in source.items():
            for entry in source.entries(item.name):
                assert entry.read(100) in {CODE.encode(), b"a"}
    layout, found = found_in(path)
    assert layout == "plain"
    assert len(found) == 2


def test_what_is_no_class_is_refused(tmp_path: Path) -> None:
    """With a sentence that says what is there."""
    (tmp_path / "x.zip").write_bytes(b"Rar!....")
    (tmp_path / "y.zip").write_bytes(b"PK\x03\x04....")
    for name, words in (("x.zip", "no zip"), ("y.zip", "damaged")):
        with pytest.raises(UsageError, match=words), class_of(tmp_path / name):
            pass


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


TYPED: Files = {
    "berg_9002_text.html": "<p>my code</p>",
    "clocy_LATE_9003_link.html": "https://example.org",
    "anon_Xy12z_text.html": "a",
    "LATE_anon_Q1w2e_link.html": "b",
    "gradebook.csv": "nobody's",
}


def test_what_was_typed_into_canvas_is_one_student_s(made: Made, tmp_path: Path) -> None:
    """Canvas writes it into a file of its own, which cannot be graded; the others can."""
    files = {"lovelaceada_9001_70001_exercise03.cpp": CODE, **TYPED}
    files["adamseve_9004_70004_x_9001_text.html"] = "eve"
    path = made(tmp_path, "submissions", files)
    layout, found = found_in(path)
    assert layout == "Canvas"
    assert found.pop("lovelaceada") == ("9001", "", CODE)
    assert {name: id for name, (id, _, _) in found.items()} == {
        "berg": "9002",
        "clocy": "9003",
        "anon_Xy12z": "Xy12z",
        "anon_Q1w2e": "Q1w2e",
        "adamseve": "9004",
    }
    assert all("hand in exercise03.cpp" in reason for _, _, reason in found.values())
    with class_of(path) as class_:
        assert class_.others == ("gradebook.csv",)
