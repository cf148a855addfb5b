"""How is something printed for a reader who may go away?"""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def patient_stdout() -> Iterator[None]:
    """Let a reader go away early: what was graded keeps its result and its exit status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        with Path(os.devnull).open("wb") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
