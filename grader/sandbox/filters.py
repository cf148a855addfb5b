"""Which system calls may a process make that holds a submission, or compiles one?

A worker gets a list of what is allowed: to compute, to read files, to have threads. Everything
else fails with EPERM instead of killing, so that a forgotten `system("pause")` or a debug file
costs nobody a point. A compiler gets a list of what is refused, since compilers differ. Calls
by the convention of another architecture end the process: they would have other numbers.

The result is a program of the kernel's classic BPF, eight bytes an instruction.
Source: the kernel's userspace-api/seccomp_filter; linux/seccomp.h, linux/bpf_common.h.
"""

import errno
import fcntl
import os
import struct
from collections.abc import Iterable, Iterator, Sequence

from grader.sandbox.calls import COMPUTING, REFUSED
from grader.sandbox.inside.enter import OWN_PID
from grader.sandbox.syscalls import Architecture, architecture, number

_LOAD, _EQUAL, _AT_LEAST, _ANY_BIT, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_NUMBER, _ARCHITECTURE, _ARGUMENTS = 0, 4, 16
_ALLOW, _KILL, _ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
_REFUSE = _ERRNO | errno.EPERM
_UNKNOWN = _ERRNO | errno.ENOSYS

_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND | 0o20000000
"""Flags of open that change something; the last is O_TMPFILE without its O_DIRECTORY."""

_CLONE_THREAD = 0x00010000
_CLONE_NEW = 0x7E020080
"""All flags that make a namespace."""

_SET_NAME, _GET_NAME, _SET_VMA = 15, 16, 0x53564D41
_TERMINAL_STATE, _WINDOW_SIZE, _FAKE_INPUT, _CONSOLE = 0x5401, 0x5413, 0x5412, 0x541C
_DESCRIPTOR_COMMANDS = (
    fcntl.F_DUPFD,
    fcntl.F_GETFD,
    fcntl.F_SETFD,
    fcntl.F_GETFL,
    fcntl.F_DUPFD_CLOEXEC,
)
_PACKETS = 0o240000
"""O_DIRECT, on Arm or elsewhere. A pipe with it is read one write at a time, however short."""

Instruction = tuple[int, int, int, int]
"""Code, jump if true, jump if false, constant."""


def worker_filter(machine: str = "") -> bytes:
    """Program for the process that holds a submission.

    Args:
        machine: Another processor than this one.
    """
    of = architecture(machine)
    own = int.from_bytes(OWN_PID, "little")
    parts = [
        *(_when(of, name, [_answer(_ALLOW)]) for name in COMPUTING),
        _when(of, "open", _unless_bits(1, _WRITING, _ALLOW)),
        _when(of, "openat", _unless_bits(2, _WRITING, _ALLOW)),
        _when(of, "openat2", [_answer(_UNKNOWN)]),
        _when(of, "clone3", [_answer(_UNKNOWN)]),
        _when(of, "clone", [*_unless_bits(0, _CLONE_NEW, None), *_if_bits(0, _CLONE_THREAD)]),
        _when(of, "kill", _if_one_of(0, [own])),
        _when(of, "tgkill", _if_one_of(0, [own])),
        _when(of, "prctl", _if_one_of(0, [_SET_NAME, _GET_NAME, _SET_VMA])),
        _when(of, "ioctl", _if_one_of(1, [_TERMINAL_STATE, _WINDOW_SIZE])),
        _when(of, "fcntl", _descriptor_commands()),
        _when(of, "prlimit64", _reading_limits()),
    ]
    return _program(of, parts, _REFUSE)


def compiler_filter(machine: str = "") -> bytes:
    """Program for the processes that compile and link a submission."""
    of = architecture(machine)
    parts = [
        *(_when(of, name, [_answer(_REFUSE)]) for name in REFUSED),
        _when(of, "clone3", [_answer(_UNKNOWN)]),
        _when(of, "clone", _unless_bits(0, _CLONE_NEW, _ALLOW)),
        _when(of, "ioctl", [*_if_one_of(1, [_FAKE_INPUT, _CONSOLE], _REFUSE, _ALLOW)]),
        _when(of, "prlimit64", _if_one_of(0, [0])),
    ]
    return _program(of, parts, _ALLOW)


def _program(of: Architecture, parts: Iterable[Sequence[Instruction]], default: int) -> bytes:
    code: list[Instruction] = [
        (_LOAD, 0, 0, _ARCHITECTURE),
        (_EQUAL, 1, 0, of.audit),
        _answer(_KILL),
        (_LOAD, 0, 0, _NUMBER),
    ]
    if of.foreign:
        code += [(_AT_LEAST, 0, 1, of.foreign), _answer(_KILL)]
    for part in parts:
        code += part
    code.append(_answer(default))
    return b"".join(struct.pack("<HBBI", *each) for each in code)


def _answer(value: int) -> Instruction:
    return (_RETURN, 0, 0, value)


def _argument(index: int) -> Instruction:
    """Load the lower half of an argument: flags and commands are 32-bit integers."""
    return (_LOAD, 0, 0, _ARGUMENTS + 8 * index)


def _when(of: Architecture, name: str, then: Sequence[Instruction]) -> list[Instruction]:
    """Decide one call; the number is in the accumulator, and `then` ends with an answer."""
    called = number(name, of)
    return [] if called < 0 else [(_EQUAL, 0, len(then), called), *then]


def _unless_bits(index: int, bits: int, then: int | None) -> list[Instruction]:
    """Refuse if any bit is set in an argument; otherwise answer, or go on."""
    code = [_argument(index), (_ANY_BIT, 0, 1, bits), _answer(_REFUSE)]
    return code if then is None else [*code, _answer(then)]


def _if_bits(index: int, bits: int) -> list[Instruction]:
    """Allow if any bit is set in an argument, else refuse."""
    return [_argument(index), (_ANY_BIT, 0, 1, bits), _answer(_ALLOW), _answer(_REFUSE)]


def _if_one_of(
    index: int, values: Sequence[int], then: int = _ALLOW, otherwise: int = _REFUSE
) -> list[Instruction]:
    return [_argument(index), *_compared(values, then), _answer(otherwise)]


def _compared(values: Iterable[int], then: int) -> Iterator[Instruction]:
    for value in values:
        yield (_EQUAL, 0, 1, value)
        yield _answer(then)


def _descriptor_commands() -> list[Instruction]:
    """Commands of fcntl that concern one descriptor; none that makes packets of a pipe."""
    marks = _unless_bits(2, _PACKETS, _ALLOW)
    return [
        _argument(1),
        (_EQUAL, 0, len(marks), fcntl.F_SETFL),
        *marks,
        *_compared(_DESCRIPTOR_COMMANDS, _ALLOW),
        _answer(_REFUSE),
    ]


def _reading_limits() -> list[Instruction]:
    """prlimit64 of this process, with no new limit: both halves of the pointer are null."""
    low, high = _ARGUMENTS + 8 * 2, _ARGUMENTS + 8 * 2 + 4
    return [
        (_LOAD, 0, 0, low),
        (_EQUAL, 1, 0, 0),
        _answer(_REFUSE),
        (_LOAD, 0, 0, high),
        (_EQUAL, 1, 0, 0),
        _answer(_REFUSE),
        _argument(0),
        (_EQUAL, 0, 1, 0),
        _answer(_ALLOW),
        (_EQUAL, 0, 1, int.from_bytes(OWN_PID, "little")),
        _answer(_ALLOW),
        _answer(_REFUSE),
    ]
