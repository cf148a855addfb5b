"""Students get the exercise as it was written down, whatever happened where it lies."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from grader import resources
from grader.errors import UsageError
from grader.package import github, handout
from grader.package.archive import Member
from grader.package.exercise import PINS, exercise, pins, starter
from grader.package.kit import Choices
from grader.package.wheel import own_wheel
from grader.similar.pairs import compared
from tests.own_files import ROOT
from tests.package.pins import table

SOURCE = "src/exercise03.cpp"

Packing = Callable[[], object]

PACKINGS: dict[str, Packing] = {
    "handout": lambda: handout.members(Choices()),
    "github": lambda: github.members(Choices(), "owner/grader"),
    "wheel": own_wheel,
    "similar": lambda: compared([b"int a;", b"int b;"]),
}


@pytest.fixture
def stub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give a copy of the exercise, which the grader takes for its own."""
    folder = tmp_path / "student_stub"
    shutil.copytree(ROOT / "student_stub", folder, ignore=shutil.ignore_patterns("build"))
    monkeypatch.setattr(resources, "stub_folder", lambda: folder)
    return folder


def named(members: tuple[Member, ...]) -> set[str]:
    """Give the names of members."""
    return {one.name for one in members}


def test_the_list_is_that_of_the_files_that_git_keeps() -> None:
    """After a change of the exercise: `python -m tests.package.pins`."""
    assert PINS.read_text() == table(), "call `python -m tests.package.pins`"


def test_every_file_is_handed_out_as_it_lies_there() -> None:
    """Byte for byte, hidden files too."""
    given = {one.name: one.data for one in exercise()}
    assert given == {name: (ROOT / "student_stub" / name).read_bytes() for name in pins()}
    assert {SOURCE, ".gitignore", "CMakeLists.txt", "include/bvh.h"} <= given.keys()
    assert given[SOURCE] == starter()


@pytest.mark.parametrize("packing", PACKINGS.values(), ids=PACKINGS.keys())
def test_a_solution_where_the_starter_lies_is_refused(stub: Path, packing: Packing) -> None:
    """The grader looks there for what to grade, so that is where one tries the exercise."""
    shutil.copy(resources.reference_source(), stub / SOURCE)
    with pytest.raises(UsageError, match=r"src/exercise03\.cpp.*may hold a solution"):
        packing()


@pytest.mark.parametrize("name", ["README.md", "include/bvh.h"])
def test_any_other_change_is_refused_too(stub: Path, name: str) -> None:
    """Notes are taken in a README as well."""
    (stub / name).write_text((stub / name).read_text() + "\n// median of the longest axis\n")
    with pytest.raises(UsageError, match=name):
        handout.members(Choices())


def test_a_missing_file_is_refused(stub: Path) -> None:
    """Students could not build it."""
    (stub / "models" / "cube.obj").unlink()
    with pytest.raises(UsageError, match=r"models/cube\.obj.*is missing"):
        exercise()


def test_whatever_else_lies_there_stays_there(
    stub: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Notes, copies, what editors and compilers leave: in no package."""
    monkeypatch.setattr(handout, "scenes", lambda _: ())
    monkeypatch.setattr(github, "kit", lambda _: ())
    extras = ("notes.md", "src/exercise03.cpp~", "build/a.o", "cmake-build-debug/a", "a.ppm")
    for extra in extras:
        (stub / extra).parent.mkdir(exist_ok=True)
        (stub / extra).write_text("solved")
    assert not [
        name
        for members in (handout.members(Choices()), github.members(Choices(), "a/b"))
        for name in named(members)
        if name.endswith(extras)
    ]
