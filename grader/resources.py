"""Where do the exercise's own files lie, in a checkout and in an installed wheel?

A checkout has `student_stub/`, `reference/` and `scenes/` beside the package; a wheel carries
the same folders below `grader/data/`. A checkout wins: an editable install sees its edits.
"""

import os
from pathlib import Path

from grader.errors import GraderError, OutputFault

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
    return _folder("reference", package) / "src" / "exercise03.cpp"


def scenes_folder(package: Path = _PACKAGE) -> Path:
    """Meshes and the references that Mitsuba rendered of them.

    Args:
        package: Folder of the `grader` package; only tests name another one.
    """
    return _folder("scenes", package)


def cache_folder() -> Path:
    """A folder of this user that survives the run and that nobody else may read.

    `BVHGRADE_CACHE` names it; otherwise it is `bvhgrade` in `XDG_CACHE_HOME` or `~/.cache`.

    Raises:
        OutputFault: If it cannot be created.
    """
    folder = _cache_path()
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as fault:
        raise OutputFault(
            f"cache folder {folder}: {fault.strerror}, but the grader keeps its compiled "
            "framework there; set BVHGRADE_CACHE to a folder that can be written"
        ) from fault
    return folder


def _cache_path() -> Path:
    if named := os.environ.get("BVHGRADE_CACHE"):
        return Path(named).absolute()
    if shared := os.environ.get("XDG_CACHE_HOME"):
        return Path(shared).absolute() / "bvhgrade"
    return Path.home() / ".cache" / "bvhgrade"


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
