"""The framework is built once, by whoever comes first, and never half."""

import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from grader import resources
from grader.build import workspace as module
from grader.build.compiler import Compiler, find_compiler
from grader.build.workspace import GRADED, Workspace, workspace
from grader.errors import BuildFault, MissingTool
from grader.sandbox.launch import Order, Outcome, launch


@pytest.fixture
def tiny_stub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give a stub that compiles in a moment, and an empty cache beside it."""
    real, stub = resources.stub_folder(), tmp_path / "stub"
    for name in ("include", "src", "abi", "preview"):
        (stub / name).mkdir(parents=True)
    for path in (real / "CMakeLists.txt", *(real / "src").glob("*.cpp"), *real.glob("*/*.cpp")):
        target = stub / path.relative_to(real)
        target.write_text(
            path.read_text() if path.suffix == ".txt" else "static_assert(true);\n"
        )
    (stub / "include" / "common.h").write_text("#include <cstdint>\n")
    monkeypatch.setattr(resources, "stub_folder", lambda: stub)
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    return stub


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """List the processes that are started from now on."""
    seen: list[list[str]] = []

    def counted(order: Order) -> Outcome:
        seen.append(list(order.argv))
        return launch(order)

    monkeypatch.setattr(module, "launch", counted)
    return seen


def made() -> Workspace:
    """Ask for the framework with the installed compiler."""
    return workspace(find_compiler(), GRADED)


def stamps(cache: Path) -> list[Path]:
    """List the frameworks that are complete."""
    return sorted(cache.glob("framework/*/complete"))


@pytest.mark.usefixtures("tiny_stub")
def test_a_second_call_starts_nothing(tmp_path: Path, steps: list[list[str]]) -> None:
    """The cache answers, and no file in it is touched."""
    first = made()
    (stamp,) = stamps(tmp_path / "cache")
    written = stamp.stat().st_mtime_ns
    assert len(steps) == 4
    assert made() == first
    assert len(steps) == 4
    assert stamp.stat().st_mtime_ns == written


@pytest.mark.usefixtures("tiny_stub")
def test_callers_at_the_same_time_build_once(steps: list[list[str]]) -> None:
    """The first one builds, the others wait for it."""
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: made(), range(4)))
    assert results == [results[0]] * 4
    assert len(steps) == 4


@pytest.mark.usefixtures("tiny_stub")
def test_a_build_that_was_interrupted_is_built_again(tmp_path: Path) -> None:
    """Without its stamp a folder is thrown away."""
    first = made()
    (stamp,) = stamps(tmp_path / "cache")
    stamp.unlink()
    shutil.rmtree(stamp.parent / "build")
    (stamp.parent / "left over").touch()
    assert made() == first
    assert stamps(tmp_path / "cache") == [stamp]
    assert not (stamp.parent / "left over").exists()


@pytest.mark.usefixtures("tiny_stub")
def test_a_cache_that_was_moved_is_built_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is stored names the folder that it was in."""
    made()
    (tmp_path / "cache").rename(tmp_path / "moved")
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "moved"))
    assert made().folder.is_relative_to(tmp_path / "moved")
    (stamp,) = stamps(tmp_path / "moved")
    assert stamp.read_text() == str(stamp.parent)


def test_every_change_of_the_stub_makes_a_new_framework(
    tiny_stub: Path, tmp_path: Path
) -> None:
    """A header is enough; the old framework stays for whoever still uses it."""
    first = made()
    (tiny_stub / "include" / "ray.h").write_text("#pragma once\n")
    assert made() != first
    assert len(stamps(tmp_path / "cache")) == 2


def test_a_stub_that_does_not_compile_is_our_fault(tiny_stub: Path, tmp_path: Path) -> None:
    """The log says why, no stamp is left, and the mended stub builds."""
    broken = tiny_stub / "src" / "mesh.cpp"
    broken.write_text("this is no C++\n")
    with pytest.raises(BuildFault, match=r"(?s)did not build with .*\+\+.*mesh.cpp:1:1: error"):
        made()
    assert stamps(tmp_path / "cache") == []
    broken.write_text("int nothing;\n")
    assert made().compile_command


def test_a_stub_that_cannot_be_configured_is_our_fault(tiny_stub: Path) -> None:
    """CMake's own words are in the message."""
    (tiny_stub / "CMakeLists.txt").write_text("message(FATAL_ERROR nonsense)\n")
    with pytest.raises(BuildFault, match="nonsense"):
        made()


@pytest.mark.usefixtures("tiny_stub")
@pytest.mark.parametrize("missing", ["cmake", "make"])
def test_a_missing_program_is_named(
    missing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The sentence says which package to install."""
    compiler = find_compiler()
    folder = tmp_path / "bin"
    folder.mkdir()
    other = {"cmake": "make", "make": "cmake"}[missing]
    (folder / other).symlink_to(str(shutil.which(other)))
    monkeypatch.setenv("PATH", str(folder))
    with pytest.raises(MissingTool, match=f"{missing} is not installed; install"):
        workspace(compiler, GRADED)


@pytest.mark.usefixtures("tiny_stub")
def test_a_compiler_that_does_not_work_is_our_fault(tmp_path: Path) -> None:
    """A program that only claims to be a compiler does not configure."""
    fake = tmp_path / "g++"
    fake.write_text("#!/bin/sh\nexit 1\n")
    fake.chmod(0o755)
    with pytest.raises(BuildFault, match=r"did not build with g\+\+ 99"):
        workspace(Compiler(str(fake), "g++", "99.0.0"), GRADED)


def test_a_file_finds_the_same_folders_in_every_build() -> None:
    """Else it could ask for one, and show another program to who reads its calls."""
    framework = made()
    ran, read = (
        [word for word in command if word.startswith(("-I", "/")) and not word.endswith(".h")]
        for command in (framework.compile_command[1:], framework.listing[1:])
    )
    assert str(framework.folder / "intrinsics") in ran
    assert ran == read
