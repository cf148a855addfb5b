"""The stub builds everywhere a student may build it, and exports only what it should."""

import json
import re
from pathlib import Path

import pytest

from tests.student_stub.library import STARTER, STUB, build, load, run

PRESETS = ["Debug", "Release", "RelWithDebInfo", "Sanitize"]


@pytest.mark.parametrize(
    ("preset", "compiler"),
    [
        ("Debug", "g++"),
        ("Debug", "clang++"),
        ("Release", "g++"),
        ("RelWithDebInfo", "clang++"),
        ("Sanitize", "g++"),
        ("Sanitize", "clang++"),
    ],
)
def test_every_preset_builds_without_a_warning(
    preset: str, compiler: str, tmp_path: Path
) -> None:
    """The starter compiles and links with both compilers, and nobody complains.

    File by file in Debug; elsewhere the given code is one piece, for what a preset adds is
    seen there as well, in a third of the time. Release and RelWithDebInfo are much
    alike, so each is built by one of the compilers.
    """
    presets = json.loads((STUB / "CMakePresets.json").read_text())["configurePresets"]
    (chosen,) = (p for p in presets if p["name"] == preset)
    options = [f"-D{name}={value}" for name, value in chosen["cacheVariables"].items()]
    unity = f"-DEX03_UNITY={'OFF' if preset == 'Debug' else 'ON'}"
    said = build(tmp_path, *options, unity, f"-DCMAKE_CXX_COMPILER={compiler}")
    assert "warning" not in said.lower(), said


def test_all_four_presets_exist() -> None:
    """The README names four presets; no other one is there to be tested."""
    presets = json.loads((STUB / "CMakePresets.json").read_text())["configurePresets"]
    assert sorted(p["name"] for p in presets) == sorted(PRESETS)


def test_the_library_exports_only_the_abi(reference_build: Path) -> None:
    """Every function that the C header declares is exported, and no function beyond them."""
    header = (STUB / "abi" / "exercise03_abi.h").read_text()
    declared = set(re.findall(r"(ex03_\w+)\(", header))
    listed = run("nm", "-D", "--defined-only", reference_build / "libexercise03.so").stdout
    rows = [line.split()[-2:] for line in listed.splitlines()]
    assert {name for kind, name in rows if kind == "T"} == declared
    assert all(name.startswith("_ZSt") or "NSt" in name for kind, name in rows if kind != "T")


def test_the_framework_stays_out_of_the_global_namespace(reference_build: Path) -> None:
    """Given code defines the fixed interface, `ex03` and the C functions: nothing else."""
    objects = sorted(reference_build.glob("CMakeFiles/framework.dir/**/*.o"))
    assert len(objects) >= 5
    listed = run("nm", "-C", "--defined-only", "--extern-only", *objects).stdout
    names = re.findall(r"^[0-9a-f]* +[A-Zu] (.+)$", listed, re.MULTILINE)
    allowed = re.compile(
        r"(ex03_|.*\bex03::|.*\bstd::|(AABB|BVH|Mesh|IntersectionRay)::|DW\.ref|"
        r"__gnu_cxx::|intersect\((AABB|Triangle|Mesh) const&, IntersectionRay const&\)$)"
    )
    assert [name for name in names if not allowed.match(name)] == []


def test_a_file_that_cannot_be_written_is_a_crash_at_home_only(reference_build: Path) -> None:
    """The library that is graded has an `fopen` of its own; the preview has the system's."""
    library, preview = (
        run("nm", reference_build / name).stdout for name in ("libexercise03.so", "preview")
    )
    assert re.search(r" t fopen$", library, re.MULTILINE)
    assert not re.search(r" [tT] fopen$", preview, re.MULTILINE)


def test_the_depth_limit_can_be_lowered(tmp_path: Path) -> None:
    """The sanitized build of the grader reaches the depth limit on small meshes."""
    build(tmp_path, "-DEX03_MAX_DEPTH=6", "-DCMAKE_BUILD_TYPE=Debug")
    assert load(tmp_path / "libexercise03.so").ex03_max_depth() == 6


def test_one_command_compiles_the_submission(reference_build: Path) -> None:
    """The grader finds exactly one command for the one file of the student."""
    commands = json.loads((reference_build / "compile_commands.json").read_text())
    own = [c["command"] for c in commands if "submission.dir" in c["command"]]
    assert len(own) == 1
    assert "-Werror" not in own[0]
    assert "-ffp-contract=off" in own[0]
    assert "-march" not in own[0]
    assert STARTER.name in own[0]
