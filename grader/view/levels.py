"""How is a picture divided into blocks, and how does one ray paint a whole block?"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import numpy.typing as npt

BLOCKS = (16, 4, 1)
"""Sides of the blocks, in pixels."""

Kind = TypeVar("Kind", bound=np.generic)


@dataclass(frozen=True, slots=True)
class Level:
    """All blocks of one size."""

    block: int
    first: int
    """Place of its first ray in the turn."""

    columns: int
    rows: int

    @property
    def past(self) -> int:
        """Place behind its last ray."""
        return self.first + self.columns * self.rows

    def paint(self, whole: npt.NDArray[Kind], values: npt.NDArray[Kind], first: int) -> None:
        """Paint blocks.

        Args:
            whole: (H, W) of the same dtype as `values`, the picture.
            values: (K,) of any dtype, one for each block.
            first: Place of the first ray.
        """
        begin, block, width = first - self.first, self.block, whole.shape[1]
        if block == 1:
            whole.reshape(-1)[begin : begin + len(values)] = values
            return
        for row, left, right in _rows(begin, begin + len(values), self.columns):
            at = row * self.columns - begin
            line = np.repeat(values[at + left : at + right], block)[: width - left * block]
            whole[row * block : (row + 1) * block, left * block : right * block] = line


def levels_of(width: int, height: int) -> tuple[Level, ...]:
    """Divide a picture."""
    found, first = [], 0
    for block in BLOCKS:
        level = Level(block, first, -(-width // block), -(-height // block))
        found.append(level)
        first = level.past
    return tuple(found)


def _rows(first: int, past: int, columns: int) -> list[tuple[int, int, int]]:
    """Divide places into rows: each with its first and past column."""
    found = []
    for row in range(first // columns, (past - 1) // columns + 1):
        begin = max(first - row * columns, 0)
        found.append((row, begin, min(past - row * columns, columns)))
    return found
