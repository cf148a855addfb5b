"""Which files of this checkout are ours, for the tests of style and architecture."""

from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parent.parent


def python_files(*folders: str) -> Iterator[Path]:
    """Every Python file of ours below these folders."""
    for folder in folders:
        yield from sorted((ROOT / folder).rglob("*.py"))


def cpp_files(pattern: str) -> Iterator[Path]:
    """Every C++ file of ours with such a name."""
    for folder in ("student_stub", "reference"):
        for path in sorted((ROOT / folder).rglob(pattern)):
            if "build" not in path.relative_to(ROOT).parts:
                yield path


def texts() -> Iterator[Path]:
    """Every file that a person wrote: code, settings, scripts, documents."""
    endings = {
        ".py",
        ".cpp",
        ".h",
        ".md",
        ".toml",
        ".txt",
        ".yaml",
        ".json",
        ".sh",
        ".html",
        "",
    }
    skipped = {"bvhgrade-out", "dist", "__pycache__"}
    waiting = [ROOT]
    while waiting:
        for path in sorted(waiting.pop().iterdir()):
            hidden_folder = path.is_dir() and path.name.startswith(".") and path.name != ".ci"
            compiled = path == ROOT / "student_stub" / "build"
            if path.name in skipped or hidden_folder or compiled or path.is_symlink():
                continue
            if path.is_dir():
                waiting.append(path)
            elif path.suffix in endings:
                yield path
