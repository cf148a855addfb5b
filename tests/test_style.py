"""The rules of style that no other tool enforces; ruff has those on functions and lines."""

import ast
import re
from fnmatch import fnmatch
from pathlib import Path

import pytest

from grader.model.stages import SOURCE_PATH
from tests.own_files import ROOT, cpp_files, python_files, texts

LONGEST = {"grader": 300, "tests": 400}
LONGEST_HEADER = 120
LONGEST_CPP = 300

_UNNUMBERED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b(?!\(#\d+\))")
_MACHINE = re.compile(
    r"/(?:home|Users|root|work)/[a-z]"
    r"|https?://[^\s/]*(?:pypi|pythonhosted|jfrog|artifact|nexus|mirror|proxy)[^\s/]*",
    re.IGNORECASE,
)
_VAGUE = {"utils", "helpers", "common", "misc", "manager", "util", "helper"}
_BARE_NOQA = re.compile(r"#\s*noqa(?!: [A-Z]+\d+(?:, [A-Z]+\d+)* - \S)")
_BARE_IGNORE = re.compile(r"#\s*type: ignore(?!\[[a-z-]+(?:, ?[a-z-]+)*\]\s+# \S)")
_EXEMPT = {Path(__file__)}
"""This file spells out what it forbids."""


def lines(path: Path) -> list[str]:
    """The lines of a text file."""
    return path.read_text(encoding="utf-8").splitlines()


def in_checkout(path: Path) -> str:
    """A path as one types it."""
    return str(path.relative_to(ROOT))


@pytest.mark.parametrize("folder", LONGEST)
def test_files_are_short(folder: str) -> None:
    """A file holds one idea, and a reader sees its end."""
    long = {
        in_checkout(path): len(lines(path))
        for path in python_files(folder)
        if len(lines(path)) > LONGEST[folder]
    }
    assert not long


def test_cpp_files_are_short() -> None:
    """A student opens a header once."""
    long = [in_checkout(path) for path in cpp_files("*.h") if len(lines(path)) > LONGEST_HEADER]
    long += [in_checkout(path) for path in cpp_files("*.cpp") if len(lines(path)) > LONGEST_CPP]
    assert not long


def test_headers_are_guarded_once() -> None:
    """Every header begins with `#pragma once`, after its comment if it has one."""
    for path in cpp_files("*.h"):
        code = [line for line in lines(path) if line and not line.startswith(("/", " *"))]
        guard = "#ifndef" if 'extern "C"' in path.read_text() else "#pragma once"
        assert code[0].startswith((guard, "#pragma once")), in_checkout(path)


def test_half_of_all_functions_are_short() -> None:
    """The median function has fewer than 8 statements."""
    sizes = [
        sum(isinstance(inner, ast.stmt) for inner in ast.walk(node)) - 1
        for path in python_files("grader")
        for node in ast.walk(ast.parse(path.read_bytes()))
        if isinstance(node, ast.FunctionDef)
    ]
    assert sorted(sizes)[len(sizes) // 2] < 8


def test_names_of_modules_say_something() -> None:
    """No module is called after the fact that it was hard to name; none begins with `_`."""
    for path in python_files("grader", "tests"):
        name = path.stem
        assert name not in _VAGUE, in_checkout(path)
        assert not name.startswith("_") or name in {"__init__", "__main__"}, in_checkout(path)


def test_exceptions_to_the_tools_are_explained() -> None:
    """Every `noqa` and every `type: ignore` has a code and a reason."""
    for path in python_files("grader", "tests"):
        for number, line in enumerate(lines(path), start=1):
            bare = _BARE_NOQA.search(line) or _BARE_IGNORE.search(line)
            assert path in _EXEMPT or not bare, f"{in_checkout(path)}:{number}: {line}"


def test_no_todo_without_an_issue() -> None:
    """`TODO(#12)` can be found again; the starter's two TODOs are the exercise itself.

    And who has not begun is told to begin there.
    """
    exercise = {ROOT / "student_stub/src/exercise03.cpp", ROOT / "grader/report/facts.py"}
    for path in (*python_files("grader", "tests"), *cpp_files("*.h"), *cpp_files("*.cpp")):
        if path in _EXEMPT | exercise:
            continue
        found = [line for line in lines(path) if _UNNUMBERED.search(line)]
        assert not found, in_checkout(path)


def test_no_path_of_a_machine_is_committed() -> None:
    """What works here only, and hosts that packages come from, stay out."""
    for path in texts():
        if path in _EXEMPT or "submissions" in path.parts:
            continue
        text = path.read_text(encoding="utf-8", errors="replace")
        found = _MACHINE.search(text)
        assert not found, f"{in_checkout(path)}: {found}"


@pytest.mark.parametrize(
    ("pattern", "right", "wrong"),
    [
        (_BARE_NOQA, "# noqa: S101 - why", "# noqa: S101"),
        (_BARE_NOQA, "# noqa: S101, E501 - why", "# noqa"),
        (_BARE_IGNORE, "# type: ignore[arg-type]  # why", "# type: ignore[arg-type]"),
        (_UNNUMBERED, "TODO(#12): x", "TODO: x"),
        (_MACHINE, "/usr/bin/python3", "/home/somebody/x"),
        (_MACHINE, "https://doi.org/10", "https://pypi.example.org/simple"),
    ],
)
def test_the_patterns_see_what_they_should(
    pattern: re.Pattern[str], right: str, wrong: str
) -> None:
    """Each pattern lets the right line through and stops the wrong one."""
    assert not pattern.search(right)
    assert pattern.search(wrong)


def test_no_folder_of_tests_is_passed_over(pytestconfig: pytest.Config) -> None:
    """What pytest does not enter is not run, and nobody is told."""
    passed_over = pytestconfig.getini("norecursedirs")
    for folder in {path.parent for path in python_files("tests")}:
        for name in folder.relative_to(ROOT).parts:
            assert not [each for each in passed_over if fnmatch(name, each)], folder


def test_the_students_file_is_spelled_once() -> None:
    """Its path, as messages and the exercise have it; whoever needs it imports it."""
    spelled = [
        path for path in python_files("grader") if f'"{SOURCE_PATH}"' in path.read_text()
    ]
    assert SOURCE_PATH == "src/exercise03.cpp"
    assert not spelled


CATCHERS = 12
"""Places that catch whatever is raised; CONTRIBUTING.md has each with its reason."""


def test_few_places_catch_everything() -> None:
    """Elsewhere a fault of ours is heard of."""
    found = [
        in_checkout(path)
        for path in python_files("grader")
        for line in lines(path)
        if re.search(r"except (?:\(.*\b)?Exception\b|isinstance\(.*\bException\)", line)
    ]
    assert len(found) == CATCHERS, found
