"""Where do the exercise's own files lie, in a checkout and in an installed wheel?

A checkout has `student_stub/`, `reference/` and `scenes/` beside the package; a wheel carries
the same folders below `grader/data/`. A checkout wins: an editable install sees its edits.
"""

import os
import stat
from pathlib import Path

from grader.errors import GraderError, OutputFault, UsageError
from grader.model.stages import SOURCE_NAME, SOURCE_PATH

_PACKAGE = Path(__file__).resolve().parent


def stub_folder(package: Path = _PACKAGE) -> Path:
    """The exercise as students get it: headers, given code, C ABI and CMake files.

    Args:
        package: Folder of the `grader` package; only tests name another one.
    """
    return _folder("student_stub", package)


def reference_source(package: Path = _PACKAGE) -> Path:
    """The model solution, one C++ file.

    Args:
        package: Folder of the `grader` package; only tests name another one.
    """
    return _folder("reference", package) / SOURCE_PATH


def fast_source(package: Path = _PACKAGE) -> Path:
    """The model solution again, as fast as its tree allows.

    Args:
        package: Folder of the `grader` package; only tests name another one.
    """
    return _folder("reference", package) / "fast" / SOURCE_NAME


def scenes_folder(package: Path = _PACKAGE) -> Path:
    """Meshes and the references that Mitsuba rendered of them.

    Args:
        package: Folder of the `grader` package; only tests name another one.
    """
    return _folder("scenes", package)


def cache_folder() -> Path:
    """A folder that survives the run, whose names nobody else can list.

    `BVHGRADE_CACHE` names it. Otherwise it is /var/cache/bvhgrade for root, because submissions
    are then compiled by another user, and `bvhgrade` in `XDG_CACHE_HOME` or `~/.cache` else.

    Raises:
        OutputFault: If it cannot be created.
        UsageError: If somebody else could have filled it.
    """
    folder = _cache_path()
    if folder.is_dir() and _is_strange(folder):
        raise UsageError(
            f"cache folder {folder}: others may write to it, but what lies there is believed; "
            "set BVHGRADE_CACHE to a folder of your own"
        )
    return _made(folder, 0o711)


def _is_strange(folder: Path) -> bool:
    state = folder.stat()
    return state.st_uid != os.geteuid() or bool(state.st_mode & 0o022)


def is_root() -> bool:
    """This process may become any user."""
    return os.geteuid() == 0


def shared_cache(name: str) -> Path:
    """A folder in the cache that confined processes may read too.

    Raises:
        OutputFault: If it cannot be created.
    """
    return _made(cache_folder() / name, 0o755)


def private_cache(name: str) -> Path:
    """A folder in the cache for answers and the like, which only the grader's user may read.

    Raises:
        OutputFault: If it cannot be created.
    """
    return _made(cache_folder() / name, 0o700)


def _made(folder: Path, mode: int) -> Path:
    try:
        folder.mkdir(mode=mode, parents=True, exist_ok=True)
        # The mode of mkdir is cut by the caller's umask, and the folder may be an older one.
        if stat.S_IMODE(folder.stat().st_mode) != mode:
            folder.chmod(mode)
    except OSError as fault:
        raise OutputFault(
            f"cache folder {folder}: {fault.strerror}, but the grader keeps its compiled "
            "framework there; set BVHGRADE_CACHE to a folder that can be written"
        ) from fault
    return folder


def _cache_path() -> Path:
    if named := os.environ.get("BVHGRADE_CACHE"):
        # Without `..`, which cmake writes otherwise than it was given.
        return Path(named).resolve()
    if is_root():
        return Path("/var/cache/bvhgrade")
    if shared := os.environ.get("XDG_CACHE_HOME"):
        return Path(shared).absolute() / "bvhgrade"
    try:
        return Path.home() / ".cache" / "bvhgrade"
    except RuntimeError as fault:
        raise OutputFault(
            "nobody knows where the cache belongs, because this user has no home; set "
            "BVHGRADE_CACHE to a folder that can be written"
        ) from fault


def _folder(name: str, package: Path) -> Path:
    checkout = package.parent
    if (checkout / "pyproject.toml").is_file() and (checkout / name).is_dir():
        return checkout / name
    if (package / "data" / name).is_dir():
        return package / "data" / name
    raise GraderError(
        f"{name}: neither beside {package} nor in {package / 'data'}, but the grader ships it; "
        "the installation is damaged, install bvhgrade again"
    )
