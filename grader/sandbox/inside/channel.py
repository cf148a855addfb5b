"""What do the grader and the process that waits in a box say to each other?

One message each, over a socket that keeps their bounds:

    box     HERE                        everything of ours is loaded
    grader  a request, with the two output pipes and the target's descriptors
    box     READY                       sent by the copy, whose number the kernel adds; from now
                                        on the target runs, and the socket is closed there
    grader  STOP                        its time is over
    box     END                         the copy has ended and is reaped

Used on both sides, so it uses the standard library only.
"""

from __future__ import annotations

import struct

HERE, READY, STOP = b"h", b"r", b"s"
MOST_BYTES = 128 << 10
"""Of one request. A socket of the default size takes about 200 KiB."""

MOST_DESCRIPTORS = 16

_END = struct.Struct("=cid")


def request(cpu_seconds: int, arguments: list[str]) -> bytes:
    """Put a request into bytes.

    Raises:
        ValueError: It is too long.
    """
    data = "\0".join([str(cpu_seconds), *arguments]).encode()
    if len(data) > MOST_BYTES:
        message = f"{len(data)} bytes of arguments, but a box takes at most {MOST_BYTES}"
        raise ValueError(message)
    return data


def read_request(data: bytes) -> tuple[str, list[str]]:
    """Take a request apart: the limit of CPU seconds, and the arguments."""
    seconds, *arguments = data.decode().split("\0")
    return seconds, arguments


def end(code: int, cpu_seconds: float) -> bytes:
    """Put into bytes how a copy ended: exit status or negative signal, and its CPU time."""
    return _END.pack(b"e", code, cpu_seconds)


def read_end(data: bytes) -> tuple[int, float]:
    """Take an end apart.

    Raises:
        ValueError: It is none.
    """
    if len(data) != _END.size or data[:1] != b"e":
        raise ValueError("the process that waits in a box does not speak as agreed")
    _, code, seconds = _END.unpack(data)
    return int(code), float(seconds)
