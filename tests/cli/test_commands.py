"""The commands that do not grade, and the help of all."""

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import click
import pytest
from click.testing import CliRunner, Result

from grader import __version__, doctor
from grader.cli import cli
from grader.doctor import Finding
from grader.errors import OracleFault, UsageError
from grader.model.scene import Camera, Scene
from grader.oracle.album import SceneStatus


def every_command(group: click.Group, words: tuple[str, ...] = ()) -> Iterator[list[str]]:
    """The words that lead to each command, the group's own first."""
    yield [*words]
    for name, command in group.commands.items():
        if isinstance(command, click.Group):
            yield from every_command(command, (*words, name))
        else:
            yield [*words, name]


HELPS = list(every_command(cli))


def call(*words: str) -> Result:
    """Run the command line in this process."""
    return CliRunner().invoke(cli, words)


@pytest.mark.parametrize("words", HELPS, ids=" ".join)
def test_help_fits_one_screen(words: list[str]) -> None:
    """24 lines of 80 columns, the prompt included, with one sentence for each option."""
    result = CliRunner().invoke(cli, [*words, "--help"], terminal_width=80)
    lines = result.stdout.splitlines()
    assert result.exit_code == 0
    assert len(lines) <= 23
    assert max(map(len, lines)) <= 80


def test_every_command_is_there() -> None:
    """Those of the contract, and each with a help that was looked at."""
    told = call("--help").stdout
    for name in (
        "check",
        "grade",
        "batch",
        "export",
        "report",
        "verify",
        "view",
        "scenes",
        "package",
        "bench",
        "doctor",
        "schema",
        "similar",
        "certify",
    ):
        assert [name] in HELPS
        assert f"\n  {name} " in told


def test_the_list_of_commands_cuts_no_sentence() -> None:
    """Each is told on one line."""
    told = CliRunner().invoke(cli, ["--help"], terminal_width=80).stdout
    assert "..." not in told.partition("Commands:")[2]


def test_a_call_of_batch_is_told_what_it_lacks() -> None:
    """One mistake a sentence."""
    none = call("batch", "-o", "out")
    assert "name the folder or zip of a class" in none.output
    assert "--apply" not in none.output
    apply = call("batch", "tests", "-o", "out", "--apply")
    assert "give --regrade as well" in apply.output
    assert "zip" not in apply.output
    assert none.exit_code == apply.exit_code == 2


def test_version_is_the_package_s() -> None:
    """For a bug report."""
    assert call("--version").stdout == f"bvhgrade, version {__version__}\n"


def test_schema_is_printed_whole() -> None:
    """It can be piped into a validator."""
    result = call("schema")
    assert result.exit_code == 0
    assert json.loads(result.stdout)["properties"]["schema"] == {
        "const": 1,
        "description": "Version of this shape.",
    }


SCENE = Scene(
    name="grid",
    title="10 x 10 grid",
    mesh="grid",
    camera=Camera((0, 0, 0), (0, 0, 1), (0, 1, 0), 45),
    light=(0, 0, -1),
    albedo=(1, 1, 1),
    width=256,
    height=128,
)
STATUS = SceneStatus(
    scene=SCENE, faces=21_120, reference_mib=1.25, problem="", made_with=(("mitsuba", "3"),)
)


@pytest.fixture
def scenes(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Stand in for the scenes, which take a while to load."""
    module = ModuleType("grader.oracle.album")
    monkeypatch.setitem(sys.modules, "grader.oracle.album", module)
    return module


def test_scenes_are_listed_with_what_is_wrong(
    scenes: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A reference that cannot be used is our fault."""
    stale = replace(STATUS, problem="grid.exr: stale; run bvhgrade scenes render grid")
    monkeypatch.setattr(scenes, "list_scenes", lambda _: (STATUS,), raising=False)
    good = call("scenes", "list")
    monkeypatch.setattr(scenes, "list_scenes", lambda _: (stale,), raising=False)
    bad = call("scenes", "list")
    assert (good.exit_code, bad.exit_code) == (0, 3)
    assert "21,120 faces" in good.stdout
    assert "256 x 128" in good.stdout
    assert "stale" not in good.stdout
    assert "-> grid.exr: stale" in bad.stdout


def test_scenes_are_rendered_by_name(
    scenes: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The names reach the renderer, which may tell what it does."""
    asked: list[tuple[str, ...]] = []

    def render(
        names: tuple[str, ...], progress: Callable[[str], None], _: Path | None
    ) -> tuple[SceneStatus, ...]:
        progress("rendering grid")
        asked.append(names)
        return (STATUS,)

    monkeypatch.setattr(scenes, "render_scenes", render, raising=False)
    assert call("scenes", "render", "grid").exit_code == 0
    assert call("scenes", "render").exit_code == 0
    assert asked == [("grid",), ()]


@pytest.mark.parametrize(
    ("fault", "status"), [(UsageError("no scene is called x"), 2), (OracleFault("stale"), 3)]
)
def test_a_scene_that_cannot_be_rendered_is_told(
    scenes: ModuleType, monkeypatch: pytest.MonkeyPatch, fault: Exception, status: int
) -> None:
    """Wrong names are the caller's, everything else is ours."""

    def render(*_: object) -> None:
        raise fault

    monkeypatch.setattr(scenes, "render_scenes", render, raising=False)
    result = call("scenes", "render", "x")
    assert result.exit_code == status
    assert str(fault) in result.stderr


@pytest.mark.parametrize(("needed", "status"), [(True, 3), (False, 0)])
def test_doctor_ends_by_what_is_needed(
    monkeypatch: pytest.MonkeyPatch, needed: bool, status: int
) -> None:
    """What only rendering needs does not make grading fail."""
    found = (
        Finding("compiler", ok=True, state="g++ 12.2.0"),
        Finding(
            "cmake", ok=False, state="not found", remedy="apt install cmake", needed=needed
        ),
    )
    monkeypatch.setattr(doctor, "examine", lambda: found)
    result = call("doctor")
    assert result.exit_code == status
    assert "-> apt install cmake" in result.stdout
    assert ("does not work here yet" in result.stdout) == needed
