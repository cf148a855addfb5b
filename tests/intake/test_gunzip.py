"""Tests of grader/intake/gunzip.py."""

import gzip
import io
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.intake.candidates import Damage
from grader.intake.gunzip import GZIP_MARK, MOST_MEMBERS, MOST_OVERHEAD, Gunzip

PLENTY = 2**24
HEADER = GZIP_MARK + b"\x08\x08" + bytes(6)
"""What a gzip stream begins with if the name of a file follows."""


def unpacked(content: bytes, most: int = PLENTY) -> bytes:
    """Everything that comes out."""
    return io.BufferedReader(Gunzip(io.BytesIO(content), most)).read()


@given(st.lists(st.binary(max_size=2000), min_size=1, max_size=5), st.integers(1, 3000))
def test_it_unpacks_as_the_standard_library_does(parts: list[bytes], size: int) -> None:
    """Also several streams in a row, and read in pieces of any size."""
    content = b"".join(gzip.compress(part) for part in parts)
    reader = io.BufferedReader(Gunzip(io.BytesIO(content), PLENTY))
    pieces = []
    while piece := reader.read(size):
        pieces.append(piece)
    assert b"".join(pieces) == gzip.decompress(content)
    assert {len(piece) for piece in pieces[:-1]} <= {size}


@pytest.mark.parametrize("rest", [b"", bytes(1000), b"\x1f", b"anything", bytes(2**20)])
def test_what_follows_the_stream_is_left_alone(rest: bytes) -> None:
    """Some programs fill a file up."""
    assert unpacked(gzip.compress(b"code", mtime=0) + rest) == b"code"


@given(st.binary(max_size=300), st.data())
def test_a_cut_stream_is_damage(content: bytes, data: st.DataObject) -> None:
    """Wherever it is cut, it does not look as if it were whole."""
    packed = gzip.compress(content)
    with pytest.raises(Damage):
        unpacked(packed[: data.draw(st.integers(0, len(packed) - 1))])


def test_it_ends_where_too_much_has_come_out() -> None:
    """Exactly the most is given, and not one byte more."""
    packed = gzip.compress(bytes(PLENTY))
    assert len(unpacked(packed)) == PLENTY
    with pytest.raises(Damage, match="unpacks to more than 15 MiB"):
        unpacked(packed, PLENTY - 1)


@pytest.mark.parametrize(
    "content",
    [
        gzip.compress(b"", mtime=0) * (MOST_MEMBERS + 1),
        HEADER + b"a" * 2 * MOST_OVERHEAD,
        HEADER + b"a" * 2 * MOST_OVERHEAD + b"\0" + gzip.compress(b"", mtime=0)[10:],
        HEADER + b"\0" + b"\0\0\0\xff\xff" * MOST_OVERHEAD,
        HEADER + b"\0" + b"\x07",
        GZIP_MARK + b"\x09" + bytes(20),
        gzip.compress(b"code", mtime=0)[:-8] + bytes(8),
    ],
)
def test_what_gives_nothing_ends_at_once(content: bytes) -> None:
    """Empty streams, endless names and empty blocks, which kept Python's reader busy."""
    started = time.process_time()
    with pytest.raises(Damage):
        unpacked(content)
    assert time.process_time() - started < 1


def test_some_streams_in_a_row_are_one() -> None:
    """`cat a.gz b.gz` is a gzip file."""
    assert unpacked(gzip.compress(b"x", mtime=0) * MOST_MEMBERS) == b"x" * MOST_MEMBERS
