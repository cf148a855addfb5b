"""How are random numbers drawn that are the same with every version of every library?

Theory of operation. A number is the hash of its place: splitmix64's last step, in 64-bit
integers that wrap around. What follows uses +, -, *, / and sqrt only, which IEEE 754 rounds
in one way, so that a generated mesh has one hash on all machines.

Source: G. Steele, D. Lea, C. Flood, Fast Splittable Pseudorandom Number Generators, 2014.
"""

import numpy as np
import numpy.typing as npt

from grader.model.mesh import Doubles

Words = npt.NDArray[np.uint64]
GOLDEN = np.uint64(0x9E3779B97F4A7C15)


def drawn(seed: int, stream: int, *shape: int) -> Doubles:
    """Return numbers from 0 to 1, 1 excluded; each stream of a seed has its own.

    Args:
        seed: Of the run.
        stream: Tells what the numbers are for.
        shape: (K, ...) of what is returned, float64.
    """
    place = np.arange(np.prod(shape, dtype=np.int64), dtype=np.uint64).reshape(shape)
    return _unit(_mixed(place + _mixed(_word(stream) + _mixed(_word(seed)))))


def hills(seed: int, stream: int, x: Doubles, y: Doubles) -> Doubles:
    """Return gradient noise at places of the plane: about -0.7 to 0.7, 0 where both are whole.

    Args:
        seed: Of the run.
        stream: Tells what the noise is for.
        x: (K, ...) float64, as are `y` and what is returned.
        y: The other coordinate.

    Source: K. Perlin, Improving Noise, SIGGRAPH 2002, with gradients from a hash.
    """
    left, low = np.floor(x), np.floor(y)
    u, v = x - left, y - low
    across, up = _eased(u), _eased(v)
    corners = [
        [_slope(seed, stream, (left + i, low + j), (u - i, v - j)) for i in (0, 1)]
        for j in (0, 1)
    ]
    below = corners[0][0] + across * (corners[0][1] - corners[0][0])
    above = corners[1][0] + across * (corners[1][1] - corners[1][0])
    return below + up * (above - below)


def _slope(
    seed: int, stream: int, corner: tuple[Doubles, Doubles], off: tuple[Doubles, Doubles]
) -> Doubles:
    """Return the height at an offset from a corner of the lattice, by its gradient."""
    column, row = (each.astype(np.int64).astype(np.uint64) for each in corner)
    word = _mixed(column + _mixed(row + _mixed(_word(stream) + _mixed(_word(seed)))))
    gx, gy = 2 * _unit(word) - 1, 2 * _unit(_mixed(word)) - 1
    return gx * off[0] + gy * off[1]


def _eased(t: Doubles) -> Doubles:
    """Go from 0 to 1 without a kink: 6 t^5 - 15 t^4 + 10 t^3."""
    return t * t * t * (t * (t * 6 - 15) + 10)


def _word(number: int) -> Words:
    """Return (1,) uint64; arrays wrap around in silence, numpy's scalars warn."""
    return np.array([number], dtype=np.uint64)


def _mixed(words: Words) -> Words:
    """Hash 64-bit words."""
    words = words + GOLDEN
    words = (words ^ (words >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return words ^ (words >> np.uint64(31))


def _unit(words: Words) -> Doubles:
    """Turn words into numbers from 0 to 1."""
    return (words >> np.uint64(11)).astype(np.float64) * 2.0**-53
