"""How the two files of a worker are laid out, sealed and read."""

import ctypes
import errno
import fcntl
import mmap
import os
import re
import struct
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest

from grader import resources
from grader.errors import WorkerFault
from grader.run import abi, protocol
from grader.run.job import Job, Result
from grader.run.protocol import DATA_OFFSET, ERROR_CAPACITY, ERROR_OFFSET, HEADER, ROW, Op


def words(descriptor: int, offset: int, count: int = 8) -> tuple[int, ...]:
    """Read 64-bit numbers of a file."""
    return struct.unpack(f"<{count}Q", os.pread(descriptor, 8 * count, offset))


def test_the_input_begins_with_a_header_and_ends_with_rows() -> None:
    """Arrays lie where they were promised, rows in the order in which they were added."""
    job = Job()
    first = job.give(np.arange(5, dtype=np.uint32))
    second = job.give(np.arange(6, dtype=np.float32).reshape(2, 3)[:, ::-1])
    assert job.make(Op.MESH, first, 5, second, 2) == 0
    assert job.make(Op.TREE) == 1
    job.do(Op.CONSTRUCT, 1, 0)
    with job.files() as (given, _):
        magic, version, rows, count, *_ = words(given, 0)
        assert (magic, version, count) == (protocol.MAGIC, protocol.VERSION, 3)
        assert words(given, rows) == (Op.MESH, first, 5, second, 2, 0, 0, 0)
        assert words(given, rows + ROW.size) == (Op.TREE, 0, 0, 0, 0, 0, 0, 0)
        assert words(given, rows + 2 * ROW.size) == (Op.CONSTRUCT, 1, 0, 0, 0, 0, 0, 0)
        assert os.pread(given, 20, first) == np.arange(5, dtype=np.uint32).tobytes()
        backwards = np.array([2, 1, 0, 5, 4, 3], np.float32)
        assert os.pread(given, 24, second) == backwards.tobytes()
        assert os.fstat(given).st_size == rows + 3 * ROW.size
    assert job.row_count == 3


@pytest.mark.parametrize("sizes", [(0, 0, 0), (1, 64, 65), (512, 3, 1 << 20)])
def test_nothing_overlaps(sizes: tuple[int, ...]) -> None:
    """Every array and every reserved field has bytes of its own, also empty ones."""
    job = Job()
    given = [job.give(np.zeros(size, np.uint8)) for size in sizes]
    reserved = [job.reserve(size) for size in sizes]
    assert all(a + size <= b for a, size, b in zip(given, sizes, given[1:], strict=False))
    assert all(a + size <= b for a, size, b in zip(reserved, sizes, reserved[1:], strict=False))
    assert given[0] >= HEADER.size
    assert reserved[0] >= DATA_OFFSET >= ERROR_OFFSET + ERROR_CAPACITY
    assert job.result_size >= reserved[-1] + sizes[-1]
    assert not [offset for offset in reserved if offset % 64]


def shrink(descriptor: int) -> None:
    """Cut a file off."""
    os.ftruncate(descriptor, 0)


def grow(descriptor: int) -> None:
    """Make a file longer."""
    os.ftruncate(descriptor, 1 << 30)


def append(descriptor: int) -> None:
    """Write behind the end."""
    os.pwrite(descriptor, b"x", os.fstat(descriptor).st_size)


def unseal(descriptor: int) -> None:
    """Add another seal, as whoever wants to annoy the next one would."""
    fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_WRITE)


def write(descriptor: int) -> None:
    """Write into the file."""
    os.pwrite(descriptor, b"x", 0)


def punch(descriptor: int) -> None:
    """Take pages out of the file."""
    libc = ctypes.CDLL(None, use_errno=True)
    arguments = (ctypes.c_int(descriptor), 3, ctypes.c_long(0), ctypes.c_long(4096))
    if libc.fallocate(*arguments):
        raise OSError(ctypes.get_errno(), "fallocate")


def map_and_write(descriptor: int) -> None:
    """Write through a shared mapping."""
    mmap.mmap(descriptor, 0)[0] = 1


@pytest.mark.parametrize("attack", [shrink, grow, append, unseal, write, punch, map_and_write])
def test_the_input_cannot_be_changed(attack: Callable[[int], None]) -> None:
    """The seals of the input forbid every change, by whoever holds the descriptor."""
    job = Job()
    job.give(np.ones(4096, np.uint8))
    with job.files() as (given, _):
        before = os.pread(given, 1 << 20, 0)
        with pytest.raises(OSError, match=r".") as fault:
            attack(os.dup(given))
        assert fault.value.errno in (errno.EPERM, errno.EACCES)
        assert os.pread(given, 1 << 20, 0) == before


@pytest.mark.parametrize("attack", [shrink, grow, append, unseal])
def test_the_result_cannot_be_resized(attack: Callable[[int], None]) -> None:
    """A mapping of the result can never fault, whatever the worker does to the file."""
    job = Job()
    job.reserve(5000)
    with job.files() as (_, result):
        with pytest.raises(OSError, match=r".") as fault:
            attack(result)
        assert fault.value.errno == errno.EPERM
        assert os.fstat(result).st_size == job.result_size


def test_the_result_is_empty_at_first_and_costs_nothing() -> None:
    """Room for two million nodes takes no memory before it is written."""
    job = Job()
    offset = job.reserve(64 << 20)
    with job.files() as (_, result):
        assert os.fstat(result).st_blocks == 0
        os.pwrite(result, b"\x07", offset)
        read = Result(result, job.result_size)
    assert read.number(offset) == 7
    assert read.array(offset, 3, np.uint32).tolist() == [7, 0, 0]
    assert read.array(offset, 0, np.float32).tolist() == []


def test_what_is_read_is_a_copy() -> None:
    """Neither a late writer nor the check changes what was read."""
    job = Job()
    offset = job.reserve(8)
    with job.files() as (_, result):
        read = Result(result, job.result_size)
        array: npt.NDArray[np.uint32] = read.array(offset, 2, np.uint32)
        os.pwrite(result, b"\xff" * 8, offset)
    assert array.tolist() == [0, 0]
    assert array.flags.owndata


def test_descriptors_are_not_inherited_and_are_closed() -> None:
    """Other children never see them, and nothing is left open."""
    with Job().files() as descriptors:
        assert not any(os.get_inheritable(each) for each in descriptors)
    for each in descriptors:
        with pytest.raises(OSError, match="Bad file"):
            os.fstat(each)


def test_no_memory_for_the_input_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """The submission has not been asked anything yet."""
    job = Job()
    job.give(np.ones(8, np.uint8))
    header = os.pwrite

    def full(descriptor: int, data: bytes, offset: int) -> int:
        if offset:
            raise OSError(errno.ENOSPC, "No space left on device")
        return header(descriptor, data, offset)

    monkeypatch.setattr(os, "pwrite", full)
    with pytest.raises(WorkerFault, match="No space left"), job.files():
        pass


def test_large_arrays_are_written_in_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """A call that writes only a part is continued where it stopped."""
    job = Job()
    array = np.arange(1000, dtype=np.uint32)
    offset = job.give(array)
    whole = os.pwrite
    monkeypatch.setattr(os, "pwrite", lambda fd, data, at: whole(fd, memoryview(data)[:97], at))
    with job.files() as (given, _):
        assert os.pread(given, array.nbytes, offset) == array.tobytes()


HEADER_TEXT = (resources.stub_folder() / "abi" / "exercise03_abi.h").read_text()


def test_the_python_side_names_the_functions_of_the_header() -> None:
    """Every function that the worker declares is in the C header, with as many arguments."""
    declared = {
        match[1]: 0 if match[2].strip() == "void" else match[2].count(",") + 1
        for match in re.finditer(r"\b(ex03_\w+)\(([^)]*)\);", HEADER_TEXT)
    }
    mirrored = {name: len(arguments) for name, (_, arguments) in abi._FUNCTIONS.items()}
    assert mirrored.items() <= declared.items()


def test_statuses_are_those_of_the_header() -> None:
    """The library's words have the same numbers on both sides."""
    words_of_c = dict(re.findall(r"EX03_([A-Z_]+) = (\d+)", HEADER_TEXT))
    for name, status in numbers(protocol.Status).items():
        if status < protocol.Status.NOT_LOADED:
            assert words_of_c[name] == str(status)


def test_a_batch_is_laid_out_as_in_the_header() -> None:
    """The same fields in the same order, eight bytes each."""
    fields = re.search(r"typedef struct \{(.*?)\} ex03_batch;", HEADER_TEXT, re.DOTALL)
    assert fields
    names = re.findall(r"\*?(\w+);", fields[1])
    assert [name for name, *_ in abi.Batch._fields_] == names
    assert ctypes.sizeof(abi.Batch) == 8 * len(names)


def test_a_row_has_room_for_every_operation() -> None:
    """An operation and seven numbers, as the worker unpacks them."""
    assert ROW.size == 64 == HEADER.size
    assert sorted(numbers(Op).values()) == list(range(1, len(numbers(Op)) + 1))


def numbers(words: type) -> dict[str, int]:
    """The named numbers of a class."""
    return {name: value for name, value in vars(words).items() if name.isupper()}


def busy_kernel(monkeypatch: pytest.MonkeyPatch, times: int) -> list[int]:
    """Let the kernel refuse the first seals, as it does while it moves a page of the file."""
    asked: list[int] = []
    seal = fcntl.fcntl

    def refusing(descriptor: int, command: int, argument: int = 0) -> int:
        if command == fcntl.F_ADD_SEALS:
            asked.append(argument)
            if len(asked) <= times:
                raise OSError(errno.EBUSY, os.strerror(errno.EBUSY))
        return seal(descriptor, command, argument)

    monkeypatch.setattr(fcntl, "fcntl", refusing)
    return asked


def test_a_page_that_the_kernel_holds_is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Then both files are sealed as ever."""
    asked = busy_kernel(monkeypatch, 3)
    with Job().files() as (given, _):
        assert fcntl.fcntl(given, fcntl.F_GET_SEALS) & fcntl.F_SEAL_WRITE
    assert len(asked) == 5


def test_a_page_that_is_never_released_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """No submission can hold it: the file was not yet given to anybody."""
    busy_kernel(monkeypatch, 10_000)
    with pytest.raises(WorkerFault, match="could not be sealed"), Job().files():
        pass
