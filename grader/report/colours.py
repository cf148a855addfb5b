"""Which colour does a number get? Two scales of 256 colours, from dark to bright.

Both are interpolated between a few colours of scales that grow evenly in lightness and that
people who do not tell red from green can read.
Source of the colours: S. van der Walt, N. Smith, `magma` and `viridis`, 2015 (CC0).
"""

import numpy as np

from grader.model.mesh import Bytes


def _scale(colours: str) -> Bytes:
    """Return (256, 3) uint8 from colours in hexadecimal, evenly spaced."""
    known = np.array([list(bytes.fromhex(colour)) for colour in colours.split()], np.float64)
    place = np.linspace(0, len(known) - 1, 256)
    columns = [np.interp(place, np.arange(len(known)), known[:, axis]) for axis in range(3)]
    table = np.rint(np.stack(columns, axis=1)).astype(np.uint8)
    table.setflags(write=False)
    return table


MAGMA = _scale("000004 180f3e 451077 721f81 9f2f7f cd4071 f1605d fd9567 feca8d fcfdbf")
"""Of differences: black says that there is none."""

HEAT = _scale("440154 482878 3e4a89 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725")
"""Of costs."""
