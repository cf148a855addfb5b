"""The terminal report keeps its layout at every width and lets no hostile text act."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from grader.model.grade import Grade
from grader.model.stages import Rejected
from grader.report.failure import Occasion
from tests.report import samples
from tests.report.goldens import FOLDER, OCCASION, SCREENS, Screen, cases, printed
from tests.report.hostile import HOSTILE

COMMAND = "bvhgrade check src/exercise03.cpp --seed 41 --only hits.closest-wins"


@pytest.mark.parametrize("name", cases())
def test_reports_are_the_golden_ones(name: str) -> None:
    """If a change is wanted, `python -m tests.report.goldens` writes them anew."""
    sample, screen = cases()[name]
    report = printed(samples.EVERY[sample](), SCREENS[screen])
    assert report == (FOLDER / name).read_bytes()


def test_no_golden_file_is_left_over() -> None:
    """Every file belongs to a case."""
    assert {path.name for path in FOLDER.iterdir()} == set(cases())


@pytest.mark.parametrize("name", samples.EVERY)
@pytest.mark.parametrize("width", [56, 57, 72, 80, 99, 100, 120, 200])
def test_lines_fit_and_commands_stay_whole(name: str, width: int) -> None:
    """Only a command may be longer than the terminal is wide."""
    report = printed(samples.EVERY[name](), Screen(width=width)).decode()
    for line in report.splitlines():
        assert len(line) <= min(width, 120) or re.search("bvhgrade (check|view)", line)
    assert (COMMAND in report) == (name == "failing")


def test_the_order_of_a_failure_is_kept() -> None:
    """What happened, numbers, expected, got, where, cause, hint, what to try, again."""
    grade, occasion = samples.changed(c5=samples.loose_boxes()), replace(OCCASION, hints=3)
    report = printed(grade, Screen(), occasion).decode()
    block = report[report.index("✗ fail") :]
    words = ["reaches out", "example", "expected", "got", "look at", "> "]
    words += ["cause", "hint", "try", "again"]
    places = [block.index(word) for word in words]
    assert places == sorted(places)
    assert ":7 in boxOf" in block


def test_the_statement_s_line_is_shown_only_where_it_is_known() -> None:
    """A failure that is known by its function gets no excerpt."""
    assert "> " not in printed(samples.failing(), Screen()).decode()


def test_colours_are_a_terminal_s_only() -> None:
    """A pipe gets none, and NO_COLOR takes them away from a terminal."""
    grade = samples.failing()
    assert b"\x1b" not in printed(grade, Screen())
    assert b"\x1b[31m" in printed(grade, Screen(terminal=True))
    plain = printed(grade, Screen(terminal=True, no_color=True))
    assert not re.search(rb"\x1b\[[0-9;]*3[0-7]m", plain)


def test_an_encoding_without_signs_gets_words() -> None:
    """Ticks become ok, FAIL and --."""
    report = printed(samples.failing(), Screen(encoding="cp1252")).decode("cp1252")
    for line in ("  ok   bvh.is-readable", "  FAIL hits.closest-wins", "  --   bvh.children"):
        assert line in report
    assert report.isascii()


def test_text_that_the_encoding_lacks_is_written_as_its_code() -> None:
    """A Greek letter in a message does not end the program."""
    grade = samples.changed(c5=samples.loose_boxes("\u03b1 > \u4e2d"))
    report = printed(grade, Screen(encoding="cp1252")).decode("cp1252")
    assert "\\u03b1 > \\u4e2d" in report


def test_a_style_does_not_leak_into_what_follows() -> None:
    """The sign is red, the statement is only bold."""
    report = printed(samples.failing(), Screen(terminal=True))
    assert b"\x1b[31m\xe2\x9c\x97 fail  \x1b[0m\x1b[1mThe closest" in report


def decoded(grade: Grade, screen: str) -> str:
    """Print on one of the screens and read it back."""
    return printed(grade, SCREENS[screen]).decode(SCREENS[screen].encoding)


def test_markup_is_only_text() -> None:
    """Brackets survive as they were written."""
    text = HOSTILE["markup"]
    assert text in decoded(samples.changed(c5=samples.loose_boxes(text)), "120")


def test_a_part_that_is_not_written_is_not_listed_as_failures() -> None:
    """One sentence stands for all its checks."""
    report = printed(samples.starter(), Screen()).decode()
    assert (
        "Part a is not started: BVH::construct still does what the given code does." in report
    )
    assert "Part b is not started: intersect still does what the given code does." in report
    assert "hits.closest-wins" not in report


def test_a_file_that_does_not_compile_is_not_called_unstarted() -> None:
    """Its parts earned nothing for another reason."""
    grade = samples.uncompiled()
    parts = tuple(replace(part, started=False) for part in grade.parts)
    assert "not started" not in printed(replace(grade, parts=parts), Screen()).decode()


def test_a_hidden_check_is_not_offered_for_a_run_of_its_own() -> None:
    """`check` does not run what the rubric hides; who graded it for a course sees its words."""
    hidden = replace(samples.first_hit_wins(), visibility="hidden")
    report = printed(samples.changed(c7=hidden), Screen()).decode()
    assert "closer hit" in report
    assert "--only hits.closest-wins" not in report


def test_why_there_is_no_file_is_told_in_german() -> None:
    """And so is what we remarked."""
    german = replace(OCCASION, language="de")
    refused = Rejected("ada", "no file is called exercise03.cpp; there is `no hit`")
    told = printed(replace(samples.rejected(), submission=refused), Screen(), german).decode()
    assert "keine Datei heißt exercise03.cpp; vorhanden ist `no hit`" in told
    grade = samples.perfect()
    assert grade.build is not None
    remark = "it prints more than 64 KiB in one run; the rest was dropped"
    noted = replace(grade, build=replace(grade.build, remarks=(remark,)))
    told = printed(noted, Screen(), german).decode()
    assert "sie gibt in einem Lauf mehr als 64 KiB aus; der Rest wurde verworfen." in told


def test_an_isolated_run_is_not_called_unisolated() -> None:
    """The sentence stands only where it is true."""
    isolated = printed(samples.perfect(), Screen()).decode()
    assert "NOT ISOLATED" not in isolated
    assert "isolated by bubblewrap+landlock+seccomp" in isolated
    exposed = replace(samples.PROVENANCE, isolation="none")
    lines = printed(replace(samples.perfect(), provenance=exposed), Screen()).decode()
    assert "NOT ISOLATED" in lines.split("a)")[0], "it stands above everything else"
    assert "isolated by" not in lines


def test_without_a_command_or_a_file_neither_is_named() -> None:
    """A report may be printed from a stored grade."""
    report = printed(samples.failing(), Screen(), Occasion("")).decode()
    assert "again" not in report
    assert "result " not in report


def test_paths_are_shown_as_they_are() -> None:
    """A folder named like markup is a folder."""
    where = replace(OCCASION, written=Path("[bold]x/result.json"))
    assert "[bold]x/result.json" in printed(samples.perfect(), Screen(), where).decode()
