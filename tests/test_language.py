"""Both languages say everything, with the same numbers in it."""

import gettext
import re
import struct
from collections import Counter
from io import BytesIO
from pathlib import Path

import pytest

from grader.language import LANGUAGES, catalogue, parsed, translator, usual_language
from grader.report.sheet import LABEL_WIDTH
from tests.messages import labels, messages
from tests.own_files import ROOT

PLACEHOLDER = re.compile(r"\{[a-z]*\}")
CODE = re.compile(r"`[^`]*`")
KEY = re.compile(r'^(?:msgctxt "(.*)"\n)?msgid ((?:".*"\n)+)', re.MULTILINE)
"""Context and text of an entry."""

OTHER_NAMES = (
    *("(?<!Ober)[Ff]läche", "[Mm]ittelpunkt", "Übung", "Grader", "[Ii]solier", "Exception"),
    *("[Kk]ompil", "Kosten", "Fehlschuss", "fehlschl", r"schl[aä]g\w* .*fehl"),
)
"""What German says once as Dreieck, Schwerpunkt, Aufgabe, Bewertung, Abschottung, Ausnahme,
übersetzen, Aufwand, ohne Treffer and nicht bestanden."""


@pytest.mark.parametrize("language", [each for each in LANGUAGES if each != "en"])
def test_every_message_is_translated_and_nothing_else(language: str) -> None:
    """`python -m tests.messages` lists them."""
    known = catalogue(language)
    assert set(known) == set(messages())
    assert all(known.values())


@pytest.mark.parametrize("language", [each for each in LANGUAGES if each != "en"])
def test_translations_have_the_same_placeholders(language: str) -> None:
    """A name in braces, or of code, is the same in both."""
    for english, other in catalogue(language).items():
        assert sorted(PLACEHOLDER.findall(english)) == sorted(PLACEHOLDER.findall(other))
        assert set(CODE.findall(english)) == set(CODE.findall(other))


@pytest.mark.parametrize("language", [each for each in LANGUAGES if each != "en"])
def test_no_text_is_translated_twice(language: str) -> None:
    """As msgfmt -c demands; of two entries the later one would win without a word."""
    text = (ROOT / "grader" / "locale" / f"{language}.po").read_text(encoding="utf-8")
    assert [each for each, times in Counter(KEY.findall(text)).items() if times > 1] == []


def test_an_entry_that_is_there_twice_is_seen() -> None:
    """The same text in another context is another entry."""
    plain, other = 'msgid "a"\nmsgstr "1"\n\n', 'msgctxt "check"\nmsgid "a"\nmsgstr "2"\n\n'
    assert len(set(KEY.findall(plain + other))) == 2
    assert len(set(KEY.findall(plain + other + plain))) == 2
    assert len(KEY.findall(plain + other + plain)) == 3


@pytest.mark.parametrize("word", OTHER_NAMES)
def test_one_thing_has_one_german_name(word: str) -> None:
    """Whoever reads of a Fläche would ask how it differs from a Dreieck."""
    told = [*catalogue("de").values(), *catalogue("de", "check").values()]
    assert [each for each in told if re.search(word, each)] == []


@pytest.mark.parametrize("label", sorted(labels()))
def test_a_label_fits_into_its_column(label: str) -> None:
    """What stands beside it in a terminal begins at the same place in each language."""
    assert len(translator("de")(label)) <= LABEL_WIDTH


def test_an_unknown_text_stays_as_it_is() -> None:
    """A rubric's own title, for example."""
    assert translator("de")("Bonus exercise") == "Bonus exercise"
    assert translator("en")("fail") == "fail"
    assert translator("de")("fail") == "nicht bestanden"


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "de_DE.UTF-8"}, "de"),
        ({"LANG": "de_DE.UTF-8", "LC_ALL": "C.UTF-8"}, "en"),
        ({"LC_ALL": "", "LC_MESSAGES": "de_AT", "LANG": "en_US"}, "de"),
        ({"LANG": "fr_FR"}, "en"),
        ({"LANG": "de"}, "de"),
    ],
)
def test_the_environment_chooses_as_for_gettext(
    environment: dict[str, str], language: str
) -> None:
    """LC_ALL goes before LC_MESSAGES, and that before LANG; an empty one counts as none."""
    assert usual_language(environment) == language


def test_a_catalogue_reads_as_gettext_reads_it(tmp_path: Path) -> None:
    """Compiled to the binary form, gettext finds the same texts."""
    known = {"": "Content-Type: text/plain; charset=UTF-8\n", **catalogue("de")}
    pairs = [(key.encode(), known[key].encode()) for key in sorted(known)]
    reader = gettext.GNUTranslations(BytesIO(binary(pairs)))
    assert all(reader.gettext(english) == text for english, text in catalogue("de").items())


def binary(pairs: list[tuple[bytes, bytes]]) -> bytes:
    """Write gettext's binary form of a catalogue. Source: GNU gettext manual, MO Files."""
    start = 28 + 16 * len(pairs)
    tables: tuple[list[int], list[int]] = ([], [])
    data = b""
    for side, table in enumerate(tables):
        for pair in pairs:
            table += [len(pair[side]), start + len(data)]
            data += pair[side] + b"\0"
    head = [0x950412DE, 0, len(pairs), 28, 28 + 8 * len(pairs), 0, start]
    numbers = [*head, *tables[0], *tables[1]]
    return struct.pack(f"<{len(numbers)}I", *numbers) + data


def test_strings_may_go_on_in_the_next_line() -> None:
    """As msgfmt writes long ones."""
    text = '# note\nmsgid ""\n"one \\"two\\" "\n"three"\nmsgstr "eins\\n"\n"zwei"\n'
    assert parsed(text) == {'one "two" three': "eins\nzwei"}


def test_a_context_has_entries_of_its_own() -> None:
    """The same English text may be told otherwise there."""
    plain, other = 'msgid "a"\nmsgstr "1"\n\n', 'msgctxt "check"\nmsgid "a"\nmsgstr "2"\n\n'
    text = plain + other + 'msgid "b"\nmsgstr "3"\n'
    assert parsed(text) == {"a": "1", "b": "3"}
    assert parsed(text, "check") == {"a": "2"}
