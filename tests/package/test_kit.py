"""What a course chose goes into its package, and what could not work there is refused here."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.package.archive import Member
from grader.package.kit import Choices, kit
from grader.score.rubric import SHIPPED


@pytest.fixture
def rubric(tmp_path: Path) -> Path:
    """Give a rubric of a course that has a scene of its own beside it."""
    scenes = tmp_path / "exam" / "own"
    scenes.mkdir(parents=True)
    (scenes / "scenes.toml").write_text("# none yet\n")
    path = tmp_path / "exam" / "rubric.toml"
    path.write_text(SHIPPED.read_text() + '\n[scenes]\nfolder = "own"\n')
    return path


@pytest.fixture
def wheels(tmp_path: Path) -> Path:
    """Give a folder as `pip download` fills it, with a grader of another day among the rest."""
    folder = tmp_path / "wheels"
    folder.mkdir()
    for name in ("numpy-2.4.6-cp311-cp311-linux_x86_64.whl", "bvhgrade-0.0.1-py3-none-any.whl"):
        (folder / name).write_bytes(b"wheel")
    return folder


def named(members: tuple[Member, ...]) -> dict[str, bytes]:
    """Give bytes by name."""
    return {one.name: one.data for one in members}


def test_the_smallest_kit_asks_for_nothing_special() -> None:
    """Scripts that can be run, pins, one wheel, and no option but the host's."""
    members = kit(Choices(), "--time-limit", "480")
    files = named(members)
    assert b"chosen=(--time-limit 480)" in files["bvhgrade/settings.sh"]
    assert b"numpy==" in files["bvhgrade/constraints.txt"]
    (wheel,) = [name for name in files if name.startswith("bvhgrade/wheels/")]
    assert re.fullmatch(r"bvhgrade/wheels/bvhgrade-[0-9.]+-py3-none-any\.whl", wheel)
    scripts = {one.name: one.executable for one in members if one.name.endswith(".sh")}
    assert scripts["bvhgrade/install.sh"]
    assert scripts["bvhgrade/grade.sh"]


def test_a_courses_choices_are_passed_on_by_bash(rubric: Path, tmp_path: Path) -> None:
    """grade.sh finds the rubric where it was packed, its scenes beside it, and the seed."""
    files = named(kit(Choices(rubric, seed=7)))
    assert files["bvhgrade/rubric.toml"] == rubric.read_bytes()
    assert files["bvhgrade/own/scenes.toml"] == b"# none yet\n"
    (tmp_path / "settings.sh").write_bytes(files["bvhgrade/settings.sh"])
    script = (
        f'here="/some where"; source {tmp_path}/settings.sh; printf "%s\\n" "${{chosen[@]}}"'
    )
    told = subprocess.run(["bash", "-euc", script], capture_output=True, text=True, check=True)
    assert told.stdout.splitlines() == ["--seed", "7", "--rubric", "/some where/rubric.toml"]


def test_wheels_come_along_but_for_another_grader(wheels: Path) -> None:
    """Two graders in one folder: pip would choose by version, not by what was meant."""
    names = [one.name for one in kit(Choices(wheels=wheels))]
    assert "bvhgrade/wheels/numpy-2.4.6-cp311-cp311-linux_x86_64.whl" in names
    assert sum("/bvhgrade-" in name for name in names) == 1


def test_a_folder_without_wheels_is_refused(tmp_path: Path) -> None:
    """The host would look for a network that it was said not to have."""
    with pytest.raises(UsageError, match="no wheel of numpy"):
        kit(Choices(wheels=tmp_path))


def test_scenes_outside_of_the_rubrics_folder_are_refused(rubric: Path, tmp_path: Path) -> None:
    """They could not be found from where the rubric is packed."""
    shutil.move(tmp_path / "exam" / "own", tmp_path / "own")
    for place in ("../own", str(tmp_path / "own")):
        rubric.write_text(SHIPPED.read_text() + f'\n[scenes]\nfolder = "{place}"\n')
        with pytest.raises(UsageError, match="put that folder beside the rubric"):
            kit(Choices(rubric))


def test_scenes_that_are_called_like_a_part_of_the_kit_are_refused(rubric: Path) -> None:
    """Setup would empty a folder called venv."""
    (rubric.parent / "own").rename(rubric.parent / "venv")
    rubric.write_text(SHIPPED.read_text() + '\n[scenes]\nfolder = "venv"\n')
    with pytest.raises(UsageError, match="rename the folder"):
        kit(Choices(rubric))


def test_a_wrong_rubric_is_refused_here_and_not_at_the_host(rubric: Path) -> None:
    """With the file and the place in it."""
    rubric.write_text(SHIPPED.read_text().replace("bvh.is-readable", "bvh.is-raedable"))
    with pytest.raises(UsageError, match="raedable"):
        kit(Choices(rubric))
