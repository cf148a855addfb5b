"""How does a terminal draw a small tree? Nodes above, face indices below, as the sheet does."""

from typing import TYPE_CHECKING

from grader.language import Words
from grader.report.sheet import LABEL_WIDTH, Sheet

if TYPE_CHECKING:
    from grader.model.counterexample import Column, NodeTable

GUTTER = LABEL_WIDTH + 6
"""Cells before the first column."""

GAP = 1
LABELS = ("node", "expected", "got")
MARK = "^"


def node_table(sheet: Sheet, table: "NodeTable") -> None:
    """Write a table beside the gutter: one column a node, expected above got.

    The first difference is marked; columns that do not fit go on below.
    """
    told = [words(one, sheet.told) for one in table.columns]
    width = max((len(word) for one in told for word in one), default=1) + GAP
    fit = max(1, (sheet.width - GUTTER) // width)
    for begin in range(0, len(told), fit):
        columns = told[begin : begin + fit]
        marked = table.first_difference - begin
        for label, row in zip(LABELS, zip(*columns, strict=True), strict=True):
            _row(sheet, label, [word.ljust(width) for word in row], marked)
        if 0 <= marked < len(columns):
            _row(sheet, "", [" " * width] * marked + [MARK], marked)
    _faces(sheet, table)


def words(column: "Column", told: Words) -> tuple[str, str, str]:
    """What stands in one column, from top to bottom; what is words in it is told."""
    return str(column.node), told(column.expected), told(column.got)


def _row(sheet: Sheet, label: str, cells: list[str], marked: int) -> None:
    line = sheet.gutter(label)
    for place, cell in enumerate(cells):
        line.append(cell, "bold red" if place == marked else "")
    line.rstrip()
    sheet.lines.append(line)


def _faces(sheet: Sheet, table: "NodeTable") -> None:
    if table.got_faces:
        sheet.beside("expected", f"faceIndices  {table.expected_faces}", "green")
        sheet.beside("got", f"faceIndices  {table.got_faces}", "red")
    else:
        sheet.beside("", f"faceIndices  {table.expected_faces}")
