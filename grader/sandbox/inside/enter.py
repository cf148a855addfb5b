"""What every confined process does first: give up its rights, then become what was ordered.

Started as `python -I -S start.py key=value ... -- TARGET ARGUMENT ...`. A target with a slash
is a program to execute; any other is a module beside this file, for which nursery.py waits.
What the module imports is loaded before the doors close, so that the box needs no Python.

Until the last line of `confine` this process runs trusted code only, whatever rights it has.
"""

from __future__ import annotations

import ctypes
import os
import resource

# A constant that type checkers know: `typing` and `collections` would cost every box 8 ms.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

PR_SET_PDEATHSIG, PR_SET_DUMPABLE, PR_SET_SECCOMP, PR_SET_NO_NEW_PRIVS = 1, 4, 22, 38
SECCOMP_MODE_FILTER = 2
SIGKILL = 9
"""Spelt out: importing `signal` would cost every box 10 ms."""

OWN_PID = (0x0BADB0D1).to_bytes(4, "little")
"""Stands in a filter for the process's own number, which nobody knows before."""

PAGE = 4096
MOST_DESCRIPTORS = 1 << 20
_LIMITS = {
    "cpu": resource.RLIMIT_CPU,
    "memory": resource.RLIMIT_AS,
    "file": resource.RLIMIT_FSIZE,
    "files": resource.RLIMIT_NOFILE,
    "tasks": resource.RLIMIT_NPROC,
    "stack": resource.RLIMIT_STACK,
}


class Program(ctypes.Structure):
    """The kernel's struct sock_fprog."""

    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_void_p))


def confine(spec: Mapping[str, str]) -> None:
    """Give up every right that the specification does not leave.

    Raises:
        OSError: The kernel refuses; nothing foreign may run then.
    """
    library = ctypes.CDLL(None, use_errno=True)
    limit(spec)
    if uid := int(spec.get("uid", "0")):
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)
    # After the change of user, which clears it.
    tie(library, spec)
    control(library, PR_SET_DUMPABLE, 0)
    control(library, PR_SET_NO_NEW_PRIVS, 1)
    if "landlock" in spec:
        # By name: the package is out of reach here, the file beside this one is not.
        landlock = __import__("landlock")
        rules = [rule.split("=", 1) for rule in spec["landlock"].split("\n")]
        landlock.restrict(library, [(int(access), path) for access, path in rules])
    if code := bytes.fromhex(spec.get("filter", "")):
        code = code.replace(OWN_PID, os.getpid().to_bytes(4, "little"))
        held = ctypes.create_string_buffer(code)
        program = Program(len(code) // 8, ctypes.addressof(held))
        control(library, PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.addressof(program))


def tie(library: ctypes.CDLL, spec: Mapping[str, str]) -> None:
    """Have this process killed with its parent; whoever is orphaned already goes now."""
    control(library, PR_SET_PDEATHSIG, SIGKILL)
    if "parent" in spec and os.getppid() != int(spec["parent"]):
        os._exit(1)


def limit(spec: Mapping[str, str]) -> None:
    """Set the resource limits that a specification names, in seconds, bytes and counts."""
    for name, which in _LIMITS.items():
        if name not in spec:
            continue
        value = int(spec[name])
        # One second more in the hard limit makes the end a SIGXCPU and not a SIGKILL.
        hard = value + 1 if name == "cpu" else value
        resource.setrlimit(which, (value, hard))
    if "room" in spec:
        value = reserved() + int(spec["room"])
        resource.setrlimit(resource.RLIMIT_AS, (value, value))
    # 1 and not 0: a core_pattern that pipes into a program ignores 0. Who has 0 keeps it.
    core = 0 if resource.getrlimit(resource.RLIMIT_CORE)[1] == 0 else 1
    resource.setrlimit(resource.RLIMIT_CORE, (core, core))
    resource.setrlimit(resource.RLIMIT_MEMLOCK, (0, 0))


def reserved() -> int:
    """Bytes of address space that this process has, found by trying; there may be no /proc.

    A sanitizer reserves terabytes that cost nothing, so its limit has to begin there.
    """
    import mmap

    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    low, high = 0, 1 << 47
    while high - low > PAGE:
        middle = (low + high) // 2 // PAGE * PAGE
        resource.setrlimit(resource.RLIMIT_AS, (middle, hard))
        try:
            mmap.mmap(-1, PAGE).close()
            high = middle
        except (OSError, MemoryError):
            low = middle
    resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
    return high


def control(library: ctypes.CDLL, what: int, *values: int) -> None:
    """Call prctl.

    Raises:
        OSError: It failed.
    """
    padded = (*values, 0, 0, 0, 0)[:4]
    if library.prctl(what, *(ctypes.c_ulong(int(value)) for value in padded)) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"prctl {what}: {os.strerror(number)}")


def announce(spec: Mapping[str, str]) -> None:
    """Tell the grader that all doors are closed; what happens from now on is not our fault.

    By a pipe or a socket: the filter leaves `write` for both.
    """
    ready = int(spec["ready"])
    os.write(ready, b"r")
    os.close(ready)


def close_others(spec: Mapping[str, str]) -> None:
    """Close what the target has no use for: bubblewrap leaves its own descriptors open."""
    words = [*spec["keep"].split(","), spec["ready"]]
    kept = sorted(int(word) for word in words if word)
    for low, high in zip([2, *kept], [*kept, MOST_DESCRIPTORS], strict=True):
        os.closerange(low + 1, high)


def main(arguments: Sequence[str]) -> None:
    """Confine this process and become the target."""
    cut = list(arguments).index("--")
    spec = dict(word.split("=", 1) for word in arguments[:cut])
    target, *rest = arguments[cut + 1 :]
    close_others(spec)
    if "/" not in target:
        # By name: the package is out of reach here, the file beside this one is not.
        __import__("nursery").serve(spec, target)
        return
    confine(spec)
    announce(spec)
    os.execv(target, [target, *rest])  # noqa: S606 - that is what it is for
