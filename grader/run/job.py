"""How a worker's input and result files are laid out, filled and read.

Both are memfds. The input is sealed against every change; the result is sealed against
resizing, so a worker that truncates it cannot make the grader's mapping fault. The result is
sparse: only pages that the worker wrote cost memory.
"""

import errno
import fcntl
import mmap
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import numpy.typing as npt

from grader.errors import WorkerFault
from grader.run.protocol import DATA_OFFSET, HEADER, MAGIC, ROW, VERSION

ALIGNMENT = 64
SEAL_SIZE = fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SEAL
SEAL_ALL = SEAL_SIZE | fcntl.F_SEAL_WRITE

MOST_SEALINGS = 60
"""Attempts, each of which waits by itself: together some 10 s."""


class Job:
    """What one worker shall do: rows, input arrays and reserved room for results."""

    def __init__(self) -> None:
        self._arrays: list[tuple[int, npt.NDArray[Any]]] = []
        self._rows: list[bytes] = []
        self._slots = 0
        self._given_size = ROW.size
        self._result_size = DATA_OFFSET

    def give(self, array: npt.NDArray[Any]) -> int:
        """Put an array of any shape (...) and dtype into the input; returns its offset."""
        offset = self._given_size
        self._arrays.append((offset, np.ascontiguousarray(array)))
        self._given_size += -(-array.nbytes // ALIGNMENT) * ALIGNMENT
        return offset

    def reserve(self, size: int) -> int:
        """Reserve bytes in the result; returns their offset."""
        offset = self._result_size
        self._result_size += -(-max(size, 1) // ALIGNMENT) * ALIGNMENT
        return offset

    def do(self, op: int, *arguments: int) -> None:
        """Append an operation that makes no slot."""
        self._rows.append(ROW.pack(op, *arguments, *[0] * (7 - len(arguments))))

    def make(self, op: int, *arguments: int) -> int:
        """Append an operation that makes a slot; returns the slot."""
        self.do(op, *arguments)
        self._slots += 1
        return self._slots - 1

    @property
    def row_count(self) -> int:
        """How many operations a worker has to finish."""
        return len(self._rows)

    @property
    def result_size(self) -> int:
        """Bytes of the result file."""
        return self._result_size

    @contextmanager
    def files(self) -> Iterator[tuple[int, int]]:
        """Descriptors of the sealed input and of the empty result."""
        given = os.memfd_create("given", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        result = os.memfd_create("result", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        try:
            self._fill(given)
            _seal(given, SEAL_ALL)
            os.ftruncate(result, self._result_size)
            _seal(result, SEAL_SIZE)
            yield given, result
        finally:
            os.close(given)
            os.close(result)

    def _fill(self, given: int) -> None:
        rows = b"".join(self._rows)
        first = self._given_size
        os.ftruncate(given, first + len(rows))
        os.pwrite(given, HEADER.pack(MAGIC, VERSION, first, len(self._rows), 0, 0, 0, 0), 0)
        _write(given, rows, first)
        for offset, array in self._arrays:
            if array.nbytes:
                _write(given, array.reshape(-1).view(np.uint8).data, offset)


def _seal(descriptor: int, seals: int) -> None:
    """Seal a file that nobody has mapped.

    Against writing, Linux refuses to seal a file while anything else holds one of its pages; on
    a busy machine that may be the kernel itself, which moves pages about. It waits 0.15 s for
    their release (`memfd_wait_for_pins` in mm/memfd.c), which was once too short.
    """
    for _ in range(MOST_SEALINGS):
        try:
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, seals)
        except OSError as error:
            if error.errno != errno.EBUSY:
                raise
        else:
            return
    raise WorkerFault("the input of a worker could not be sealed: the kernel holds its pages")


def _write(descriptor: int, data: bytes | memoryview, offset: int) -> None:
    """Write all of it: one call moves at most 2 GiB."""
    view = memoryview(data)
    while view:
        try:
            written = os.pwrite(descriptor, view, offset)
        except OSError as error:
            message = f"the input of a worker could not be written: {error.strerror}"
            raise WorkerFault(message) from error
        view, offset = view[written:], offset + written


class Result:
    """What a dead worker left: the bounds are ours, the content is the submission's."""

    def __init__(self, descriptor: int, size: int) -> None:
        self._memory = mmap.mmap(descriptor, size, prot=mmap.PROT_READ)

    def array(self, offset: int, count: int, dtype: type[np.generic]) -> npt.NDArray[Any]:
        """Copy of the `count` items at a reserved offset: (count,) of `dtype`."""
        return np.frombuffer(self._memory, dtype, count, offset).copy()

    def number(self, offset: int) -> int:
        """One 64-bit number."""
        return int(np.frombuffer(self._memory, np.uint64, 1, offset)[0])

    def text(self, offset: int, size: int) -> bytes:
        """Bytes of a text field."""
        return bytes(self._memory[offset : offset + size])
