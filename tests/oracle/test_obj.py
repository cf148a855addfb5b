"""An OBJ file is read by the rules of the preview, and its first wrong line is named."""

from pathlib import Path

import numpy as np
import pytest

from grader.errors import UsageError
from grader.oracle.obj import read_obj

CORNERS = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\n"


def written(folder: Path, content: str | bytes) -> Path:
    """Write a file."""
    content = content.encode() if isinstance(content, str) else content
    (folder / "model.obj").write_bytes(content)
    return folder / "model.obj"


@pytest.mark.parametrize(
    "faces",
    [
        "f 1 2 3 4\n",
        "f 1/7 2/8 3/9 4/9\n",
        "f 1//7 2//8 3//9 4//9\n",
        "f 1/2/3 2/3/4 3/4/5 4/5/6 # a quad\n",
        "f -4 -3 -2 -1\n",
        "  f\t1 2 \\\n  3 4\r\n",
        "f 1 2 3 4 \\",
        "g one\nusemtl none\nvn 0 0 1\nvt 0 0\nf 1 2 3 4",
    ],
)
def test_a_polygon_is_a_fan_of_triangles(tmp_path: Path, faces: str) -> None:
    """However its corners are written, and whatever else the file holds."""
    vertices, read = read_obj(written(tmp_path, CORNERS + faces))
    assert vertices.dtype == np.float64
    assert read.dtype == np.int64
    assert vertices.tolist() == [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]]
    assert read.tolist() == [[0, 1, 2], [0, 2, 3]]


def test_negative_numbers_count_from_the_line_they_stand_on(tmp_path: Path) -> None:
    """Not from the end of the file."""
    part = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\n"
    assert read_obj(written(tmp_path, 2 * part))[1].tolist() == [[0, 1, 2], [3, 4, 5]]


def test_weights_colours_and_marks_are_passed_over(tmp_path: Path) -> None:
    """A vertex may have more than three numbers, and a file begin with a mark of UTF-8."""
    content = b"\xef\xbb\xbfv 0 0 0 1\r\nv 1 0 0 0.5 0.5 0.5 # \xf6\r\nv 0 1 +2.5e-1\r\nf 1 2 3"
    vertices, faces = read_obj(written(tmp_path, content))
    assert vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0.25]]
    assert faces.tolist() == [[0, 1, 2]]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("v 1 2", "coordinate 3 is '', but three finite numbers are expected after 'v'"),
        ("v", "coordinate 1 is ''"),
        ("v 1 x 3", "coordinate 2 is 'x'"),
        ("v 1 nan 3", "coordinate 2 is 'nan'"),
        ("v 1 2 1e999", "coordinate 3 is '1e999'"),
        ("v \x1b[2J 0 0", "coordinate 1 is '\\x1b[2J'"),
        ("f 1 2 9", "face uses vertex 9, but 4 vertices are given above this line"),
        ("f 1 2/3 9/4", "face uses vertex 9/4, but 4 vertices are given above this line"),
        ("f 1 2 -5", "face uses vertex -5, but 4 vertices are given"),
        ("f 0 1 2", "corner is '0', but a vertex number like 1, -1 or 1/2/3 is expected"),
        ("f 1 2 x", "corner is 'x'"),
        ("f 1 2 /3", "corner is '/3'"),
        ("f 1 2 " + 5000 * "9", "corner is '9999"),
        ("f 1 2", "face has 2 corners, but at least 3 are expected"),
        ("f 1", "face has 1 corner, but"),
    ],
)
def test_a_wrong_line_is_told(tmp_path: Path, line: str, expected: str) -> None:
    """Which one, what is there, and what instead; never more than a little of it."""
    path = written(tmp_path, CORNERS + "# it follows\n" + line + "\nf 1 2 3\n")
    with pytest.raises(UsageError) as caught:
        read_obj(path)
    assert str(caught.value).startswith(f"{path}:6: {expected}")
    assert len(str(caught.value)) < len(str(path)) + 150


def test_one_vertex_is_not_many(tmp_path: Path) -> None:
    """A face that stands too early is told how much is there."""
    with pytest.raises(UsageError, match=":2: face uses vertex 2, but 1 vertex is given above"):
        read_obj(written(tmp_path, "v 0 0 0\nf 1 2 3\nv 1 0 0\nv 0 1 0\n"))
