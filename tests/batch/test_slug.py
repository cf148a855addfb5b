"""The folder of a student has a name that nothing acts on, and that nobody else has."""

import re

import pytest

from grader.batch.slug import LONGEST, slug

NOBODY: set[str] = set()


@pytest.mark.parametrize(
    ("name", "id", "expected"),
    [
        ("Ada Lovelace", "9001", "ada-lovelace-9001"),
        ("Jürgen Groß", "", "jurgen-gross"),
        ("ada", "ada", "ada"),
        ("../../etc/passwd", "", "etc-passwd"),
        ("-rf *", "", "rf"),
    ],
)
def test_a_name_is_spelled_plainly(name: str, id: str, expected: str) -> None:
    """Letters, digits and hyphens."""
    assert slug(name, id, "key", NOBODY.__contains__) == expected


@pytest.mark.parametrize(
    "name", ["", "..", "李小龙", "\udcff", "CON", "lpt1", "\x1b[2J", "a" * 999, "bvhgrade-out"]
)
def test_any_name_gives_a_folder(name: str) -> None:
    """Also one of which nothing is left, and one that is a device or a folder of our own."""
    found = slug(name, "", name, NOBODY.__contains__)
    assert re.fullmatch(r"[a-z0-9][a-z0-9-]*", found)
    assert len(found) <= LONGEST
    assert found not in {"con", "lpt1", "bvhgrade-out"}


def test_a_name_that_is_taken_gets_digits_of_its_own() -> None:
    """They depend on the submission only, not on who came first."""
    taken = {"ada"}
    first = slug("Ada", "", "Ada.cpp", taken.__contains__)
    second = slug("ADA", "", "ADA.cpp", taken.__contains__)
    assert first != second
    assert slug("Ada", "", "Ada.cpp", {"ada", "b"}.__contains__) == first
    longer = slug("Ada", "", "Ada.cpp", {"ada", first}.__contains__)
    assert longer.startswith(first)
    assert longer != first
