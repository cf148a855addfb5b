"""The header of a hostile submission is read strictly: a misspelt promise is no promise."""

from pathlib import Path

import pytest

from grader.model.stages import Stop
from grader.model.verdict import Verdict
from tests.attacks.attack import Decided, Points, Stopped, Told, read_attack

GOOD = """\
// attack: tries nothing.
// grade: bvh.boxes-are-tight, work.uses-the-tree
// expect: a = full; b <= 3.5; total < full
// expect: fails bvh.boxes-are-tight; passes work.uses-the-tree
// expect: stop crashed; no stop; says "50 of 50"; hides "x"
#include "bvh.h"
// expect: not part of the header
"""


def written(folder: Path, text: str) -> Path:
    """Write a submission."""
    path = folder / "some.cpp"
    path.write_text(text)
    return path


def test_every_clause_is_understood(tmp_path: Path) -> None:
    """Points, verdicts, stops and texts, in the order of the lines."""
    attack = read_attack(written(tmp_path, GOOD))
    assert attack.purpose == "tries nothing."
    assert attack.checks == ("bvh.boxes-are-tight", "work.uses-the-tree")
    assert [clause for _, clause in attack.clauses] == [
        Points("a", "=", "full"),
        Points("b", "<=", "3.5"),
        Points("total", "<", "full"),
        Decided("bvh.boxes-are-tight", Verdict.FAIL),
        Decided("work.uses-the-tree", Verdict.PASS),
        Stopped(Stop.CRASHED),
        Stopped(None),
        Told("50 of 50", said=True),
        Told("x", said=False),
    ]


def test_all_checks_are_scored_without_a_grade_line(tmp_path: Path) -> None:
    """The line is optional; the build of such a file gets the usual time."""
    attack = read_attack(written(tmp_path, "// attack: x.\n// expect: a = 0\n"))
    assert (attack.checks, attack.compiles) == ((), True)


def test_a_file_that_never_compiles_is_known(tmp_path: Path) -> None:
    """It is stopped earlier."""
    text = "// attack: x.\n// expect: a = 0; fails build.compiles\n"
    assert not read_attack(written(tmp_path, text)).compiles


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("// attack: tries nothing.\n", ""),
        ("// attack:", "//attack:"),
        ("// attack:", "// attacks:"),
        ("// grade: ", "// grade: none.such, "),
        ("// grade: ", "// grade:  "),
        ("// grade: ", "// grade: bvh.boxes-are-tight\n// grade: "),
        ("// attack: tries nothing.\n", "// attack: tries nothing.\n// attack: again.\n"),
        ("a = full", "c = full"),
        ("a = full", "a == full"),
        ("a = full", "a = much"),
        ("a = full; ", "a = full;"),
        ("fails bvh", "fails bhv"),
        ("fails bvh", "failed bvh"),
        ("stop crashed", "stop crash"),
        ("stop crashed", "stop finished"),
        ('says "50', "says 50"),
        ("// expect", "// never"),
        ("// expect", "// seen"),
    ],
)
def test_whatever_is_not_understood_is_an_error(tmp_path: Path, old: str, new: str) -> None:
    """With the name of the file."""
    assert old in GOOD
    with pytest.raises(ValueError, match=r"some\.cpp"):
        read_attack(written(tmp_path, GOOD.replace(old, new)))
