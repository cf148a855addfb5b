"""Every line of a `scenes.toml` is understood, or refused with where, what and what instead."""

from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.oracle.described import Recipe, described
from grader.resources import scenes_folder
from tests.oracle.own import TOML, own_folder


def test_what_is_described_is_read(tmp_path: Path) -> None:
    """Weight and visibility have the usual values where they are left out."""
    here = described(own_folder(tmp_path))
    few, made = here.scenes
    assert (few.weight, few.visibility, few.width, few.height) == (2.5, "hidden", 16, 20)
    assert (made.weight, made.visibility) == (1.0, "visible")
    assert few.camera.origin == (0.0, 0.0, 5.0)
    assert [mesh.recipe for mesh in here.meshes] == [None, Recipe("soup", 60, 5)]


ORIGIN = "origin = [0.0, 0.0, 5.0]"
SHA = 'sha256 = "'


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("width = 16", "widht = 16", r"number 1 \(our-few\): unknown key `widht`.*\"width\""),
        ("width = 16\n", "", r"number 1 \(our-few\): width is missing"),
        ("width = 16", 'width = "16"', 'width is "16", but .* whole number from 16 to 1024'),
        ("width = 16", "width = 15", "width is 15, but"),
        ("height = 20", "height = 1025", "height is 1025, but"),
        ("[[scene]]", "[[scenes]]", 'unknown key `scenes`.* did you mean "scene"'),
        ('"our-made"', '"our-few"', r"number 2 \(our-few\): name is \"our-few\" again"),
        ('"our-made"', '"dragon"', 'name is "dragon" again.* scene of the grader'),
        ('"our-made"', '"../x"', r'name is "\.\./x", but'),
        ('"our-made"', '""', "name is empty"),
        ('name = "made"', 'name = "few"', r"\[\[mesh\]\] number 2 \(few\): name is .* again"),
        ('mesh = "few"', 'mesh = "bunny"', 'mesh is "bunny", but .* few, made'),
        ('name = "soup"', 'name = "soap"', r'\[generator\]: name is "soap", but'),
        ("faces = 60", "faces = 0", "faces is 0, but .* from 1 to 4000000"),
        ("faces = 60", "faces = 4000001", "faces is 4000001, but"),
        ("seed = 5", "seed = -1", "seed is -1, but"),
        ("seed = 5", "speed = 5", "unknown key `speed`"),
        ('source = "few.obj"\n', "", "source is missing, but .* one of the two"),
        ("generator =", 'source = "x"\ngenerator =', "source is there beside generator"),
        (SHA, 'sha256 = "G', 'sha256 is "G.*64 digits'),
        (ORIGIN, "origin = [0.0, nan, 5.0]", r"\[camera\]: origin is \[0.0, nan, 5.0\], but"),
        (ORIGIN, "origin = [0.0, 5.0]", r"origin is \[0.0, 5.0\], but expected is 3 numbers"),
        (ORIGIN, "origin = [0.0, true, 5.0]", "origin is .*True"),
        (ORIGIN, "origin = [0.0, 0.0, inf]", "origin is .*inf"),
        (ORIGIN, "origin = 5", "origin is 5, but expected is 3 numbers"),
        (ORIGIN, "origin = [0.0, 0.0, 0.0]", "target is the same as origin"),
        (ORIGIN, "origin = [0.0, 5.0, 0.0]", "up is along the line of sight"),
        ("up = [0, 1, 0]", "up = [0, 0, 0]", "up is of no length"),
        ("fov = 30", "fov = nan", "fov is nan, but expected is a number from 1 to 170"),
        ("light = [0.0, -1.0, -1.0]", "light = [0, 0, 0.0]", "light is of no length"),
        ("albedo = [0.5", "albedo = [1.5", "albedo is .* 3 numbers from 0 to 1"),
        ("weight = 2.5", "weight = -1", "weight is -1, but expected is a number from 0.01"),
        ("weight = 2.5", "weight = 0", "weight is 0, but"),
        ('"hidden"', '"secret"', '"visible" or "hidden" or'),
        ("width = 16", "width = = 16", "not valid TOML"),
        ("camera = {", 'camera = 1 #"', "camera is 1, but expected is a table"),
    ],
)
def test_what_is_not_understood_is_refused(
    tmp_path: Path, old: str, new: str, expected: str
) -> None:
    """The sentence names the file, the table and the key."""
    assert old in TOML
    folder = own_folder(tmp_path, TOML.replace(old, new, 1))
    with pytest.raises(UsageError, match=expected) as caught:
        described(folder)
    assert str(caught.value).startswith(str(folder / "scenes.toml"))


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (None, "No such file"),
        (b"\xff", "not a text in UTF-8"),
        (b" " * (2**20 + 1), "more than 1 MiB"),
        (b"a = " + b"[" * 5000, "UTF-8|not valid TOML"),
        (b"", "mesh is missing"),
    ],
)
def test_what_is_no_toml_at_all_is_refused(
    tmp_path: Path, content: bytes | None, expected: str
) -> None:
    """A folder that is none, and files of other kinds."""
    if content is not None:
        (tmp_path / "scenes.toml").write_bytes(content)
    with pytest.raises(UsageError, match=expected) as caught:
        described(tmp_path)
    assert str(caught.value).startswith(str(tmp_path))


def test_the_shipped_folder_may_be_named() -> None:
    """Its scenes are then not taken for others of the same names."""
    assert described(scenes_folder()).scenes == described().scenes
