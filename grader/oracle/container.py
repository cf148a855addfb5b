"""How do records and their arrays lie in one file, so that reading it costs one read?

Theory of operation. A file is a hash of all that follows, the length of an index, the index in
JSON, and the arrays, each at a multiple of 64 bytes. The index lists arrays by type, shape and
place, then records by kind and fields, each after those that it holds. What occurs twice is
stored once and comes back as one object, so trials that share a mesh go on sharing it. Arrays
come back as views of the bytes that were read. Only the kinds of records that are listed here
come back, and nothing in a file is ever run.
"""

import json
from collections.abc import Sequence
from dataclasses import fields
from typing import Any, get_args

import numpy as np
import numpy.typing as npt

from grader.model.mesh import Answers, Bvh, Bytes, Mesh, Rays
from grader.model.scene import Reference
from grader.model.trials import Trial
from grader.oracle.hashed import DIGEST, Piece, hashed, unbroken

KINDS = (Mesh, Rays, Bvh, Answers, Reference, *get_args(Trial))
RECORDS = {kind.__name__: kind for kind in KINDS}
ALIGNMENT = 64
LENGTH = 8
"""Bytes of the length of the index."""


def sealed(value: object) -> list[Piece]:
    """Turn records, arrays, plain values and tuples of them into the pieces of a file."""
    index = _Index()
    whole = index.entry(value)
    text = json.dumps([index.places, index.records, whole]).encode()
    pieces: list[Piece] = [len(text).to_bytes(LENGTH, "little"), text]
    pieces.append(bytes(-(DIGEST + LENGTH + len(text)) % ALIGNMENT))
    for array in index.arrays:
        pieces += [array.reshape(-1).view(np.uint8).data, bytes(-array.nbytes % ALIGNMENT)]
    return hashed(pieces)


def unsealed(content: Bytes) -> Any:  # noqa: ANN401 - whatever was sealed
    """Return what was sealed; None if the bytes are not whole.

    Args:
        content: (n,) uint8, the file; nobody may write to it any more.
    """
    if unbroken(content.data) is None:
        return None
    body = content[DIGEST:]
    content.setflags(write=False)
    length = int.from_bytes(body[:LENGTH].tobytes(), "little")
    places, records, whole = json.loads(body[LENGTH : LENGTH + length].tobytes())
    first = DIGEST + LENGTH + length
    back = _Back(_views(content[first + -first % ALIGNMENT :], places))
    for kind, given in records:
        back.add(kind, given)
    return back.value(whole)


class _Index:
    """Numbers arrays and records in the order in which they are met."""

    def __init__(self) -> None:
        self.arrays: list[npt.NDArray[Any]] = []
        self.places: list[tuple[str, Sequence[int], int]] = []
        """Type and shape of each array, and where it begins, counted from the first one."""

        self.records: list[tuple[str, dict[str, object]]] = []
        self._end = 0
        self._known: dict[int, dict[str, int]] = {}

    def entry(self, value: Any) -> object:  # noqa: ANN401 - any of RECORDS, or in them
        """Return what stands for a value in the index."""
        if isinstance(value, tuple):
            return [self.entry(each) for each in value]
        if isinstance(value, str | bool | int | float):
            return value
        if id(value) not in self._known:
            array = isinstance(value, np.ndarray)
            self._known[id(value)] = self._array(value) if array else self._record(value)
        return self._known[id(value)]

    def _array(self, array: npt.NDArray[Any]) -> dict[str, int]:
        self.places.append((array.dtype.str, array.shape, self._end))
        self.arrays.append(np.ascontiguousarray(array))
        self._end += array.nbytes + -array.nbytes % ALIGNMENT
        return {"array": len(self.arrays) - 1}

    def _record(self, record: Any) -> dict[str, int]:  # noqa: ANN401 - as above
        kind = RECORDS[type(record).__name__]
        given = {one.name: self.entry(getattr(record, one.name)) for one in fields(kind)}
        self.records.append((kind.__name__, given))
        return {"record": len(self.records) - 1}


def _views(content: Bytes, places: Sequence[tuple[str, Sequence[int], int]]) -> list[Any]:
    """Cut the arrays out of what follows the index."""
    views = []
    for name, shape, begin in places:
        dtype = np.dtype(name)
        size = int(np.prod(shape, dtype=np.int64)) * dtype.itemsize
        views.append(content[begin : begin + size].view(dtype).reshape(shape))
    return views


class _Back:
    """Makes values of what stands for them in an index."""

    def __init__(self, arrays: Sequence[Any]) -> None:
        self._arrays = arrays
        self._records: list[object] = []

    def add(self, kind: str, given: dict[str, Any]) -> None:
        """Make the next record."""
        made = {name: self.value(entry) for name, entry in given.items()}
        self._records.append(RECORDS[kind](**made))

    def value(self, entry: Any) -> Any:  # noqa: ANN401 - as JSON gives it
        """Return the value of an entry."""
        if isinstance(entry, list):
            return tuple(self.value(each) for each in entry)
        if not isinstance(entry, dict):
            return entry
        ((kind, number),) = entry.items()
        return self._arrays[number] if kind == "array" else self._records[number]
