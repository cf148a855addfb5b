"""The page of documentation and its chart are made from the table alone."""

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image

from grader.bench.chart import chart_of, share_of_bound
from grader.bench.document import markdown_of, write
from grader.bench.drawing import SHARPNESS, svg_of
from tests.bench.tables import READINGS, TABLE

SVG = "{http://www.w3.org/2000/svg}"


def test_three_files_are_written(tmp_path: Path) -> None:
    """The picture has the size of the drawing, twice as sharp."""
    text, svg, png = write(tmp_path, TABLE)
    assert text.read_text() == markdown_of(TABLE)
    drawing = chart_of(TABLE)
    with Image.open(png) as picture:
        assert picture.size == (SHARPNESS * drawing.width, SHARPNESS * drawing.height)
    root = ElementTree.fromstring(svg.read_text())  # noqa: S314 - our own output
    assert root.tag == f"{SVG}svg"


def test_every_missed_goal_has_a_reason() -> None:
    """And no other one is excused."""
    page = markdown_of(TABLE)
    excuses = [line for line in page.splitlines() if line.startswith("- **")]
    assert [line.split("**")[1] for line in excuses] == ["1", "3", "6b"]


def test_a_reason_that_was_measured_is_the_one_that_is_told() -> None:
    """Not what somebody found by hand once."""
    assert "- **3**: of 0.9 s all is Python.\n" in markdown_of(TABLE)


def test_the_distance_from_the_floor_is_told() -> None:
    """Two measured times, and their ratio; nothing if they were not measured."""
    told = "on 2 cores that\nare never idle: 2.50 s. The program takes 6.00 s, 2.40 times that."
    assert told in markdown_of(TABLE)
    assert "The floor" not in markdown_of(replace(TABLE, floor=None))


def test_tables_have_as_many_cells_as_their_head() -> None:
    """GitHub drops what is too much."""
    for block in markdown_of(TABLE).split("\n\n"):
        rows = [line for line in block.splitlines() if line.startswith("|")]
        assert len({row.count("|") for row in rows}) <= 1, block


def test_a_quick_run_says_so() -> None:
    """Its numbers are not to be quoted."""
    assert "A quick run" in markdown_of(replace(TABLE, is_quick=True))
    assert "A quick run" not in markdown_of(TABLE)


def test_shorter_bars_are_better() -> None:
    """Whichever way a ratio counts."""
    wall, _, check, camera, _ = READINGS
    assert share_of_bound(wall) == pytest.approx(1.2 / 1.1)
    assert share_of_bound(check) == pytest.approx(0.5)
    assert share_of_bound(camera) == pytest.approx(1.2)


def test_nothing_is_drawn_outside() -> None:
    """Every shape lies on the paper."""
    drawing = chart_of(TABLE)
    root = ElementTree.fromstring(svg_of(drawing))  # noqa: S314 - our own output
    for element in root.iter():
        for name, most in (("x", drawing.width), ("cx", drawing.width), ("cy", drawing.height)):
            assert 0 <= float(element.get(name, 0)) <= most


def test_texts_are_escaped() -> None:
    """A name may hold what XML means something by."""
    drawing = replace(chart_of(TABLE), title="<a> & b")
    assert "&lt;a&gt; &amp; b" in svg_of(drawing)
