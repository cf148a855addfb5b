"""What is a process in a box told that it has to give up? The words that enter.py reads."""

import os
from collections.abc import Iterator

from grader.sandbox.box import BUBBLES, Bounds, Box, Isolation, Level
from grader.sandbox.filters import compiler_filter, worker_filter
from grader.sandbox.inside import landlock
from grader.sandbox.visible import DEVICES, system_paths


def specification(box: Box, isolation: Isolation, waits: bool) -> Iterator[str]:
    """Words for enter.py.

    Args:
        box: What the process may see, write and use.
        isolation: The level, and the user of this box.
        waits: Whether a process waits in the box and becomes the target only in a copy.
    """
    yield from _limits(box.bounds, isolation, waits)
    if isolation.level not in BUBBLES:
        yield f"parent={os.getpid()}"
    if isolation.level is Level.NONE:
        return
    if isolation.uid and isolation.level not in BUBBLES:
        yield f"uid={isolation.uid}"
    if isolation.level in (Level.NAMESPACES, Level.PROCESS):
        yield "landlock=" + "\n".join(_rules(box))
    code = compiler_filter() if box.starts_programs else worker_filter()
    yield f"filter={code.hex()}"


def _limits(bounds: Bounds, isolation: Isolation, waits: bool) -> Iterator[str]:
    # Elsewhere the kernel would count everything that the caller runs on this machine.
    namespace = isolation.level in BUBBLES
    alone = isolation.uid or namespace
    # Bubblewrap's first process of a namespace is one too, and so is who waits there. Without
    # a namespace who waits has not become the user of the box.
    ours = namespace * (1 + waits)
    named = {
        "cpu": bounds.cpu_seconds,
        "room" if bounds.beyond_reserved else "memory": bounds.memory_bytes,
        "file": bounds.file_bytes,
        "files": bounds.open_files,
        "tasks": bounds.tasks + ours if alone and bounds.tasks else 0,
        "stack": bounds.stack_bytes,
    }
    yield from (f"{name}={value}" for name, value in named.items() if value)


def _rules(box: Box) -> Iterator[str]:
    """Rights and paths; what is missing on this machine is left out inside."""
    # A sanitizer reads the program that it runs in before it can name lines of a library.
    yield f"{landlock.READ}=/proc/self/exe"
    right = landlock.RUN if box.starts_programs else landlock.READ
    for path in (*system_paths(box), *box.readable):
        yield f"{right}={path}"
    for device in DEVICES:
        yield f"{landlock.READ | landlock.WRITE_FILE}={device}"
    if box.writable:
        yield f"{landlock.OWN}={box.writable}"
