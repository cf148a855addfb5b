"""How is something printed for a reader who may go away, or into a file that takes no more?"""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedWriter, FileIO, TextIOWrapper
from pathlib import Path
from typing import TYPE_CHECKING

from grader.errors import OutputFault

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer


@contextmanager
def patient_stdout() -> Iterator[None]:
    """Let a reader go away early: what was graded keeps its result and its exit status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        lead_nowhere(sys.stdout.fileno())


class Outlet(FileIO):
    """Standard output as bytes."""

    def write(self, data: "ReadableBuffer", /) -> int:
        """Write some of them; how many.

        Raises:
            BrokenPipeError: The reader went away.
            OutputFault: Nothing more can be written, as on a full disk.
        """
        try:
            return super().write(data)
        except BrokenPipeError:
            raise
        except OSError as fault:
            # What is left in buffers would fail again when Python ends.
            lead_nowhere(self.fileno())
            raise OutputFault(
                f"standard output cannot be written: {fault.strerror}; redirect it to where "
                "there is room. What was written into other files is there."
            ) from fault


def require_outlet() -> None:
    """Tell a standard output that cannot be written from all other faults."""
    stream = sys.stdout
    if isinstance(stream, TextIOWrapper):
        sys.stdout = TextIOWrapper(
            BufferedWriter(Outlet(stream.fileno(), "w", closefd=False)),
            stream.encoding,
            # A pipe of another age gets a code for what its encoding lacks.
            "backslashreplace",
            line_buffering=stream.line_buffering,
            write_through=stream.write_through,
        )


def lead_nowhere(descriptor: int) -> None:
    """Throw away whatever is written from now on."""
    with Path(os.devnull).open("wb") as nowhere:
        os.dup2(nowhere.fileno(), descriptor)
