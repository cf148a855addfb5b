"""The same hostile texts go through every format, each read back by its own reader."""

import json
import re
from dataclasses import replace

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.cells import cell_len

from grader.errors import OutputFault
from grader.plain import FIELD_LIMIT, one_line, printable
from grader.report import escape
from grader.report.as_json import schema_text, to_text
from tests.report import readers, samples
from tests.report.everywhere import everywhere
from tests.report.goldens import SCREENS, Screen, printed
from tests.report.hostile import HOSTILE

COMMAND = re.compile("bvhgrade (check|view) ")
"""A command is one line, so that it can be copied."""

STYLE = re.compile(r"\x1b\[[0-9;]*m")
SCHEMA = jsonschema.Draft202012Validator(json.loads(schema_text()))
anything = st.text(st.characters(codec=None, exclude_categories=()), max_size=60)
ammunition = st.lists(
    st.sampled_from(
        [*"=+-@;,|\t\"'<>&%:#[] \n\r]1x", "::", "##[", "]]>", "%0A", "\\", "\x1b["]
    ),
    max_size=12,
).map("".join)


def assert_only_text(text: str) -> None:
    """Every reader understands the visible text, and acts on nothing in it."""
    shown = printable(text)
    unspaced = shown.replace(" ", "")
    assert readers.html_reader(escape.for_html(text)) == shown
    assert readers.xml_reader(escape.for_xml(text)) == shown
    assert readers.json_reader(escape.for_json({text: [text]})) == {shown: [shown]}
    assert readers.script_reader(escape.for_script((text,))) == [shown]
    cell = readers.csv_reader(escape.for_csv(text))
    assert cell.replace("'", "") == one_line(text).replace("'", "")
    assert readers.autolab_reader(escape.for_autolab({text: [text]})) == {shown: [shown]}
    line = one_line(text)
    assert readers.markdown_reader(escape.for_markdown(text)) == line
    assert readers.markdown_reader(escape.code_for_markdown(text)) == line
    if len(line) * 8 < FIELD_LIMIT // 2:
        lines = readers.moodle_reader(escape.for_moodle([text, text]))
        assert lines == [line, line]
    for encoding in ("utf-8", "cp1252", "ascii"):
        told = readers.terminal_reader(escape.for_terminal(text, encoding))
        told.encode(encoding)
        coded = unspaced.encode(encoding, "backslashreplace").decode(encoding)
        assert told.replace(" ", "") == coded
    data, title = readers.workflow_reader(
        escape.for_workflow(text), escape.for_workflow_property(text)
    )
    assert data.replace(" ", "") == unspaced
    assert title.replace(" ", "") == unspaced


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_is_only_text_in_every_format(name: str) -> None:
    """One string, all formats."""
    assert_only_text(HOSTILE[name])


@given(anything | ammunition)
def test_any_text_is_only_text_in_every_format(text: str) -> None:
    """Whatever a stranger writes."""
    assert_only_text(text)


@pytest.mark.parametrize("screen", ["56", "color", "cp1252"])
@pytest.mark.parametrize("name", HOSTILE)
def test_a_report_full_of_hostile_text_fits_the_terminal(name: str, screen: str) -> None:
    """Nothing acts, no line is wider than the screen, and none pushes the others away."""
    shown = SCREENS[screen]
    for grade in everywhere(HOSTILE[name]):
        report = STYLE.sub("", printed(grade, shown).decode(shown.encoding))
        readers.terminal_reader(report)
        lines = report.splitlines()
        assert len(lines) < 120
        for line in lines:
            assert cell_len(line) <= shown.width or COMMAND.search(line)


@pytest.mark.parametrize("name", HOSTILE)
def test_a_result_full_of_hostile_text_is_valid(name: str) -> None:
    """It has its shape, and a workflow that prints it hears no command."""
    for grade in everywhere(HOSTILE[name]):
        text = to_text(grade)
        SCHEMA.validate(readers.json_reader(text))
        readers.terminal_reader(text)


@pytest.mark.parametrize("flood", ["x", "\x1b", '"', "\u6f22", "\U0001f468", "word ", "\n"])
def test_a_flood_cannot_make_a_result_large(flood: str) -> None:
    """Thirty checks, all with the longest texts that there are, and no end of messages."""
    grade, _, _ = everywhere(flood * 10_000)
    full = next(score for score in grade.checks if score.examples)
    assert grade.build is not None
    said = grade.build.diagnostics * 100
    many = replace(grade, checks=(full,) * 30, build=replace(grade.build, diagnostics=said))
    written = to_text(many)
    assert len(written.encode()) <= escape.LARGEST_JSON
    kept = readers.json_reader(written)["build"]["diagnostics"]
    assert len(kept) == 42
    assert kept[-1]["text"] == "9,860 more messages of the compiler"


def test_an_ordinary_result_keeps_its_texts_whole() -> None:
    """Only a flood is cut to less than a field's limit."""
    text = "x" * FIELD_LIMIT
    assert readers.json_reader(escape.for_json([text] * 200)) == [text] * 200
    assert len(readers.json_reader(escape.for_json([text] * 300))[0]) <= escape.SHORTER[1]


def test_numbers_of_numpy_are_plain_numbers() -> None:
    """Arithmetic leaves them behind where nobody looks; whole arrays are a mistake of ours."""
    values = [np.float32(1.5), np.int64(3), np.bool_(True), np.float64(0.1), np.uint8(7)]
    assert readers.json_reader(escape.for_json(values)) == [1.5, 3, True, 0.1, 7]
    with pytest.raises(TypeError, match="ndarray"):
        escape.for_json([np.zeros(1)])


@pytest.mark.parametrize("value", [float("nan"), np.float32("nan"), ["x" * 300] * 9_000])
def test_what_json_cannot_carry_is_our_fault(value: object) -> None:
    """It is raised, never written."""
    with pytest.raises(OutputFault):
        escape.for_json(value)


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("=1+1", '"\'=1+1"'),
        ("-2+cmd|' /C calc'!A0", "\"'-2+cmd|' /C calc'!A0\""),
        ("box is (-1, -2.5e-3)", '"box is (-1, -2.5e-3)"'),
        ("-5", '"-5"'),
        ('a";=1', '"a"";\'=1"'),
        ("two\nlines", '"two lines"'),
    ],
)
def test_a_cell_is_guarded_and_numbers_are_not(text: str, cell: str) -> None:
    """A vector in a message stays as it was."""
    assert escape.for_csv(text) == cell


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("expected < -3", '"expected &lt; &#45;3"'),
        ("a < --3", '"a &lt; &#45;&#45;3"'),
        ("-5", '"&#45;5"'),
        ("=1+1", '"&#61;1+1"'),
        ("box is (-1, -2.5e-3)", '"box is (-1, -2.5e-3)"'),
    ],
)
def test_a_formula_in_html_is_broken_and_reads_the_same(text: str, cell: str) -> None:
    """An apostrophe would be read by the student."""
    assert escape.for_moodle([text]) == cell
    assert readers.moodle_reader(cell) == [text]


def test_feedback_that_is_too_long_for_a_cell_loses_whole_lines() -> None:
    """Half an entity, or half of our own line break, would be something else in HTML."""
    lines = readers.moodle_reader(
        escape.for_moodle([f"{n} <b> & {'<' * 90}" for n in range(99)])
    )
    assert lines[-1] == "..."
    assert 5 < len(lines) < 20
    assert lines[0] == f"0 <b> & {'<' * 90}"


@pytest.mark.parametrize(
    "text", ["no member 'BVH::x::y'", "a ## b", "vector::at: 3 >= 3", "operator[]", "a::b::c"]
)
def test_ordinary_code_is_not_changed_in_a_terminal(text: str) -> None:
    """Only what a runner would obey is broken."""
    assert escape.for_terminal(text) == text


def test_the_stand_in_for_the_runner_hears_commands() -> None:
    """Otherwise the tests above would be worth nothing."""
    assert readers.commands(" \u00a0::notice title=a%3A,file=b::c%0A%2525") == [
        ("notice", {"title": "a:", "file": "b"}, "c\n%25")
    ]
    assert len(readers.commands("x ##[error]y\r::group::z\n##vso[a]b\n::a")) == 3


def test_a_narrow_stream_counts_codes_as_wide_as_they_are() -> None:
    """A letter that becomes six characters is wrapped as six."""
    grade = samples.changed(c5=samples.loose_boxes("\u6f22" * 60))
    lines = printed(grade, Screen(encoding="ascii")).decode("ascii").splitlines()
    assert all(len(line) <= 80 or COMMAND.search(line) for line in lines)
    assert "".join(lines).count("\\u6f22") == 60
