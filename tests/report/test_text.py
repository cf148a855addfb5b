"""Hostile text comes out harmless, and plain text comes out as it was."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.report.text import FIELD_LIMIT, one_line, printable
from tests.report.hostile import HOSTILE

anything = st.text(st.characters(codec=None, exclude_categories=()), max_size=200)


def assert_harmless(text: str) -> None:
    """Nothing in a text can move a cursor, hide, or turn its neighbours around."""
    kinds = {unicodedata.category(character) for character in text if character not in "\n\t"}
    assert not kinds & {"Cc", "Cf", "Cs", "Cn", "Zl", "Zp"}
    text.encode("utf-8")


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_becomes_harmless_and_short(name: str) -> None:
    """Every known trick is disarmed."""
    assert_harmless(printable(HOSTILE[name]))
    assert len(printable(HOSTILE[name])) <= FIELD_LIMIT


@given(anything)
def test_any_text_becomes_harmless_once_and_for_all(text: str) -> None:
    """What comes out is harmless, and going through it twice changes nothing more."""
    once = printable(text)
    assert_harmless(once)
    assert printable(once) == once
    assert "\n" not in one_line(text)


@pytest.mark.parametrize(
    "text",
    ["", "plain", "v[red] <b> & \"q\" 'q' \\", "two\nlines\tand a tab", "Größe ≤ 4 漢字"],
)
def test_harmless_text_is_not_touched(text: str) -> None:
    """Escaping what is special to one format is that format's own job."""
    assert printable(text) == text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\x1b[1;31mred\x1b[0m", "red"),
        ("\x1b]0;title\x07after", "after"),
        ("\x1b]0;title\x1b\\after", "after"),
        ("\x9b2Jafter", "after"),
        ("\x1bcafter", "after"),
        ("a\r\nb\rc", "a\nb\nc"),
        ("a\x00b", "a\ufffdb"),
        ("a\ud800b", "a\ufffdb"),
        ("\u202eabc", "<U+202E>abc"),
        ("a\u2028b", "a\nb"),
    ],
)
def test_each_kind_has_its_own_replacement(text: str, expected: str) -> None:
    """Sequences vanish, invisible characters show their code, others become a sign."""
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
    """Names stand in headings, where a line break would break the layout."""
    assert one_line(" a\n\n b\tc ") == "a b c"
