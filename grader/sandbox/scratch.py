"""Where does a submission lie while it is graded?"""

import fcntl
import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

PREFIX = "bvhgrade-"
OLD_SECONDS = 3600
"""A folder that is younger may be one that its grader is just about to lock."""

_OURS = re.compile(rf"{PREFIX}[a-z0-9_]{{8}}")
_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """A fresh folder that others may enter but not list; gone afterwards.

    Removed by descriptors, which follow no link, after every process that could write there is
    dead. Not `tempfile.TemporaryDirectory`: where a removal is refused, some versions of it
    change the mode of what a link points to (CVE-2023-6597). It is locked as long as its grader
    lives, and what killed graders left is removed first.
    """
    sweep(Path(tempfile.gettempdir()))
    folder = Path(tempfile.mkdtemp(prefix=PREFIX))
    with _opened(str(folder)) as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        try:
            folder.chmod(0o711)
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def sweep(parent: Path) -> None:
    """Remove what killed graders of this user left: old folders of theirs that nobody locks."""
    oldest = time.time() - OLD_SECONDS
    # Where a folder may not be listed, nothing of ours can be found.
    with suppress(OSError), _opened(str(parent.resolve())) as above:
        for name in filter(_OURS.fullmatch, os.listdir(above)):  # noqa: PTH208 - no path to a descriptor
            with suppress(OSError), _opened(name, above) as held:
                state = os.fstat(held)
                if state.st_uid == os.geteuid() and state.st_mtime < oldest:
                    fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    shutil.rmtree(name, ignore_errors=True, dir_fd=above)


@contextmanager
def _opened(name: str, above: int | None = None) -> Iterator[int]:
    """Open a folder, but never through a link."""
    handle = os.open(name, _FOLDER, dir_fd=above)
    try:
        yield handle
    finally:
        os.close(handle)
