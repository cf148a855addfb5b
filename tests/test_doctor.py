"""The doctor names what is missing and what to install."""

import os
import re
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

import pytest

from grader import doctor
from grader.doctor import able, examine
from grader.errors import MissingTool


@pytest.fixture(autouse=True)
def own_cache(monkeypatch: pytest.MonkeyPatch, cache: Path) -> Iterator[None]:
    """Look at the cache of the tests, and forget the compiler afterwards."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(cache))
    doctor.chosen.cache_clear()
    yield
    doctor.chosen.cache_clear()


def test_this_machine_can_grade() -> None:
    """Whoever runs the tests has all that grading needs."""
    found = {finding.subject: finding for finding in examine()}
    assert able(tuple(found.values())), [one for one in found.values() if not one.ok]
    assert found["rendering"].state.startswith(("scalar_rgb: ", "llvm_ad_rgb: "))
    assert found["isolation"].state == "bubblewrap+landlock+seccomp"
    assert found["processors"].state == str(len(os.sched_getaffinity(0)))


def test_whatever_is_missing_has_a_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a machine without any program, nothing is ok and nothing raises."""
    monkeypatch.setenv("PATH", "/nowhere")
    monkeypatch.delenv("CXX", raising=False)
    for finding in (
        doctor.compiler(),
        doctor.sanitizers(),
        doctor.program("cmake"),
        doctor.program("make"),
    ):
        assert not finding.ok
        assert "install" in finding.remedy
        assert finding.needed


def test_a_program_that_does_not_run_is_no_program(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """It is found, but fails when asked."""
    broken = tmp_path / "cmake"
    broken.write_text("#!/bin/sh\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert not doctor.program("cmake").ok


@pytest.mark.parametrize(
    ("name", "version", "ok"),
    [
        ("g++", "g++ (Debian 11.4.0-1) 11.4.0", False),
        ("g++", "g++ (Debian 12.2.0-14) 12.2.0", True),
        ("clang++", "Debian clang version 13.0.1", False),
        ("clang++", "Debian clang version 14.0.6", True),
        ("cmake", "cmake version 3.9.6", False),
        ("cmake", "cmake version 3.21.0", True),
        ("cmake", "cmake version 4.0.1", True),
        ("cmake", "a CMake that somebody patched", True),
    ],
)
def test_what_is_too_old_is_not_ok(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str, version: str, ok: bool
) -> None:
    """Else the first grade would end in the compiler's own words."""
    program = tmp_path / name
    program.write_text(f"#!/bin/sh\necho '{version}'\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("CXX", str(program))
    finding = doctor.program(name) if name == "cmake" else doctor.compiler()
    assert (finding.ok, finding.needed) == (ok, True)
    assert ("older than" in finding.state) is not ok
    assert ("install" in finding.remedy) is not ok


def test_a_missing_package_is_named_by_how_it_is_installed() -> None:
    """The renderer's packages come as an extra, and are not needed to grade."""
    missing = doctor.package("no_such_package")
    extra = doctor.package("no_such_package", doctor.RENDER_REMEDY)
    assert (missing.ok, missing.needed) == (False, True)
    assert missing.remedy == "pip install no_such_package"
    assert (extra.ok, extra.needed) == (False, False)
    assert "bvhgrade[render]" in extra.remedy


def test_every_package_of_ours_is_looked_at() -> None:
    """Those of the extras apart."""
    needed = {name for name in metadata.requires("bvhgrade") or () if "extra ==" not in name}
    names = {re.split(r"[<>=!~\[; ]", each)[0].lower() for each in needed}
    assert names == {name.lower() for name in doctor.NEEDED_PACKAGES}


@pytest.mark.parametrize("name", ["DISPLAY", "WAYLAND_DISPLAY"])
def test_without_a_display_grading_works(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """And a browser shows what the window would."""
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    without = doctor.display()
    assert (without.ok, without.needed) == (False, False)
    assert "--web" in without.remedy
    monkeypatch.setenv(name, ":0")
    assert doctor.display().ok


def test_without_mitsuba_grading_works(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stored references do."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    finding = doctor.mitsuba()
    assert not finding.ok
    assert able((finding,))


def test_a_cache_that_cannot_be_made_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """With the variable that moves it."""
    (tmp_path / "file").touch()
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "file" / "below"))
    finding = doctor.cache_state()
    assert not finding.ok
    assert "BVHGRADE_CACHE" in finding.remedy


def test_missing_sanitizers_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """A compiler alone is not enough for the checks of memory."""

    def missing(_: object) -> str:
        raise MissingTool("g++ has no shared AddressSanitizer; install libasan8")

    monkeypatch.setattr(doctor, "sanitizer_runtime", missing)
    finding = doctor.sanitizers()
    assert not finding.ok
    assert finding.remedy == "install libasan8"


def test_sizes_count_files_once_and_follow_no_links(tmp_path: Path) -> None:
    """A link out of the cache is not the cache."""
    (tmp_path / "below").mkdir()
    (tmp_path / "below" / "file").write_bytes(b"x" * 1000)
    (tmp_path / "link").symlink_to("/usr")
    assert 1000 <= doctor.size_of(tmp_path) < 2000
