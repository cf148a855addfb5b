"""Results are read from folders, strictly, and belong to whom the folder says."""

import json
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.paths import result_paths
from grader.gradebook.results import Ids, ids_by_batch, ids_of, results_in
from tests.gradebook.folders import CLASS, write_batch, write_class
from tests.report import real


def test_every_result_is_found_in_order(tmp_path: Path) -> None:
    """Also of groups, with the student's name from the folder."""
    write_class(tmp_path / "group-b", {"zoe": "right"})
    write_class(tmp_path / "group-a", {"bob": "rejected", "ada": "right"})
    found = results_in(tmp_path)
    assert [one.student for one in found] == ["ada", "bob", "zoe"]
    assert [one.result["score"] for one in found] == [50, 0, 50]


def test_a_submission_s_own_name_is_nobody_s_id(tmp_path: Path) -> None:
    """It is the student's to choose: Bob might hand in a file that is called ada.zip."""
    write_class(tmp_path, {"bob": "rejected"})
    path = tmp_path / "bob" / "result.json"
    result = json.loads(path.read_text())
    result["submission"]["name"] = "ada"
    path.write_text(json.dumps(result))
    (one,) = results_in(tmp_path)
    assert "ada" not in (one.student, one.ids.full_name, *one.ids.accounts)


@pytest.mark.parametrize(
    "folders",
    [("bob", "bob/files/ada"), ("eve", "eve/bvhgrade-out"), ("fay/bvhgrade-out", "fay/ada")],
)
def test_two_results_in_one_folder_are_refused(
    tmp_path: Path, folders: tuple[str, str]
) -> None:
    """One of them could have been handed in, for oneself or in somebody else's name."""
    write_class(tmp_path, dict.fromkeys(folders, "right") | {"zoe": "right"})
    with pytest.raises(UsageError, match="one lies in the folder of the other") as fault:
        results_in(tmp_path)
    assert all(f"{tmp_path / each}/result.json" in str(fault.value) for each in folders)


@pytest.mark.parametrize("brought", ["eve", "eve/bvhgrade-out", "eve/ada", "eve/.git/x"])
@pytest.mark.parametrize("file", ["bob/src/exercise03.cpp", "eve/Mine.ZIP", "ada.tar.gz"])
def test_no_result_is_taken_where_submissions_lie(
    tmp_path: Path, brought: str, file: str
) -> None:
    """Whoever handed something in could have brought it: everybody can, by `check`."""
    write_class(tmp_path, {brought: "right", "bob/bvhgrade-out": "rejected"})
    (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / file).touch()
    with pytest.raises(UsageError, match="apart from the submissions") as fault:
        results_in(tmp_path)
    assert f"`{file}`" in str(fault.value)


def test_a_folder_may_be_called_like_a_submission(tmp_path: Path) -> None:
    """`bvhgrade grade ada.zip -o results/ada.zip`."""
    write_class(tmp_path, {"ada.zip": "right"})
    assert [one.student for one in results_in(tmp_path)] == ["ada.zip"]


def test_the_usual_folder_of_grade_belongs_to_the_one_above(tmp_path: Path) -> None:
    """Somebody graded without -o, in a folder for each student's result."""
    write_class(tmp_path, {"ada/bvhgrade-out": "right"})
    assert [one.student for one in results_in(tmp_path)] == ["ada"]


def test_a_result_in_the_current_folder_has_a_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """That of the folder, whatever it was called as."""
    write_class(tmp_path, {"ada": "right"})
    monkeypatch.chdir(tmp_path / "ada")
    assert [one.student for one in results_in(Path())] == ["ada"]


@pytest.mark.parametrize("relative", [False, True])
def test_only_the_store_of_a_class_says_whose_results_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, relative: bool
) -> None:
    """Others lie there of somebody who is gone, or of whoever graded there on their own."""
    write_batch(tmp_path, "plain", {"ada": ("Ada", "", ""), "eve": ("Eve", "", "")})
    write_class(tmp_path, dict.fromkeys(["students/bob", "old"], "right"))
    monkeypatch.chdir(tmp_path)
    found = results_in(Path() if relative else tmp_path, {"eve"})
    assert [one.student for one in found if not one.why] == ["ada"]
    strays = {one.student: one for one in found if one.why}
    assert sorted(strays) == ["old", "students/bob"]
    assert all(one.is_nobody_s for one in strays.values())
    assert "knows no student of this folder" in strays["old"].why


def test_somebody_of_a_class_may_be_called_like_a_folder_of_ours(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A class's folders are its students' own, so nobody is in the folder of another."""
    students = {"ada": ("Ada", "", ""), "bvhgrade-out": ("bvhgrade-out", "", "")}
    write_batch(tmp_path, "plain", students)
    assert [one.student for one in results_in(tmp_path)] == ["ada", "bvhgrade-out"]
    monkeypatch.chdir(tmp_path / "students")
    assert len(result_paths(Path())) == 2, "as `report` looks for them"


@pytest.mark.parametrize("folder", ["class/students", "class/students/ada", "."])
def test_a_class_is_given_as_a_whole(tmp_path: Path, folder: str) -> None:
    """Else nobody would ask its store who has handed in again."""
    written = write_batch(tmp_path / "class", "plain", {"ada": ("Ada", "", "")})
    with pytest.raises(UsageError, match="name the folder of the class") as fault:
        results_in(tmp_path / folder)
    assert str(fault.value).endswith(str(written))


def test_a_store_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    """Without it nobody knows who is part of the class."""
    write_batch(tmp_path, "plain", {"ada": ("Ada", "", "")})
    (tmp_path / "batch.sqlite").write_bytes(b"no data base" * 100)
    with pytest.raises(UsageError, match=r"batch\.sqlite: .*call `bvhgrade batch` again"):
        results_in(tmp_path)


def test_no_link_is_followed(tmp_path: Path) -> None:
    """Neither to a folder nor to a file."""
    write_class(tmp_path / "real", {"ada": "right"})
    write_class(tmp_path / "class", {"bob": "right"})
    (tmp_path / "class" / "eve").symlink_to(tmp_path / "real" / "ada")
    assert [one.student for one in results_in(tmp_path / "class")] == ["bob"]
    (tmp_path / "class" / "mal").mkdir()
    (tmp_path / "class" / "mal" / "result.json").symlink_to(tmp_path / "real/ada/result.json")
    with pytest.raises(UsageError, match=r"mal/result\.json"):
        results_in(tmp_path / "class")


@pytest.mark.parametrize(
    ("name", "ids"),
    [
        (
            "Ada Lovelace_101_assignsubmission_file_",
            Ids(participant="101", full_name="Ada Lovelace"),
        ),
        (
            "Ada Lovelace_101_assignsubmission_file_Bob_102_assignsubmission_file_x",
            Ids(participant="101", full_name="Ada Lovelace"),
        ),
        ("lovelaceada_9001_55_exercise03", Ids(canvas="9001")),
        ("lovelaceada_9001_55_a_1_assignsubmission_file_x", Ids(canvas="9001")),
        ("lovelaceada_LATE_9001_55_x_9002_56_y", Ids(canvas="9001")),
        (
            "anon_9001_55_exercise03",
            Ids(accounts=("anon_9001_55_exercise03",), full_name="anon_9001_55_exercise03"),
        ),
        ("ada@uni.example", Ids(accounts=("ada@uni.example",), full_name="ada@uni.example")),
        ("9001", Ids(accounts=("9001",), canvas="9001", full_name="9001")),
    ],
)
def test_a_platform_s_name_of_a_folder_is_understood(name: str, ids: Ids) -> None:
    """And only its beginning, since the end is the name of the student's file."""
    assert ids_of(name) == ids


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "not JSON"),
        (b"{", "not JSON"),
        (b"\xff\xfe", "not JSON"),
        (b"[" * 100_000, "not JSON"),
        (b"[]", "schema is None, but 1"),
        (b'{"schema": 2}', "schema is 2, but 1"),
        (b'{"schema": 1}', "is not as `bvhgrade schema` says"),
        (b'{"schema": 1, "score": NaN}', "NaN is no number"),
        (b" " * 900_001, "more than 900,000 bytes"),
    ],
)
def test_a_damaged_result_is_named(tmp_path: Path, content: bytes, said: str) -> None:
    """With its path, what is wrong and what to do; nothing is concluded from the others."""
    write_class(tmp_path, {"ada": "right"})
    (tmp_path / "bob").mkdir()
    (tmp_path / "bob" / "result.json").write_bytes(content)
    with pytest.raises(UsageError, match=said) as fault:
        results_in(tmp_path)
    assert str(fault.value).startswith(f"{tmp_path}/bob/result.json: ")
    assert str(fault.value).endswith("grade this submission again")


def test_an_infinite_score_is_refused(tmp_path: Path) -> None:
    """JSON has no word for it, and yet Python reads one."""
    text = json.dumps(real.real("right")).replace('"score": 50', '"score": 1e999', 1)
    (tmp_path / "result.json").write_text(text)
    with pytest.raises(UsageError, match="1e999 is no number"):
        results_in(tmp_path)


def test_a_folder_without_results_is_wrong_usage(tmp_path: Path) -> None:
    """Most likely it is the folder of the submissions."""
    with pytest.raises(UsageError, match=r"no result\.json below it"):
        results_in(tmp_path)


def test_a_whole_class(tmp_path: Path) -> None:
    """The folders that the other tests use."""
    assert [one.student for one in results_in(write_class(tmp_path, CLASS))] == sorted(CLASS)


@pytest.mark.parametrize(
    ("layout", "ids"),
    [
        ("Moodle", Ids(participant="77", full_name="Ada L")),
        ("Canvas", Ids(canvas="77", full_name="Ada L")),
        ("Gradescope", Ids(("77", "a@b.c"), full_name="Ada L")),
        ("GitHub Classroom", Ids(("Ada L",), full_name="Ada L")),
        ("plain", Ids(("Ada L",), full_name="Ada L")),
    ],
)
def test_a_batch_says_whose_a_folder_is(tmp_path: Path, layout: str, ids: Ids) -> None:
    """Names of its folders are made safe, so that they no longer tell it."""
    write_batch(tmp_path, layout, {"ada-l-77": ("Ada L", "77", "a@b.c")})
    (one,) = results_in(tmp_path)
    assert one.ids == ids
    (tmp_path / "batch.sqlite").unlink()
    (one,) = results_in(tmp_path)
    assert one.ids.accounts == ("ada-l-77",), "a file of a student's says nothing"


def test_what_canvas_calls_somebody_without_a_name_is_no_number() -> None:
    """It may consist of digits, and be another student's number."""
    assert not ids_by_batch("anon_9001", "9001", "", "Canvas").canvas
    assert ids_by_batch("lovelaceada", "9001", "", "Canvas").canvas == "9001"
