"""What a teacher sees while a class is graded: a live table, or a few lines in a pipe."""

import io

import pytest
from rich.console import Console, Group
from rich.live import Live

from grader.batch.records import Student
from grader.cli.live import LINES, Lines, LiveTable

HOSTILE = "\x1b[31m[red]Ada[/red]\n::error::x"


def student(name: str) -> Student:
    """Somebody."""
    return Student(name, name, name, "", "", "plain", None, None, "", "", "")


def test_a_pipe_gets_few_lines(capsys: pytest.CaptureFixture[str]) -> None:
    """A log of 500 lines is not read by anybody; the last one always is there."""
    lines = Lines()
    lines.grading(500)
    for number in range(500):
        lines.finished(student(f"s{number}"), 41.5, 50)
    said = capsys.readouterr().err.splitlines()
    assert len(said) <= LINES + 2
    assert said[-1] == "500 of 500 41.5 of 50 s499"


def test_a_name_cannot_act_on_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    """Neither in a pipe nor in the table."""
    lines = Lines()
    lines.grading(1)
    lines.finished(student(HOSTILE), None, 50)
    lines.trouble(HOSTILE)
    shown = io.StringIO()
    console = Console(file=shown, force_terminal=True, width=100, color_system=None)
    with Live(console=console, auto_refresh=False) as live:
        table = LiveTable(live)
        table.grading(2)
        table.stage(student(HOSTILE), HOSTILE)
        live.refresh()
        table.finished(student(HOSTILE), 3, 50)
    for said in (capsys.readouterr().err, shown.getvalue()):
        assert "[red]Ada" in said
        assert "\x1b[31m" not in said
        assert "\n::error" not in said


def test_the_table_shows_who_is_being_graded() -> None:
    """And no more, once that is done."""
    with Live(console=Console(file=io.StringIO(), width=100), auto_refresh=False) as live:
        table = LiveTable(live)
        table.grading(2)
        table.stage(student("ada"), "build")
        table.stage(student("bob"), "trace")
        table.finished(student("ada"), 50, 50)
        console = Console(file=io.StringIO(), width=100)
        console.print(live.renderable)
    told = console.file
    assert isinstance(told, io.StringIO)
    assert "1 of 2 graded, 1 running" in told.getvalue()
    assert "bob" in told.getvalue()
    assert "ada" not in told.getvalue()


@pytest.mark.parametrize(
    ("seconds", "said"),
    [
        (30, "2 of 10 graded, 1 running, 1 withheld, 4.0 a minute, about 2 min left"),
        (3, "2 of 10 graded, 1 running, 1 withheld, 40.0 a minute, less than a minute left"),
        (1800, "2 of 10 graded, 1 running, 1 withheld, 0.1 a minute, about 2 h 0 min left"),
    ],
)
def test_the_table_says_how_far_and_how_fast(seconds: float, said: str) -> None:
    """Reading the class does not count; before the first is done nobody knows how long."""
    now = [0.0]
    with Live(console=Console(file=io.StringIO(), width=100), auto_refresh=False) as live:
        table = LiveTable(live, lambda: now[0])
        now[0] = 1000
        table.grading(10)
        table.stage(student("ada"), "build")
        assert title(live) == "0 of 10 graded, 1 running, 0 withheld"
        now[0] += seconds
        table.finished(student("bob"), None, 50)
        table.finished(student("cy"), 50, 50)
        assert title(live) == said


def title(live: Live) -> str:
    """What stands above the table."""
    shown = live.get_renderable()
    assert isinstance(shown, Group)
    return str(shown.renderables[0])
