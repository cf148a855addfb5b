"""Everybody's submission is found in every kind of download, under the right name and id."""

from pathlib import Path
from zipfile import ZIP_STORED

import pytest

from grader.batch.gradescope import submitters
from grader.batch.sources import opened_class
from grader.errors import UsageError
from tests.batch.classes import CODE, Files, Made, class_of, folder_of, found_in, zip_of
from tests.batch.platforms import (
    CANVAS,
    FLAT,
    GITHUB,
    GRADESCOPE,
    METADATA,
    MOODLE,
    PLAIN,
    TYPED,
)
from tests.intake.archives import zipped


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


def test_no_name_of_gradescope_is_lost_without_a_word(
    made: Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Notes of which only a part is read, or nothing, would leave somebody without one."""
    path = made(tmp_path, "download", GRADESCOPE)
    monkeypatch.setattr("grader.batch.sources.LARGEST_NOTES", len(METADATA.encode()))
    assert found_in(path)[0] == "Gradescope"
    monkeypatch.setattr("grader.batch.sources.LARGEST_NOTES", len(METADATA.encode()) - 1)
    with pytest.raises(UsageError, match=r"submission_metadata\.yml: more than 0 MiB"):
        found_in(path)


def test_notes_of_gradescope_that_cannot_be_read_are_told(tmp_path: Path) -> None:
    """Without them everybody would be called after a folder."""
    path = folder_of(tmp_path, "download", {"submission_1/exercise03.cpp": CODE})
    (path / "submission_metadata.yml").symlink_to("nowhere")
    with pytest.raises(UsageError, match="this is no file, but one with the names"):
        found_in(path)
    (path / "submission_metadata.yml").unlink()
    files = {"submission_1/exercise03.cpp": CODE, "submission_metadata.yml": METADATA}
    whole = zipped([(name, text.encode()) for name, text in files.items()], ZIP_STORED)
    broken = tmp_path / "broken.zip"
    broken.write_bytes(whole.replace(b"Ada Lovelace", b"Eva Lovelace"))
    with pytest.raises(UsageError, match=r"metadata\.yml: .*download it again"):
        found_in(broken)


def test_github_classroom(made: Made, tmp_path: Path) -> None:
    """The login without the name of the assignment."""
    layout, found = found_in(made(tmp_path, "download", GITHUB))
    assert layout == "GitHub Classroom"
    assert found == {"ada": ("ada", "", CODE), "ben-b": ("ben-b", "", "b")}


@pytest.mark.parametrize("beside", [{}, {"bvh-cy/exercise03.cpp": "c"}])
def test_files_in_a_folder_that_is_called_like_a_clone(
    made: Made, tmp_path: Path, beside: Files
) -> None:
    """Without folders it is none; and one of such a name is a student's like the others."""
    files = {"ada.cpp": CODE, "ben.cpp": "b", **beside}
    layout, found = found_in(made(tmp_path, "bvh-submissions", files))
    assert layout == "plain"
    names = {"ada", "ben"} | ({"bvh-cy"} if beside else set())
    assert set(found) == names


def test_by_hand(made: Made, tmp_path: Path) -> None:
    """Files, folders and archives; what is nobody's is named, what is hidden is not."""
    path = made(tmp_path, "class", PLAIN)
    layout, found = found_in(path)
    assert layout == "plain"
    texts = {name: text for name, (_, _, text) in found.items()}
    assert texts == {"ada": CODE, "ben": "b", "cy.tar": "c"}
    with class_of(path) as class_:
        assert class_.others == ("grades.csv",)


def test_who_packed_it_otherwise_is_somebody_too(made: Made, tmp_path: Path) -> None:
    """A row with the reason, and none for what lies beside a file that can be graded."""
    files: Files = {
        "ada.rar": "Rar!",
        "ben.7z": "7z",
        "cy.cpp.txt": CODE,
        "di.c": CODE,
        "eve.cpp": CODE,
        "eve.rar": "Rar!",
        **dict.fromkeys(("README.md", "grades.csv", ".hidden.rar", "sheet.pdf", "bvh.h"), ""),
    }
    path = made(tmp_path, "class", files)
    layout, found = found_in(path)
    assert (layout, found.pop("eve")) == ("plain", ("", "", CODE))
    assert found.keys() == {"ada", "ben", "cy", "di"}
    assert all("hand in exercise03.cpp" in reason for _, _, reason in found.values())
    with class_of(path) as class_:
        others = ("README.md", "bvh.h", "eve.rar", "grades.csv", "sheet.pdf")
        assert class_.others == others


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
    ("files", "platform"),
    [
        (MOODLE, "Moodle"),
        (CANVAS, "Canvas"),
        ({f"bvh-{name}/exercise03.cpp": CODE for name in "abc"}, "GitHub Classroom"),
    ],
    ids=["Moodle", "Canvas", "GitHub Classroom"],
)
def test_what_was_added_to_a_download_is_named(
    made: Made, tmp_path: Path, files: Files, platform: str
) -> None:
    """Everybody would lose name and number, and be another one than in the last download."""
    path = made(tmp_path, "bvh-submissions", {**files, "mine/exercise03.cpp": CODE})
    with (
        pytest.raises(UsageError, match=f"{platform}, but `mine` is none of it"),
        class_of(path),
    ):
        pass


def test_what_a_grade_left_in_a_download_is_nobodys(made: Made, tmp_path: Path) -> None:
    """`bvhgrade grade` writes where it is called."""
    files = {**MOODLE, "bvhgrade-out/result.json": "{}", "bvhgrade-out/exercise03.cpp": CODE}
    with class_of(made(tmp_path, "CG", files)) as class_:
        assert class_.layout == "Moodle"
        assert "bvhgrade-out" in class_.others


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
