"""What does an OBJ file hold? Its vertices and faces, or which line is wrong and why.

The grader reads OBJ itself, by the rules and with the messages of
`student_stub/preview/obj.cpp`, since trimesh (5.2.0) makes another mesh of some files without a
word: it counts negative numbers from the end of the file, takes 0 for 1 and drops faces of two
corners. Nor does it name a line.
"""

from array import array
from collections.abc import Sequence
from itertools import chain, pairwise
from math import isfinite, nan
from pathlib import Path
from typing import NoReturn

import numpy as np

from grader.errors import UsageError
from grader.model.mesh import Doubles, Integers
from grader.plain import as_name

SHOWN = 40
"""Characters of a wrong word that a message shows."""


def read_obj(path: Path) -> tuple[Doubles, Integers]:
    """Read the vertices of an OBJ file, and its polygons as fans of triangles.

    Bytes that are not UTF-8 stand in comments and names, which nobody needs.

    Returns:
        (V, 3) float64, finite, in the file's space; and (F, 3) int64, each in [0, V).

    Raises:
        UsageError: A vertex or a face is wrong; the message names its line.
        OSError: The file cannot be read.
    """
    reader = _Reader(path)
    with path.open(encoding="utf-8-sig", errors="replace") as lines:
        # The empty one ends a file whose last line ends with a backslash.
        for number, line in enumerate(chain(lines, ("",)), start=1):
            reader.read_line(number, line)
    return reader.arrays()


class _Reader:
    """What was read so far, and which line is being read."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._line = 0
        self._begun = ""
        self._coordinates = array("d")
        self._corners = array("q")

    def read_line(self, number: int, line: str) -> None:
        """Take one line; a backslash at its end joins it with the next one."""
        self._line = number
        line = self._begun + line.partition("#")[0].rstrip()
        if line.endswith("\\"):
            self._begun = line[:-1] + " "
            return
        self._begun = ""
        keyword, *words = line.split() or [""]
        if keyword == "v":
            self._coordinates.extend(self._vertex(words))
        elif keyword == "f":
            self._add_face([self._corner(word) for word in words])

    def arrays(self) -> tuple[Doubles, Integers]:
        """Return vertices and faces."""
        vertices = np.array(self._coordinates, np.float64).reshape(-1, 3)
        return vertices, np.array(self._corners, np.int64).reshape(-1, 3)

    def _vertex(self, words: Sequence[str]) -> list[float]:
        """Read three coordinates; a weight or a colour may follow."""
        numbers = []
        for axis in range(3):
            word = words[axis] if axis < len(words) else ""
            try:
                numbers.append(float(word))
            except ValueError:
                numbers.append(nan)
            if not isfinite(numbers[axis]):
                self._fail(
                    f"coordinate {axis + 1} is '{as_name(word, SHOWN)}', "
                    "but three finite numbers are expected after 'v'"
                )
        return numbers

    def _corner(self, word: str) -> int:
        """Read `v`, `v/vt`, `v//vn` or `v/vt/vn`; -1 is the last vertex above the line."""
        try:
            number = int(word.partition("/")[0])
        except ValueError:
            number = 0
        if number == 0:
            self._fail(
                f"corner is '{as_name(word, SHOWN)}', "
                "but a vertex number like 1, -1 or 1/2/3 is expected"
            )
        known = len(self._coordinates) // 3
        index = number - 1 if number > 0 else known + number
        if not 0 <= index < known:
            given = "1 vertex is" if known == 1 else f"{known} vertices are"
            self._fail(
                f"face uses vertex {as_name(word, SHOWN)}, but {given} given above this line"
            )
        return index

    def _add_face(self, corners: Sequence[int]) -> None:
        """Cut a polygon into a fan of triangles around its first corner."""
        if len(corners) < 3:
            has = "1 corner" if len(corners) == 1 else f"{len(corners)} corners"
            self._fail(f"face has {has}, but at least 3 are expected")
        for second, third in pairwise(corners[1:]):
            self._corners.extend((corners[0], second, third))

    def _fail(self, message: str) -> NoReturn:
        raise UsageError(f"{self._path}:{self._line}: {message}")
