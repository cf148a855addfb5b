"""What works on this machine, and what must be installed for the rest?"""

import os
import re
import shutil
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from importlib import metadata, util
from pathlib import Path

from grader.build.compiler import Compiler, find_compiler, sanitizer_runtime
from grader.errors import GraderError, MissingTool
from grader.oracle.variant import working_variant
from grader.resources import cache_folder, reference_source, scenes_folder, stub_folder
from grader.sandbox.launch import Order, launch
from grader.sandbox.selftest import proved_isolation
from grader.view.needed import has_display

PROBE_SECONDS = 20.0

NEEDED_PACKAGES = (
    "numpy",
    "click",
    "rich",
    "trimesh",
    "embreex",
    "jinja2",
    "jsonschema",
    "pillow",
    "flip-evaluator",
    "OpenEXR",
)
OLDEST = {"g++": (12,), "clang++": (14,), "cmake": (3, 21)}
"""Versions that the exercise is made for: all of C++20 that it uses, and the presets."""

RENDER_PACKAGES = ("mitsuba", "drjit")
RENDER_REMEDY = "pip install 'bvhgrade[render]'"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was looked at."""

    subject: str
    ok: bool
    state: str
    """What was found: a version, a size, or why it does not work."""

    remedy: str = ""
    """What to install or to do; empty if nothing."""

    needed: bool = True
    """Grading does not work without it."""


def examine() -> tuple[Finding, ...]:
    """Look at everything that grading and rendering need."""
    found = [python(), compiler(), sanitizers(), program("cmake"), program("make")]
    found += [package(name) for name in NEEDED_PACKAGES]
    found += [package(name, RENDER_REMEDY) for name in RENDER_PACKAGES]
    found += [mitsuba(), display(), own_files(), cache_state(), isolation(), processors()]
    return tuple(found)


def able(findings: tuple[Finding, ...]) -> bool:
    """Grading works: nothing that it needs is missing."""
    return all(finding.ok for finding in findings if finding.needed)


def python() -> Finding:
    """Name the interpreter."""
    return Finding("Python", ok=True, state=f"{sys.version.split()[0]} ({sys.executable})")


def guarded(subject: str, needed: bool, look: Callable[[], Finding]) -> Finding:
    """Turn a fault that was met while looking into a finding with its own words."""
    try:
        return look()
    except GraderError as fault:
        state, _, remedy = str(fault).partition("; ")
        return Finding(subject, ok=False, state=state, remedy=remedy, needed=needed)


@cache
def chosen() -> Compiler:
    """Find the compiler once."""
    return find_compiler()


def compiler() -> Finding:
    """Name the compiler that submissions are built with."""

    def look() -> Finding:
        found = chosen()
        state = f"{found.title}, {found.path}"
        remedy = "apt install g++-12 (or newer), and name it by CXX"
        return of_age(Finding("compiler", True, state), found.name, found.version, remedy)

    return guarded("compiler", True, look)


def of_age(finding: Finding, name: str, version: str, remedy: str) -> Finding:
    """Refuse a program that is too old; one that names no version is believed."""
    oldest, found = OLDEST.get(name, ()), tuple(map(int, re.findall(r"\d+", version)[:2]))
    if not found or found >= oldest:
        return finding
    state = f"{finding.state}: older than {'.'.join(map(str, oldest))}"
    return replace(finding, ok=False, state=state, remedy=remedy)


def sanitizers() -> Finding:
    """Look for the sanitizers' runtime libraries, which memory checks need."""

    def look() -> Finding:
        return Finding("sanitizers", True, sanitizer_runtime(chosen()))

    return guarded("sanitizers", True, look)


def program(name: str) -> Finding:
    """Look for a program on the path and ask its version."""
    path = shutil.which(name)
    if path is None:
        return Finding(name, ok=False, state="not found", remedy=f"apt install {name}")

    def look() -> Finding:
        outcome = launch(Order((path, "--version"), PROBE_SECONDS))
        first = outcome.out.decode("utf-8", "replace").split("\n")[0].strip()
        if outcome.code != 0:
            remedy = f"apt install --reinstall {name}"
            return Finding(name, ok=False, state=f"{path} does not run", remedy=remedy)
        remedy = f"apt install {name} of a newer release, or pip install {name}"
        return of_age(Finding(name, ok=True, state=first), name, first, remedy)

    return guarded(name, True, look)


def package(name: str, remedy: str = "") -> Finding:
    """Look for a Python package; one with a remedy of its own is not needed to grade."""
    try:
        return Finding(name, True, metadata.version(name), needed=not remedy)
    except metadata.PackageNotFoundError:
        install = remedy or f"pip install {name}"
        return Finding(name, False, "not installed", install, needed=not remedy)


def mitsuba() -> Finding:
    """Say which variant renders references, and why not the faster one."""
    subject = "rendering"
    if util.find_spec("mitsuba") is None:
        return Finding(subject, False, "stored references are used", RENDER_REMEDY, False)

    def look() -> Finding:
        variant = working_variant()
        fast = variant.library is not None
        remedy = "" if fast else "apt install libllvm19 for the faster llvm_ad_rgb (optional)"
        return Finding(subject, True, f"{variant.name}: {variant.because}", remedy, False)

    return guarded(subject, False, look)


def display() -> Finding:
    """Look for the display that `bvhgrade view` opens its window on."""
    if has_display():
        return Finding("display", True, "bvhgrade view opens a window", needed=False)
    remedy = "bvhgrade view --web shows it in a browser"
    return Finding("display", False, "bvhgrade view has no window here", remedy, False)


def own_files() -> Finding:
    """Look for the framework, the model solution and the scenes."""
    subject = "own files"

    def look() -> Finding:
        paths = (stub_folder(), reference_source(), scenes_folder())
        missing = [str(path) for path in paths if not path.exists()]
        if missing:
            remedy = "install bvhgrade again"
            return Finding(subject, False, f"{', '.join(missing)} not found", remedy)
        return Finding(subject, True, str(stub_folder().parent))

    return guarded(subject, True, look)


def cache_state() -> Finding:
    """Say where the cache lies, how large it is, and whether it can be written."""
    subject = "cache"

    def look() -> Finding:
        folder = cache_folder()
        if not os.access(folder, os.W_OK):
            remedy = "set BVHGRADE_CACHE to a folder that can be written"
            return Finding(subject, False, f"{folder} cannot be written", remedy)
        return Finding(subject, True, f"{folder}, {size_of(folder) / 2**20:.0f} MiB")

    return guarded(subject, True, look)


def size_of(folder: Path) -> int:
    """Sum the sizes of the files below a folder, in bytes; links are not followed."""
    total = 0
    for root, _, names in os.walk(folder):
        for name in names:
            try:
                total += (Path(root) / name).lstat().st_size
            except OSError:
                continue
    return total


def isolation() -> Finding:
    """Prove how far submissions are kept from this machine."""
    subject = "isolation"
    try:
        proved = proved_isolation()
    except MissingTool as fault:
        remedy = "apt install bubblewrap, or use a kernel with Landlock (5.13 or newer)"
        state = str(fault).split("\n")[1] if "\n" in str(fault) else str(fault)
        return Finding(subject, False, f"none: {state}", remedy)
    missed = "".join(f"; not {reason}" for reason in proved.unproved)
    return Finding(subject, True, f"{proved.level.value}{missed}")


def processors() -> Finding:
    """Count the processors that this process may use."""
    return Finding("processors", ok=True, state=str(len(os.sched_getaffinity(0))))
