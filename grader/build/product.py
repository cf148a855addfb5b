"""How does what a compiler wrote become a file of ours?

The folder that a compiler writes to is the submission's: what lies there may be a link, a pipe
or a terabyte. It is opened once, relative to that folder, and only its bytes are taken.
"""

import os
import stat
from pathlib import Path


def adopted(folder: Path, name: str, most: int) -> bytes | None:
    """Read a product.

    Args:
        folder: Where a confined process could write.
        name: Name of the product in it, ours and not the process's.
        most: Largest size in bytes.

    Returns:
        Its content; None if it is missing, too large or no regular file.
    """
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC
    parent = os.open(folder, flags | os.O_DIRECTORY)
    try:
        handle = os.open(name, flags | os.O_NONBLOCK, dir_fd=parent)
    except OSError:
        return None
    finally:
        os.close(parent)
    state = os.fstat(handle)
    if not stat.S_ISREG(state.st_mode) or state.st_size > most:
        os.close(handle)
        return None
    with os.fdopen(handle, "rb") as file:
        # The size may still grow behind our back; the limit does not.
        content = file.read(most + 1)
    return content if len(content) <= most else None
