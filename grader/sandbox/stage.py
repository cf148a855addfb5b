"""Where do the files lie that start a confined process?

Not in the package: a wheel may be installed where the confined user cannot read, or beside the
answers. They are copied into a folder that everyone may read, named by its content, with the
compiled form that this Python understands beside them.
"""

import hashlib
import os
import py_compile
import shutil
import sys
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from grader.resources import shared_cache

INSIDE = Path(__file__).with_name("inside")
ENTRY = ("start.py", "enter.py", "nursery.py", "channel.py", "landlock.py")


def staged(modules: tuple[Path, ...] = ()) -> Path:
    """Copy start.py and the modules that it may become; returns the copy of start.py.

    Raises:
        OutputFault: The cache folder cannot be written.
    """
    return _staged(modules, shared_cache("entry"))


@cache
def _staged(modules: tuple[Path, ...], parent: Path) -> Path:
    files = [INSIDE / name for name in ENTRY] + list(modules)
    folder = parent / _digest(files)
    if not folder.exists():
        with tempfile.TemporaryDirectory(dir=parent) as scratch:
            made = _filled(Path(scratch) / "made", files)
            try:
                made.rename(folder)
            except OSError:
                # Another process was first: a folder that is not empty is never replaced.
                if not folder.exists():
                    raise
    return folder / ENTRY[0]


def _digest(files: Sequence[Path]) -> str:
    digest = hashlib.sha256(sys.version.encode())
    for path in files:
        digest.update(f"{path.name}\0".encode() + path.read_bytes() + b"\0")
    return digest.hexdigest()[:24]


def _filled(folder: Path, files: Sequence[Path]) -> Path:
    folder.mkdir()
    for path in files:
        copy = folder / path.name
        shutil.copyfile(path, copy)
        mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
        py_compile.compile(str(copy), doraise=True, invalidation_mode=mode)
    for root, _, names in os.walk(folder):
        Path(root).chmod(0o755)
        for name in names:
            (Path(root) / name).chmod(0o644)
    return folder
