"""Each archive has what its host looks for, where it looks, and the same bytes every time."""

import json
import subprocess
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from grader.cli import cli
from grader.oracle.scenes import scenes
from grader.package import gradescope, handout, prairielearn


def packed(folder: Path, *arguments: str) -> Result:
    """Call `bvhgrade package`."""
    return CliRunner().invoke(cli, ["package", *arguments, "-o", str(folder / "package.zip")])


def archive(folder: Path, *arguments: str) -> zipfile.ZipFile:
    """Make a package and open it."""
    made = packed(folder, *arguments)
    assert made.exit_code == 0, made.output
    return zipfile.ZipFile(folder / "package.zip")


def mode(archive: zipfile.ZipFile, name: str) -> int:
    """Read a file's rights."""
    return archive.getinfo(name).external_attr >> 16 & 0o777


@pytest.mark.parametrize(
    "arguments",
    [
        ("gradescope",),
        ("prairielearn", "--seed", "7"),
        ("github", "--repository", "course/grader"),
        ("handout",),
    ],
    ids=lambda arguments: arguments[0],
)
def test_the_same_call_gives_the_same_bytes(
    tmp_path: Path, arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A course can see that nothing has changed. One scene of a handout stands for all."""
    monkeypatch.setattr(handout, "scenes", lambda folder: scenes(folder)[:1])
    assert packed(tmp_path, *arguments).exit_code == 0
    first = (tmp_path / "package.zip").read_bytes()
    assert packed(tmp_path, *arguments).exit_code == 0
    assert (tmp_path / "package.zip").read_bytes() == first


def test_gradescope_finds_its_two_scripts_at_the_root(tmp_path: Path) -> None:
    """Not in a folder, with Unix line ends, and with a `#!`."""
    with archive(tmp_path, "gradescope") as package:
        for name in ("setup.sh", "run_autograder"):
            assert package.read(name).startswith(b"#!/usr/bin/env bash\n")
            assert b"\r" not in package.read(name)
            assert mode(package, name) == 0o755


def test_the_grader_is_done_before_its_host_loses_patience() -> None:
    """Gradescope would write a 0, and PrairieLearn would read nothing."""
    assert int(gradescope.SECONDS) <= 0.8 * 600
    assert prairielearn.SECONDS <= 0.8 * prairielearn.TIMEOUT


def test_prairielearn_gets_an_image_and_a_question(tmp_path: Path) -> None:
    """The question's container starts the script that the image has, without a network."""
    with archive(tmp_path, "prairielearn") as package:
        information = json.loads(package.read("questions/bvh/info.json"))
        options = information["externalGradingOptions"]
        assert information["gradingMethod"] == "External"
        assert options["enableNetworking"] is False
        dockerfile = package.read("image/Dockerfile").decode()
        assert f"COPY entry.sh {options['entrypoint']}\n" in dockerfile
        assert mode(package, "image/entry.sh") == 0o755
        assert b"<pl-external-grader-results>" in package.read("questions/bvh/question.html")


def test_github_gets_the_grader_apart_from_what_students_copy(tmp_path: Path) -> None:
    """The students' repository names the course's and holds nothing of it."""
    with archive(tmp_path, "github", "--repository", "course/grader") as package:
        students = [
            one for one in package.namelist() if one.startswith("assignment-repository/")
        ]
        assert "assignment-repository/src/exercise03.cpp" in students
        assert not any("wheel" in name or "bvhgrade" in name for name in students)
        workflow = package.read("assignment-repository/.github/workflows/autograding.yml")
        assert b"uses: course/grader@main\n" in workflow
        assert b"OWNER" not in workflow
        assert "grader-repository/action.yml" in package.namelist()
        assert mode(package, "grader-repository/bvhgrade/install.sh") == 0o755


@pytest.mark.parametrize("repository", [None, "grader", "a/b/c", "a/b@main", "a/$(id)", "-a/b"])
def test_github_needs_the_name_of_a_repository(tmp_path: Path, repository: str | None) -> None:
    """It goes into a workflow, so nothing else gets there."""
    named = ["--repository", repository] if repository else []
    refused = packed(tmp_path, "github", *named)
    assert refused.exit_code == 2
    assert "OWNER/NAME" in refused.output
    assert not (tmp_path / "package.zip").exists()


def test_options_of_another_host_are_refused(tmp_path: Path) -> None:
    """An option that does nothing would be a promise that is not kept."""
    refused = packed(tmp_path, "gradescope", "--repository", "course/grader")
    assert refused.exit_code == 2
    assert "only GitHub" in refused.output
    refused = packed(tmp_path, "handout", "--seed", "3")
    assert refused.exit_code == 2
    assert "a handout holds no grader" in refused.output


def test_every_script_is_sound_bash() -> None:
    """As far as bash itself can tell without running it."""
    folder = Path(gradescope.__file__).with_name("files")
    scripts = sorted(folder.glob("*.sh"))
    assert len(scripts) == 5
    for script in scripts:
        subprocess.run(["bash", "-n", str(script)], check=True)
