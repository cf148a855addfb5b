"""How do two processes of ours talk through a socket? In pickled letters, length first.

Both ends run this program, with the same rights: nothing of a submission's ever writes here.
"""

import pickle
import socket
import struct
from typing import Any

_LENGTH = struct.Struct("<Q")


class Ended(Exception):
    """The other side is gone."""


def post(to: socket.socket, letter: Any) -> None:  # noqa: ANN401 - anything that can be pickled
    """Send a letter.

    Raises:
        OSError: The other side is gone, or takes nothing.
    """
    data = pickle.dumps(letter)
    to.sendall(_LENGTH.pack(len(data)) + data)


def received(desk: socket.socket) -> Any:  # noqa: ANN401 - whatever the other side sent
    """Wait for a letter.

    Raises:
        Ended: The other side is gone.
        OSError: It does not go on, or its end was rough.
    """
    (length,) = _LENGTH.unpack(_exactly(desk, _LENGTH.size))
    return pickle.loads(_exactly(desk, length))  # noqa: S301 - from a process of ours


def _exactly(desk: socket.socket, size: int) -> bytes:
    data = bytearray()
    while len(data) < size:
        piece = desk.recv(min(size - len(data), 1 << 20))
        if not piece:
            raise Ended
        data += piece
    return bytes(data)
