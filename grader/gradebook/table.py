"""How is a teacher's CSV file changed without touching what is not ours?

Each cell keeps the characters it was read from, and the file its mark at the beginning, its
encoding, its delimiter and its line ends. What is written back differs in changed cells only.
"""

import codecs
import re
from dataclasses import dataclass, replace

from grader.errors import UsageError

DELIMITERS = (",", ";", "\t")

MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)

_TOLD = re.compile(r'"?sep=([^"\r\n])"?(?:\r\n|\n|\r)(?=.)', re.IGNORECASE | re.DOTALL)
"""A first line that tells Excel the delimiter, and is no row."""


@dataclass(frozen=True, slots=True)
class Line:
    """One row: its cells as they are written, and how the line ends."""

    cells: tuple[str, ...]
    end: str

    def value(self, column: int) -> str:
        """Return what a cell says, without its quotes; empty if the row is too short."""
        return unquoted(self.cells[column]) if column < len(self.cells) else ""

    def changed(self, column: int, cell: str) -> "Line":
        """Return this row with another cell, as it is to be written."""
        missing = ("",) * (column + 1 - len(self.cells))
        cells = [*self.cells, *missing]
        quoted = cells[column].startswith('"')
        cells[column] = f'"{cell}"' if quoted and not cell.startswith('"') else cell
        return replace(self, cells=tuple(cells))


@dataclass(frozen=True, slots=True)
class Table:
    """A whole file."""

    mark: bytes
    """What stands before the header: the encoding's mark, and a line for Excel."""

    encoding: str
    delimiter: str
    lines: tuple[Line, ...]

    @property
    def header(self) -> tuple[str, ...]:
        """Names of the columns."""
        return tuple(unquoted(cell).strip() for cell in self.lines[0].cells)


def unquoted(cell: str) -> str:
    """Read a cell."""
    # Some write a blank behind the quote.
    return cell.rstrip(" ")[1:-1].replace('""', '"') if cell.startswith('"') else cell


def read_table(data: bytes) -> Table:
    """Take a file apart.

    Raises:
        UsageError: It is no CSV.
    """
    mark, encoding, text = decoded(data)
    if told := _TOLD.match(text):
        mark += told[0].encode(encoding)
        return Table(mark, encoding, told[1], tuple(split(text, told[1], start=told.end())))
    delimiter = max(DELIMITERS, key=lambda sign: columns_of(text, sign))
    return Table(mark, encoding, delimiter, tuple(split(text, delimiter)))


def columns_of(text: str, delimiter: str) -> int:
    """Count the cells of the first line; none if it cannot be split like this."""
    try:
        return len(split(text, delimiter, most=1)[0].cells)
    except UsageError:
        return 0


def decoded(data: bytes) -> tuple[bytes, str, str]:
    """Find the encoding of a file: what its mark says, else UTF-8, else that of old Windows.

    Returns:
        The mark, the name of the encoding, and the text behind the mark.

    Raises:
        UsageError: It is a spreadsheet's own format, no text, or empty.
    """
    if data.startswith(b"PK\x03\x04"):
        raise UsageError("this is a spreadsheet's own format, but CSV is read here: save it so")
    mark, known = next(((m, e) for m, e in MARKS if data.startswith(m)), (b"", ""))
    for encoding in [known] if known else ["utf-8", "cp1252"]:
        try:
            text = data[len(mark) :].decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text and text.strip():
            return mark, encoding, text
    raise UsageError("this is no text, or there is nothing in it, but CSV is read here")


def split(text: str, delimiter: str, most: int = 0, start: int = 0) -> list[Line]:
    """Split a text into lines of cells.

    Args:
        text: The file's.
        delimiter: Between two cells.
        most: Lines that are wanted; 0 for all.
        start: Where the first of them begins.

    Raises:
        UsageError: A cell does not end where its quotes do.
    """
    sign = re.escape(delimiter)
    cell = re.compile(
        rf'("(?:[^"]|"")*+" *|[^"{sign}\r\n][^{sign}\r\n]*+|)({sign}|\r\n|\n|\r|\Z)'
    )
    lines: list[Line] = []
    cells: list[str] = []
    place = start
    while place < len(text) or cells:
        found = cell.match(text, place)
        if found is None:
            number = text.count("\n", 0, place) + 1
            raise UsageError(f"line {number}: a quote begins that does not end with its cell")
        cells.append(found[1])
        place = found.end()
        if found[2] != delimiter:
            lines.append(Line(tuple(cells), found[2]))
            cells = []
            if len(lines) == most:
                break
    return lines


def written(table: Table) -> bytes:
    """Put a file together again; what its encoding lacks is written as its code."""
    text = "".join(table.delimiter.join(line.cells) + line.end for line in table.lines)
    return table.mark + text.encode(table.encoding, "backslashreplace")
