"""`bvhgrade scenes` with a course's own folder: what is typed, and what is told."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from grader.cli import cli
from grader.oracle import imported
from grader.oracle.variant import Variant
from tests.oracle.own import own_folder

PYRAMID = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 2 1 3\nf 1 2 3 4\nf 1 2 5\nf 2 3 5\nf 3 3 4\n"


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Render small pictures with what always works, from a folder of one's own."""
    scalar = Variant("scalar_rgb", None, "always works")
    monkeypatch.setattr("grader.oracle.variant.working_variant", lambda: scalar)
    monkeypatch.setattr(imported, "SIZE", 32)
    monkeypatch.chdir(tmp_path)


def call(*words: str) -> Result:
    """Run the command line in this process."""
    return CliRunner().invoke(cli, ["scenes", *words])


def test_a_model_is_imported_and_listed(tmp_path: Path) -> None:
    """Into the usual folder, with what was left out; a second time is refused."""
    (tmp_path / "hut.obj").write_text(PYRAMID)
    first = call("import", "hut.obj")
    assert first.exit_code == 0
    assert "1 face without any area was left out" in first.stdout
    listed = call("list", "--scenes", "own-scenes")
    assert listed.exit_code == 0
    for told in ("hut", "4 faces", "32 x 32", "x 1", "visible", "MiB by Mitsuba 3."):
        assert told in listed.stdout
    again = call("import", "hut.obj")
    assert again.exit_code == 2
    assert "there is a scene hut already; choose another with --name" in again.stderr
    assert call("import", "hut.obj", "--name", "house", "--into", "own-scenes").exit_code == 0


@pytest.mark.parametrize(
    ("vertex", "told"),
    [("0 0 nan", "coordinate 3 is 'nan'"), ("0 0", "coordinate 3 is ''")],
)
def test_a_model_that_will_not_do_is_the_callers_mistake(
    tmp_path: Path, vertex: str, told: str
) -> None:
    """One sentence, no traceback."""
    (tmp_path / "bad.obj").write_text(f"v {vertex}\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    result = call("import", "bad.obj")
    assert result.exit_code == 2
    assert result.stderr.strip() == (
        f"bvhgrade: bad.obj:1: {told}, but three finite numbers are expected after 'v'"
    )
    assert not (tmp_path / "own-scenes").exists()


def test_own_references_are_listed_and_rendered(tmp_path: Path) -> None:
    """What is missing is told with the command that makes it; then all is there."""
    folder = own_folder(tmp_path)
    before = call("list", "--scenes", str(folder))
    assert before.exit_code == 3
    assert f"bvhgrade scenes render our-few --scenes {folder}" in before.stdout
    assert "hidden" in before.stdout
    assert "x 2.5" in before.stdout
    assert call("render", "our-few", "--scenes", str(folder)).exit_code == 0
    assert call("list", "--scenes", str(folder)).exit_code == 3
    assert call("render", "--scenes", str(folder)).exit_code == 0
    assert call("list", "--scenes", str(folder)).exit_code == 0


def test_a_wrong_line_is_told(tmp_path: Path) -> None:
    """With file, table and key."""
    folder = own_folder(tmp_path)
    path = folder / "scenes.toml"
    path.write_text(path.read_text().replace("weight = 2.5", "weight = -2.5"))
    result = call("list", "--scenes", str(folder))
    assert result.exit_code == 2
    assert f"{path}: [[scene]] number 1 (our-few): weight is -2.5, but" in result.stderr
