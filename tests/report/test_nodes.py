"""Small trees are drawn in columns that fit, and replays end in a few lines."""

import io
from dataclasses import replace

import pytest
from rich.console import Console

from grader.model.counterexample import Column, NodeTable, Replay
from grader.report.nodes import node_table
from grader.report.replayed import print_replay
from grader.report.sheet import Sheet
from tests.report.hostile import HOSTILE
from tests.report.readers import terminal_reader
from tests.report.small_inputs import small, small_trace


def drawn(table: NodeTable, width: int) -> list[str]:
    """Draw a table on a sheet of some width."""
    stream = io.StringIO()
    sheet = Sheet(Console(file=stream, width=width, color_system=None))
    node_table(sheet, table)
    sheet.show()
    return stream.getvalue().splitlines()


@pytest.mark.parametrize("width", [56, 80, 120])
def test_nine_faces_fit_on_one_row(width: int) -> None:
    """Seven nodes stand side by side even in 56 columns; the mark is below its column."""
    lines = drawn(small().table or NodeTable((), "", "", -1), width)
    assert max(map(len, lines)) <= width
    node, expected, got, mark = lines[:4]
    assert [word for word in node.split() if word.isdigit()] == list("0123456")
    assert expected.count("[0,9)") == got.count("[0,9)") == 7
    assert mark.index("^") == node.index("1")
    assert "3 2 | 1 0 4" in lines[4]
    assert "0 4 | 1 2 3" in lines[5]


def test_more_columns_go_on_below() -> None:
    """A tree with too many nodes is drawn in several rows, and marked in one of them."""
    columns = tuple(Column(node, "[0,9)", "-") for node in range(31))
    lines = drawn(NodeTable(columns, "1", "2", 20), 56)
    assert max(map(len, lines)) <= 56
    numbers = [word for line in lines if " node " in line for word in line.split()[2:]]
    assert numbers == [str(node) for node in range(31)]
    assert sum("^" in line for line in lines) == 1


def told(replay: Replay) -> str:
    """Print a replay."""
    stream = io.StringIO()
    print_replay(Console(file=stream, width=80, color_system=None), replay)
    return terminal_reader(stream.getvalue())


def test_a_replay_tells_what_fails() -> None:
    """The input, where it went wrong, the tree, what is expected and what was got."""
    found = small_trace()
    text = told(Replay(found.check, "The closest hit wins", found))
    order = [
        "The closest hit wins",
        "5 faces, 1 ray",
        "never visited",
        "expected  hit",
        "^",
        "a hit on",
    ]
    places = [text.index(word) for word in order]
    assert places == sorted(places)


def test_a_replay_says_that_it_passes() -> None:
    """One sentence beside the check."""
    text = told(Replay("hits.closest-wins", "The closest hit wins", None))
    assert "hits.closest-wins does not fail on this input any more." in text


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_a_replay_takes_the_power_from_texts(text: str) -> None:
    """Neither a refusal nor a message reaches the terminal as it is."""
    told(Replay("hits.closest-wins", "The closest hit wins", None, text))
    found = replace(small(), message=text, explanation=text, expected=text, got=text)
    told(Replay(found.check, "Boxes are tight", found))
