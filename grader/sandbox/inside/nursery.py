"""What waits in a box, and becomes the process of each case by copying itself.

Starting Python costs more than most cases do, so it is started once for all cases of a library.
The process that waits runs trusted code only and never sees a result. A copy gives up its
rights before anything foreign is loaded, and closes the socket; the filter of system calls
leaves it no way to reach another process, so the one that waits stays as it was.
"""

from __future__ import annotations

import ctypes
import os
import select
import socket

# A constant that type checkers know: `typing` and `collections` would cost every box 8 ms.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from grader.sandbox.inside import channel, enter
else:
    # The package is out of reach here: the files beside this one are all that is needed.
    import channel
    import enter

NUMBER_BYTES = 4


def serve(spec: Mapping[str, str], name: str) -> None:
    """Wait for requests until the grader is gone; returns in the copies only, when they end.

    Args:
        spec: What the box has to give up; `ready` is the socket.
        name: The module whose `main` a copy runs.
    """
    module = __import__(name)
    control = socket.socket(fileno=int(spec["ready"]))
    library = ctypes.CDLL(None, use_errno=True)
    enter.tie(library, spec)
    enter.control(library, enter.PR_SET_DUMPABLE, 0)
    # The copies have to go with this process.
    spec = {**spec, "parent": str(os.getpid())}
    control.send(channel.HERE)
    while True:
        data, files = _received(control)
        if not data:
            os._exit(0)
        if data == channel.STOP:
            # It crossed the end of the copy that it was meant for.
            continue
        pid = os.fork()
        if pid == 0:
            # It is closed as a descriptor, once the copy is ready.
            control.detach()
            _become(module.main, spec, data, files)
            return
        for file in files:
            os.close(file)
        _attend(pid, control)


def _received(control: socket.socket) -> tuple[bytes, list[int]]:
    room = socket.CMSG_SPACE(channel.MOST_DESCRIPTORS * NUMBER_BYTES)
    data, ancillary, _, _ = control.recvmsg(channel.MOST_BYTES, room)
    files = [
        int.from_bytes(held[at : at + NUMBER_BYTES], "little")
        for level, kind, held in ancillary
        if (level, kind) == (socket.SOL_SOCKET, socket.SCM_RIGHTS)
        for at in range(0, len(held), NUMBER_BYTES)
    ]
    return data, files


def _become(
    main: Callable[[Sequence[str]], None],
    spec: Mapping[str, str],
    data: bytes,
    files: Sequence[int],
) -> None:
    """Take the two output pipes for one's own, give up every right, run the target."""
    seconds, arguments = channel.read_request(data)
    out, err, *given = files
    # Flags of an open file are shared with whoever has it too: with the copies that follow.
    nothing = os.open(os.devnull, os.O_RDONLY)
    for place, file in enumerate((nothing, out, err)):
        os.dup2(file, place)
    numbers = [str(file) for file in given]
    spec = {**spec, "keep": ",".join(numbers)}
    if seconds != "0":
        spec["cpu"] = seconds
    enter.close_others(spec)
    enter.confine(spec)
    enter.announce(spec)
    main([*arguments, *numbers])


def _attend(pid: int, control: socket.socket) -> None:
    """Wait for the end of a copy, or end it when the grader says so or is gone."""
    ended = os.pidfd_open(pid)
    poll = select.poll()
    poll.register(ended, select.POLLIN)
    poll.register(control, select.POLLIN)
    while ended not in (descriptor for descriptor, _ in poll.poll()):
        os.kill(pid, enter.SIGKILL)
        if not control.recv(len(channel.STOP)):
            os._exit(0)
    os.close(ended)
    _, status, usage = os.wait4(pid, 0)
    code = os.waitstatus_to_exitcode(status)
    control.send(channel.end(code, usage.ru_utime + usage.ru_stime))
