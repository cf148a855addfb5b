"""The documents are true: their commands run, their paths exist, their points add up."""

import json
import os
import re
import subprocess
import tomllib
from pathlib import Path

import pytest
from click.testing import CliRunner

from grader.cli import cli
from grader.score.rubric import load_rubric
from tests.own_files import ROOT

DOCUMENTS = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    *sorted((ROOT / "docs").glob("*.md")),
    ROOT / "reference" / "README.md",
    ROOT / "student_stub" / "README.md",
    ROOT / "scenes" / "README.md",
]
MADE_BY_A_COMMAND = (
    "build/",
    "cube.png",
    "bvhgrade-out",
    "own-scenes",
    ".venv",
    "result.json",
    # In the package for PrairieLearn.
    "questions/",
    "grader-repository/",
    "assignment-repository/",
    "similar.html",
    # Of a class.
    "students/",
)


def commands(document: Path) -> list[str]:
    """The lines of shell in a document: fenced as `sh`, indented, or a command in backticks."""
    text = document.read_text()
    fenced = "\n".join(re.findall(r"```sh\n(.*?)```", text, re.DOTALL))
    outside = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    indented = "\n".join(re.findall(r"^    (\S.*)$", outside, re.MULTILINE))
    inline = "\n".join(re.findall(r"`((?:bvhgrade|scripts/\w+) [^`\n]*)`", outside))
    lines = "\n".join((fenced, indented, inline)).splitlines()
    return [line.split("  #")[0].strip() for line in lines if line.strip()]


EVERY_COMMAND = [
    pytest.param(document, line, id=f"{document.relative_to(ROOT)}: {line}")
    for document in DOCUMENTS
    for line in commands(document)
]


def test_commands_are_found() -> None:
    """The search sees a fence, an indented block and a command within a sentence."""
    assert "scripts/grade reference/src/exercise03.cpp" in commands(DOCUMENTS[0])
    assert "cmake --preset Release" in commands(ROOT / "student_stub" / "README.md")
    assert "bvhgrade scenes list" in commands(ROOT / "scenes" / "README.md")


@pytest.mark.parametrize(("document", "line"), EVERY_COMMAND)
def test_every_command_exists(document: Path, line: str) -> None:
    """A command is known, takes the options shown, and names files that are there."""
    program, *arguments = line.split()
    if program == "bvhgrade":
        assert_understood(arguments)
    elif program == "scripts/certify":
        assert_understood(["certify", *arguments])
    elif program in {
        "scripts/grade",
        "scripts/test",
        "scripts/attacks",
        "scripts/check",
        ".ci/run",
    }:
        assert os.access(ROOT / program, os.X_OK)
        assert_present(ROOT, arguments)
    elif program == "cmake":
        presets = json.loads((document.parent / "CMakePresets.json").read_text())
        assert arguments[-1] in {one["name"] for one in presets["configurePresets"]}
    elif program == "build/Release/preview":
        assert_present(document.parent, arguments)
    else:
        assert_foreign(program, arguments)


def assert_foreign(program: str, arguments: list[str]) -> None:
    """Programs of others get what they can find here."""
    if program == "sudo":
        assert arguments[:2] == ["apt-get", "install"]
        assert set(arguments[2:]) <= installed_packages()
    elif program == "pip":
        project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
        named = re.findall(r"(?:bvhgrade|CHECKOUT)\[(\w+)\]", " ".join(arguments))
        assert set(named) <= set(project["optional-dependencies"])
        assert arguments[0] == ("install" if named else "download")
    elif program == "python":
        # A module of the tests, run as a script.
        assert arguments[0] == "-m"
        file = ROOT / f"{arguments[1].replace('.', '/')}.py"
        options = [word for word in arguments if word.startswith("--")]
        assert all(f'"{option}"' in file.read_text() for option in options)
    elif program == "dask":
        # Its own options are those of another project.
        assert arguments[0] in {"scheduler", "worker"}
    elif program == "export":
        assert arguments == ["PATH=$PWD/.venv/bin:$PATH"]
    elif program == "unzip":
        # Of a package that the line before made; its names are those of the kit.
        assert "bvhgrade/constraints.txt" in arguments
    else:
        pytest.fail(f"{program}: what is this?")


def assert_understood(arguments: list[str]) -> None:
    """The help of the command knows every option, and the command itself exists."""
    words = [word for word in arguments if re.fullmatch(r"[a-z]+", word)]
    path = words[:2] if words[0] == "scenes" else words[:1]
    result = CliRunner().invoke(cli, [*path, "--help"])
    assert result.exit_code == 0, result.output
    options = [word for word in arguments if word.startswith("-")]
    assert all(option in result.output for option in options), result.output
    criteria = {one.check for one in load_rubric().criteria}
    topics = {name.partition(".")[0] for name in criteria}
    named = {word for word in arguments if word.partition(".")[0] in topics and "." in word}
    assert named <= criteria


def assert_present(folder: Path, arguments: list[str]) -> None:
    """Every argument that looks like a path is one, unless a command makes it."""
    for word in arguments:
        if "/" in word and not word.startswith(MADE_BY_A_COMMAND):
            assert (folder / word).exists(), word


def installed_packages() -> set[str]:
    """What the script for a bare machine installs."""
    script = (ROOT / ".ci" / "run").read_text()
    return set(re.findall(r"missing\+=\(([\w+.-]+)\)", script))


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_path_exists(document: Path) -> None:
    """What is written in backticks with a slash or as a document is there."""
    outside = re.sub(r"```.*?```", "", document.read_text(), flags=re.DOTALL)
    named = re.findall(r"`([\w.-]+(?:/[\w.-]*)+|[A-Z]+\.md)`", outside)
    for name in named:
        if name.startswith(MADE_BY_A_COMMAND):
            continue
        folders: list[str | Path] = [
            "",
            "student_stub",
            "grader",
            "grader/sandbox",
            "tests/submissions",
            document.parent,
        ]
        assert any((ROOT / folder / name).exists() for folder in folders), name


def test_the_student_reads_the_real_points() -> None:
    """The tables in docs/student.md are the rubric."""
    rows = re.findall(
        r"^\| `([a-z-]+\.[a-z-]+)` \| ([^|]+) \|",
        (ROOT / "docs" / "student.md").read_text(),
        re.MULTILINE,
    )
    worth = [
        (one.check, ", ".join([f"{one.points:g}"] * bool(one.points) + ["gate"] * one.gate))
        for one in load_rubric().criteria
    ]
    assert rows == worth


def test_the_changelog_has_the_section_on_grades() -> None:
    """Every version says whether grades can move."""
    text = (ROOT / "CHANGELOG.md").read_text()
    versions = re.findall(r"^## ", text, re.MULTILINE)
    assert len(re.findall(r"^### Changes to grades$", text, re.MULTILINE)) == len(versions) > 0


def test_each_change_to_grades_names_a_file_that_shows_it() -> None:
    """And the file is there; `wrong/` where no folder is named."""
    text = (ROOT / "CHANGELOG.md").read_text()
    section = text.split("### Changes to grades\n")[1].split("\n### ")[0]
    entries = section.strip().removeprefix("- ").split("\n- ")
    for entry in entries:
        names = re.findall(r"`((?:[a-z0-9_-]+/)*[a-z0-9_-]+\.(?:cpp|py))`", entry)
        shown = [name for name in names if name != "exercise03.cpp"]
        assert shown, entry
        for name in shown:
            place = name if name.startswith("tests/") else f"tests/submissions/{name}"
            folder, _, file = place.rpartition("/")
            wrong = folder == "tests/submissions"
            assert (ROOT / folder / ("wrong" if wrong else "") / file).is_file(), name


def run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a script of the checkout from somewhere else."""
    return subprocess.run(
        [str(ROOT / command[0]), *command[1:]],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_first_command_grades(tmp_path: Path) -> None:
    """`scripts/grade` works from any folder: 50 of 50 for the reference."""
    reference = str(ROOT / "reference" / "src" / "exercise03.cpp")
    result = run(["scripts/grade", reference, "-o", "out"], tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "50 of 50" in result.stdout
    assert re.search(r"image\.equals-mitsuba .*\bdragon\b", result.stdout)
    told = json.loads((tmp_path / "out" / "result.json").read_text())
    assert (told["score"], told["max_score"]) == (50, 50)
    (pictures,) = (one for one in told["checks"] if one["id"] == "image.equals-mitsuba")
    assert "dragon" in pictures["message"].split(": ")[1].split(", ")
    assert pictures["examined"] > 512 * 512


def test_the_starter_has_not_been_started(tmp_path: Path) -> None:
    """0 of 50, and of each part the sentence that says so."""
    starter = str(ROOT / "student_stub" / "src" / "exercise03.cpp")
    result = run(["scripts/grade", starter, "-o", "out"], tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert json.loads((tmp_path / "out" / "result.json").read_text())["score"] == 0
    assert "Part a is not started" in result.stdout
    assert "Part b is not started" in result.stdout


def test_the_second_command_takes_pytests_arguments(tmp_path: Path) -> None:
    """`scripts/test` runs one test and prints pytest's closing line."""
    one = "tests/test_readme.py::test_the_changelog_has_the_section_on_grades"
    result = run(["scripts/test", "-n", "0", one], tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert re.search(r"\b1 passed in ", result.stdout.splitlines()[-1])


@pytest.mark.parametrize(
    "code",
    [
        "@pytest.mark.skip\ndef test_a():\n    pass\n",
        "def test_a():\n    pytest.skip('why')\n",
        "pytest.importorskip('no_such_module')\n",
    ],
)
def test_a_skipped_test_is_red(tmp_path: Path, code: str) -> None:
    """The hooks in tests/conftest.py turn a skip into a failure."""
    (tmp_path / "test_skip.py").write_text(f"import pytest\n{code}")
    (tmp_path / "conftest.py").write_bytes((ROOT / "tests" / "conftest.py").read_bytes())
    config = ["-c", "/dev/null", "--rootdir", str(tmp_path), "-p", "no:cacheprovider"]
    result = run(["scripts/test", "-n", "0", *config, str(tmp_path / "test_skip.py")], tmp_path)
    assert result.returncode in {1, 2}, result.stdout + result.stderr
    assert "proves nothing" in result.stdout + result.stderr


def test_check_refuses_what_it_does_not_know(tmp_path: Path) -> None:
    """A misspelt option does not pass for a check."""
    result = run(["scripts/check", "--fats"], tmp_path)
    assert result.returncode == 2
    assert "--fast or nothing is expected" in result.stderr
