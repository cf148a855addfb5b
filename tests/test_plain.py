"""Hostile text comes out harmless, and plain text comes out as it was."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.plain import (
    FIELD_LIMIT,
    INVISIBLE,
    MOST_MARKS,
    NAME_LIMIT,
    as_name,
    one_line,
    printable,
)
from tests.report.hostile import HOSTILE

anything = st.text(st.characters(codec=None, exclude_categories=()), max_size=200)


def assert_harmless(text: str) -> None:
    """Nothing in a text can move a cursor, hide, pile up or turn its neighbours around."""
    marks = MOST_MARKS
    for character in text:
        marks = marks + 1 if unicodedata.category(character) in ("Mn", "Me") else 0
        assert character.isprintable() or character in "\n\t"
        assert not INVISIBLE.match(character)
        assert marks <= MOST_MARKS


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_becomes_harmless_and_short(name: str) -> None:
    """Every known trick is disarmed."""
    assert_harmless(printable(HOSTILE[name]))
    assert len(printable(HOSTILE[name])) <= FIELD_LIMIT
    assert as_name(HOSTILE[name]).isprintable()
    assert len(as_name(HOSTILE[name])) <= NAME_LIMIT


@given(anything)
def test_any_text_becomes_harmless_once_and_for_all(text: str) -> None:
    """What comes out is harmless, and going through it twice changes nothing more."""
    for way in (printable, one_line, as_name):
        once = way(text)
        assert_harmless(once)
        assert way(once) == once
    assert "\n" not in one_line(text)
    assert as_name(text).isprintable()


@pytest.mark.parametrize(
    "text",
    [
        "",
        "plain",
        "v[red] <b> & \"q\" 'q' \\",
        "two\nlines\tand a tab",
        "Größe ≤ 4 漢字 e\u0301",
    ],
)
def test_harmless_text_is_not_touched(text: str) -> None:
    """Escaping what is special to one format is that format's own job."""
    assert printable(text) == text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\x1b[1;31mred\x1b[0m", r"\x1b[1;31mred\x1b[0m"),
        ("\x9b2Jafter", r"\x9b2Jafter"),
        ("a\r\nb\rc\x0bd", "a\nb\nc\nd"),
        ("a\x00b\x7f", r"a\x00b\x7f"),
        ("a\ud800b\udcff", r"a\ud800b\udcff"),
        ("\u202eabc\u00a0", r"\u202eabc\xa0"),
        ("a\u2028b\x85c", "a\nb\nc"),
        ("#\u034f#[error]\ufe0f", r"#\u034f#[error]\ufe0f"),
        ("\u0301a" + "\u0301" * 6, "\\u0301a" + "\u0301" * 4 + r"\u0301" * 2),
    ],
)
def test_what_is_not_seen_is_written_as_its_code(text: str, expected: str) -> None:
    """As C++ would write it; only ends of lines become one kind."""
    assert printable(text) == expected


def test_a_long_text_keeps_both_ends_and_says_what_is_missing() -> None:
    """The middle of a text is the part that teaches least."""
    text = "head" + "x" * 1_000_000 + "tail"
    kept = printable(text, 100)
    assert kept.startswith("head")
    assert kept.endswith("tail")
    assert "999,948 characters" in kept
    assert len(kept) <= 100


def test_one_line_joins_lines() -> None:
    """Titles stand in headings, where a line break would break the layout."""
    assert one_line(" a\r\n\n b\tc\x0b\u2028d ") == "a b c d"


def test_two_names_stay_two() -> None:
    """A new line in a name is told from a space, and the end of a path is kept."""
    assert as_name("a\n b") == r"a\n b"
    assert as_name("x" * 300 + "/exercise03.cpp").endswith("x/exercise03.cpp")
