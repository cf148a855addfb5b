"""Where does a submission lie while it is graded?"""

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """A fresh folder that others may enter but not list; gone afterwards.

    Removed by descriptors, which follow no link, after every process that could write there is
    dead. Not `tempfile.TemporaryDirectory`: where a removal is refused, some versions of it
    change the mode of what a link points to (CVE-2023-6597).
    """
    folder = Path(tempfile.mkdtemp(prefix="bvhgrade-"))
    try:
        folder.chmod(0o711)
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
