"""A teacher's file comes back byte for byte, but for the cells that were changed."""

import codecs

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.errors import UsageError
from grader.gradebook.table import read_table, split, unquoted, written
from tests.gradebook import rules, sheets

SHEETS = [sheets.ENGLISH, sheets.GERMAN, sheets.GRADEBOOK, sheets.CANVAS]
ENCODINGS = [
    (b"", "utf-8"),
    (codecs.BOM_UTF8, "utf-8"),
    (b"", "cp1252"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
]
cells = st.text(st.sampled_from('a",;\t\n\r= é'), max_size=6)


@pytest.mark.parametrize(("mark", "encoding"), ENCODINGS)
@pytest.mark.parametrize("text", SHEETS)
def test_what_is_not_changed_stays(text: str, mark: bytes, encoding: str) -> None:
    """Mark, encoding, delimiter, quotes and line ends, also a last line without an end."""
    data = mark + text.encode(encoding)
    table = read_table(data)
    assert (table.mark, table.encoding) == (mark, encoding)
    assert written(table) == data


@given(st.lists(st.lists(cells, min_size=2, max_size=4), min_size=1, max_size=4))
def test_cells_are_read_as_python_reads_them(rows: list[list[str]]) -> None:
    """Quoted or not, with delimiters and line ends inside of quotes."""
    text = ""
    for row in rows:
        quoted = ['"' + cell.replace('"', '""') + '"' for cell in row]
        text += ";".join(quoted) + "\r\n"
    lines = split(text, ";")
    assert [[unquoted(cell) for cell in line.cells] for line in lines] == rows
    assert rules.read(text.encode(), ";") == rows


def test_one_cell_is_changed_and_no_other() -> None:
    """It keeps its quotes if it had some."""
    table = read_table(b'"a";b\n"x;y";"5";z\n')
    assert table.header == ("a", "b")
    line = table.lines[1].changed(1, "7").changed(4, "new")
    assert line.cells == ('"x;y"', '"7"', "z", "", "new")
    assert table.lines[1].value(0) == "x;y"
    assert table.lines[1].value(9) == ""


@pytest.mark.parametrize(
    ("text", "delimiter"),
    [("a,b;c,d\n", ","), ('"a;b;c","d"\n', ","), ('"a";"b,c,d"\n', ";"), ("a\tb\n", "\t")],
)
def test_the_delimiter_is_the_header_s(text: str, delimiter: str) -> None:
    """What stands within quotes does not count."""
    assert read_table(text.encode()).delimiter == delimiter


@pytest.mark.parametrize(("mark", "encoding"), ENCODINGS)
@pytest.mark.parametrize("told", ["sep=;\r\n", "SEP=;\n", '"sep=;"\n'])
def test_a_line_that_tells_excel_the_delimiter_is_no_row(
    told: str, mark: bytes, encoding: str
) -> None:
    """It stays in its place, and rows are counted as Excel counts them."""
    data = mark + f"{told}email,address;score\nada;5\n".encode(encoding)
    table = read_table(data)
    assert table.header == ("email,address", "score")
    assert table.lines[1].value(1) == "5"
    assert written(table) == data


def test_excel_may_be_told_any_sign() -> None:
    """One that a pattern would act on is only a sign."""
    data = b"sep=|\nemail|score\nada|5\n"
    assert read_table(data).header == ("email", "score")
    assert written(read_table(data)) == data
    with pytest.raises(UsageError, match="line 3: a quote begins"):
        read_table(b'sep=|\nemail|score\n"ada|5\n')


def test_a_header_may_begin_like_a_spreadsheet_or_like_a_line_for_excel() -> None:
    """`PK` is a name, too, and so is `sep=` where nothing follows or more does."""
    assert read_table(b"PK;score\nada;5\n").header == ("PK", "score")
    assert read_table(b"sep=;score\nada;5\n").header == ("sep=", "score")


def test_a_blank_behind_a_quote_stays() -> None:
    """It belongs to the cell, and is nothing that it says."""
    data = b'"email" ,score\n"ada" ,5\n"b ""x"""  ,"6" \n'
    table = read_table(data)
    assert table.header == ("email", "score")
    assert [line.value(0) for line in table.lines[1:]] == ["ada", 'b "x"']
    assert table.lines[2].value(1) == "6"
    assert written(table) == data
    assert table.lines[2].changed(1, "7").cells[1] == '"7"'


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "no text"),
        (b" \n", "no text"),
        (b"PK\x03\x04rest", "save it so"),
        (b"a,b\n1,\x00\n", "no text"),
        (b'a,b\n1,2\n"x,3\n', "line 3: a quote begins"),
        (b'a,b\n"x" y,3\n', "line 2: a quote begins"),
    ],
)
def test_what_is_no_csv_is_refused(data: bytes, said: str) -> None:
    """With the reason, and the line where there is one."""
    with pytest.raises(UsageError, match=said):
        read_table(data)


def test_what_an_encoding_lacks_becomes_its_code() -> None:
    """A worksheet of an old Windows stays one."""
    table = read_table("Größe,b\n1,2\n".encode("cp1252"))
    line = table.lines[1].changed(1, "\u6f22")
    assert written(type(table)(b"", "cp1252", ",", (table.lines[0], line))) == (
        "Größe,b\n1,\\u6f22\n".encode("cp1252")
    )
