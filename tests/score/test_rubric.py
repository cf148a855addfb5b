"""Tests of grader/score/rubric.py and grader/table.py."""

from dataclasses import MISSING, fields
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.model.grade import CompileLimits, Limits
from grader.score.points import SURVIVAL
from grader.score.rubric import SHIPPED, load_rubric
from grader.verify import every_check

TEXT = SHIPPED.read_text()


def changed(folder: Path, old: str, new: str) -> Path:
    """Write the shipped rubric with one change."""
    assert old in TEXT
    path = folder / "mine.toml"
    path.write_text(TEXT.replace(old, new, 1))
    return path


@pytest.mark.parametrize("part", ["a", "b"])
def test_each_part_is_worth_25_points(part: str) -> None:
    """The sheet gives 25 points to each part."""
    assert sum(one.points for one in load_rubric().criteria if one.part == part) == 25


def test_every_check_has_a_criterion_and_the_other_way_round() -> None:
    """Only here do the checks and their worth meet."""
    criteria = {one.check for one in load_rubric().criteria}
    assert {one.id for one in every_check()} == criteria
    assert set(SURVIVAL.values()) <= criteria


@pytest.mark.parametrize("record", [CompileLimits, Limits])
def test_limits_are_written_in_the_rubric_alone(record: type[CompileLimits | Limits]) -> None:
    """A default would be a second place that may say something else."""
    assert [field.name for field in fields(record) if field.default is not MISSING] == []


def test_the_gates_are_those_of_the_design() -> None:
    """Compiling stands before both parts, and each part has one gate of its own."""
    gates = {one.check: one.part for one in load_rubric().criteria if one.gate}
    assert gates == {
        "build.compiles": "both",
        "bvh.is-readable": "a",
        "work.uses-the-tree": "b",
    }


def test_a_teacher_may_weigh_hide_and_drop(tmp_path: Path) -> None:
    """Another weight, a hidden criterion and a missing one are accepted as they are."""
    path = changed(
        tmp_path, 'part = "a"\npoints = 1', 'part = "a"\nvisibility = "hidden"\npoints = 7.5'
    )
    text = path.read_text()
    path.write_text(text[: text.rindex("[[criterion]]")])
    rubric = load_rubric(path)
    assert [(one.points, one.visibility) for one in rubric.criteria][2] == (7.5, "hidden")
    assert len(rubric.criteria) == len(load_rubric().criteria) - 1
    assert rubric.sha256 != load_rubric().sha256


def test_the_other_reading_of_leaves_is_accepted(tmp_path: Path) -> None:
    """`full-levels` is the second reading."""
    path = changed(tmp_path, 'leaf_rule = "sheet"', 'leaf_rule = "full-levels"')
    assert load_rubric(path).leaf_rule == "full-levels"


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "bvh.boxes-are-tight",
            "bvh.boxes-are-tigth",
            'is "bvh.boxes-are-tigth", but expected is a known name; '
            'did you mean "bvh.boxes-are-tight"?',
        ),
        ("gate = true", "gates = true", 'unknown key `gates`.* did you mean "gate"'),
        ("gate = true", "gate = 1", "gate is 1, but expected is true or false"),
        ("points = 3", "points = -3", "points is -3, but expected is a number from 0 to 1000"),
        ("points = 3", "points = nan", "points is nan, but"),
        ("points = 3", "points = inf", "points is inf, but"),
        ("points = 3", "points = true", "points is True, but"),
        ("points = 3", f"points = 1{400 * '0'}", "points is 1000+…, but"),
        ("points = 3", f"points = 1{9000 * '0'}", "not valid TOML"),
        ("points = 3", 'points = "three"', 'points is "three", but'),
        ("points = 3", "", r"\(bvh.face-indices-are-a-permutation\): points is missing, but"),
        ("points = 0", "points = 2", "points is 2, but expected is 0"),
        ('part = "a"\npoints', 'part = "b"\npoints', 'part is "b", but expected is "a"'),
        ('part = "a"\npoints', "part = 1\npoints", "part is 1, but expected is a text"),
        ('part = "both"', 'part = "a"', 'part is "a", but expected is "both"'),
        ('[[part]]\nid = "b"\ntitle = "Accelerated intersection"', "", 'none with id = "b"'),
        ('id = "b"', 'id = "a"', 'id is "a" again, but expected is each part once'),
        ('id = "b"', 'id = "c"', 'id is "c", but expected is "a" or "b"'),
        ("bvh.boxes-are-tight", "bvh.depth-is-limited", "again, but expected is each check"),
        ('title = "BVH construction"', 'title = " "', "title is empty, but"),
        ("small_seconds = ", "small_seconds = 0 # ", "small_seconds is 0, but"),
        ("memory_mib = ", "memory_mib = 2048.5 # ", "memory_mib is 2048.5, but .* whole"),
        ("memory_mib = ", "# ", "memory_mib is missing"),
        ("[limits]", "[limit]", 'unknown key `limit`.* did you mean "limits"'),
        ('leaf_rule = "sheet"', 'leaf_rule = "any"', '"sheet" or "full-levels"'),
        ("[[part]]", "[part]", "not valid TOML"),
        ("points = 3", "points = = 3", r"not valid TOML: .*line 66"),
        ("points = 3", 'points = 3\nvisibility = "secret"', '"visible" or "hidden" or'),
    ],
)
def test_what_is_not_understood_is_refused(
    tmp_path: Path, old: str, new: str, expected: str
) -> None:
    """The sentence says where, what is there and what was expected."""
    path = changed(tmp_path, old, new)
    with pytest.raises(UsageError, match=expected) as caught:
        load_rubric(path)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize("content", ["part = 3", "part = [3]", "reading = 1", ""])
def test_tables_of_another_shape_are_refused(tmp_path: Path, content: str) -> None:
    """A number in the place of a table is named and not tripped over."""
    path = tmp_path / "mine.toml"
    path.write_text(content)
    with pytest.raises(UsageError, match="but expected is"):
        load_rubric(path)


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"\xff\xfe", "not a text in UTF-8"),
        (b"#" * 2**21, "more than 1 MiB"),
        (b"a = " + b"[" * 5000, "not "),
    ],
)
def test_files_that_are_no_rubric_are_refused(
    tmp_path: Path, content: bytes, expected: str
) -> None:
    """Bytes that are no text, too many bytes, and brackets without end."""
    path = tmp_path / "mine.toml"
    path.write_bytes(content)
    with pytest.raises(UsageError, match=expected):
        load_rubric(path)


def test_a_missing_rubric_is_the_callers_mistake(tmp_path: Path) -> None:
    """The sentence names the path."""
    with pytest.raises(UsageError, match=r"none.toml: No such file or directory, but a rubric"):
        load_rubric(tmp_path / "none.toml")


def test_a_rubric_names_the_own_scenes(tmp_path: Path) -> None:
    """The folder is seen from the rubric; without the table there is none."""
    (tmp_path / "ours").mkdir()
    path = changed(tmp_path, "[reading]", '[scenes]\nfolder = "ours"\n\n[reading]')
    assert load_rubric(path).scenes == tmp_path / "ours"
    assert load_rubric().scenes is None


@pytest.mark.parametrize(
    ("table", "expected"),
    [
        ('folder = "nowhere"', r'\[scenes\]: folder is .*nowhere", but .* a folder that'),
        ("folder = 3", r"\[scenes\]: folder is 3, but"),
        ("", r"\[scenes\]: folder is missing"),
        ('folders = "ours"', "unknown key `folders`.* did you mean .folder"),
    ],
)
def test_a_wrong_folder_of_scenes_is_refused(tmp_path: Path, table: str, expected: str) -> None:
    """Before anything is graded without them."""
    path = changed(tmp_path, "[reading]", f"[scenes]\n{table}\n\n[reading]")
    with pytest.raises(UsageError, match=expected):
        load_rubric(path)
