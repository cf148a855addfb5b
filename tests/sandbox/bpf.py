"""Runs a filter of system calls as the kernel would: classic BPF over struct seccomp_data."""

import struct
from collections.abc import Callable, Sequence

from grader.sandbox.syscalls import ARCHITECTURES, NUMBERS

ALLOW, KILL, ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
Step = tuple[int, int, int, int]
TESTS: dict[int, Callable[[int, int], bool]] = {
    0x15: lambda accumulator, value: accumulator == value,
    0x35: lambda accumulator, value: accumulator >= value,
    0x25: lambda accumulator, value: accumulator > value,
    0x45: lambda accumulator, value: bool(accumulator & value),
}
JUMP, LOAD, RETURN = 0x05, 0x20, 0x06


def steps_of(code: bytes) -> list[Step]:
    """Read the instructions of a program."""
    return list(struct.iter_unpack("<HBBI", code))


class Filter:
    """One program, asked as if a process had made a system call."""

    def __init__(self, code: bytes, machine: str) -> None:
        self.steps = steps_of(code)
        self.machine = machine

    def raw(self, audit: int, number: int, arguments: Sequence[int] = ()) -> int:
        """Give the answer to a call by its number, by the convention of an architecture."""
        padded = (*arguments, *[0] * 6)[:6]
        data = struct.pack("<iIQ6Q", number, audit, 0x400000, *padded)
        accumulator, place = 0, 0
        while True:
            code, if_true, if_false, value = self.steps[place]
            place += 1
            if code == LOAD:
                (accumulator,) = struct.unpack_from("<I", data, value)
            elif code == RETURN:
                return value
            elif code == JUMP:
                place += value
            else:
                place += if_true if TESTS[code](accumulator, value) else if_false

    def call(self, name: str, *arguments: int) -> int:
        """Give the answer to a call of this architecture by its name."""
        architecture = ARCHITECTURES[self.machine]
        number = NUMBERS[name][architecture.column]
        assert number >= 0
        return self.raw(architecture.audit, number, arguments)

    def has(self, name: str) -> bool:
        """Tell whether this architecture has a call of that name."""
        return NUMBERS[name][ARCHITECTURES[self.machine].column] >= 0
