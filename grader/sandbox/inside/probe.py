"""What can be done from inside a box? Tries what a hostile submission would try.

Prints one line for each attempt that succeeded, and `done` at the end. It is our own code: what
it says is believed. Arguments: `worker` or `compiler`, number of the grader's process, limit of
memory and of open files, folder to write to or -, and files that must stay out of reach.
"""

import ctypes
import mmap
import os
import signal
import socket
from collections.abc import Callable
from functools import partial

Attempt = tuple[str, Callable[[], object]]

PLAIN = {"PATH", "LC_ALL", "TMPDIR", "PWD"}
"""Variables that a box may show; PWD is bubblewrap's own."""


def main(arguments: list[str]) -> None:
    """Try everything and say what worked."""
    kind, grader, memory, files, own, *secrets = arguments
    # Whoever could ask to be traced would be stopped by the next signal for ever.
    signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
    library = ctypes.CDLL(None, use_errno=True)
    attempts = _everywhere(library, int(grader), secrets, [own])
    if kind == "worker":
        attempts += _worker(secrets)
    # Last: no attempt could open a file after these.
    attempts += _bounds(int(memory), int(files))
    for name, attempt in attempts:
        try:
            attempt()
        except (OSError, MemoryError):
            continue
        print(name, flush=True)  # noqa: T201 - the answer
    if kind == "worker":
        _become_program()
    print("done", flush=True)  # noqa: T201 - the answer
    os._exit(0)


def _everywhere(
    library: ctypes.CDLL, grader: int, secrets: list[str], own: list[str]
) -> list[Attempt]:
    """What neither a worker nor a compiler may do."""
    open_to_all = ("/", "/tmp", "/var/tmp", "/dev/shm", "/usr/lib")  # noqa: S108 - just these
    here = os.getcwd()  # noqa: PTH109 - pathlib costs 8 ms
    folders = [*open_to_all, here, *map(os.path.dirname, secrets)]
    found: list[Attempt] = [(f"reads {path}", partial(_read, path)) for path in secrets]
    found += [
        (f"writes to {folder}", partial(_write, folder))
        for folder in folders
        if folder not in own
    ]
    found += [(f"changes {path}", partial(_change, path)) for path in secrets]
    for family in ("AF_INET", "AF_INET6", "AF_UNIX", "AF_NETLINK", "AF_VSOCK"):
        number = getattr(socket, family)
        kind = socket.SOCK_RAW if family == "AF_NETLINK" else socket.SOCK_STREAM
        found.append((f"opens a socket {family}", partial(socket.socket, number, kind)))
    return [
        # First: in a namespace of its own a process is another user.
        ("runs as root", _runs_as_root),
        *found,
        ("opens the root folder", partial(_read, "/")),
        ("sees the grader's process", lambda: os.kill(grader, 0)),
        ("becomes root", lambda: os.setresuid(0, 0, 0)),
        ("changes the root", lambda: os.chroot("/")),
        ("makes a namespace", lambda: _called(library.unshare, 0x10000000)),
        ("traces processes", lambda: _called(library.ptrace, 0, 0, 0, 0)),
        ("shares memory by a key", lambda: _called(library.shmget, 0, 4096, 0o1600)),
        ("sees the grader's environment", lambda: _nonzero(bool({*os.environ} - PLAIN))),
    ]


def _worker(secrets: list[str]) -> list[Attempt]:
    """What a compiler may, but a worker may not."""
    return [
        ("starts a process", _fork),
        ("lists a folder", partial(os.listdir, os.path.dirname(secrets[0]))),  # noqa: PTH120 - as above
        ("makes a file in memory", lambda: os.memfd_create("probe")),
    ]


def _bounds(memory: int, files: int) -> list[Attempt]:
    return [
        ("takes more memory than the limit", lambda: mmap.mmap(-1, memory)),
        ("opens more files than the limit", lambda: [os.dup(0) for _ in range(files)]),
    ]


def _read(path: str) -> None:
    os.close(os.open(path, os.O_RDONLY))


def _write(folder: str) -> None:
    path = f"{folder}/bvhgrade-probe-{os.getpid()}"
    os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
    os.unlink(path)  # noqa: PTH108 - pathlib costs 8 ms


def _change(path: str) -> None:
    os.close(os.open(path, os.O_WRONLY))


def _become_program() -> None:
    """Last of all, since nothing comes back from it."""
    try:
        os.execv("/bin/sh", ["sh", "-c", "echo starts a program; echo done"])  # noqa: S606 - tried
    except OSError:
        return


def _fork() -> None:
    if os.fork() == 0:
        os._exit(0)


def _runs_as_root() -> None:
    _nonzero(os.geteuid() == 0)


def _nonzero(succeeded: bool) -> None:
    if not succeeded:
        raise PermissionError


def _called(function: Callable[..., int], *arguments: int) -> None:
    if function(*arguments) < 0:
        raise PermissionError
