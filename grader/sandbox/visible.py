"""Which files of the system does a confined process need?"""

from collections.abc import Iterator
from pathlib import Path

from grader.sandbox.box import Box
from grader.sandbox.interpreter import libraries_of

LIBRARIES = (
    "/usr/lib",
    "/usr/lib32",
    "/usr/lib64",
    "/usr/libx32",
    "/usr/local/lib64",
    "/lib",
    "/lib32",
    "/lib64",
    "/libx32",
    "/etc/ld.so.cache",
)
"""What any program needs to start; a folder that is a link to another one stays a link."""

PROGRAMS = (
    "/usr/bin",
    "/bin",
    "/usr/include",
    "/usr/libexec",
    "/usr/share",
    "/usr/local/bin",
    "/usr/local/include",
    "/usr/local/libexec",
    "/usr/local/lib/gcc",
    "/etc/alternatives",
)
"""What a compiler needs besides."""

DEVICES = ("/dev/null", "/dev/zero", "/dev/random", "/dev/urandom")
_PACKAGES = ("site-packages", "dist-packages")


def system_paths(box: Box) -> list[Path]:
    """Folders of the system that a box shows, those that exist."""
    names = LIBRARIES + (PROGRAMS if box.starts_programs else ())
    return [path for path in map(Path, names) if path.exists()]


def interpreter_paths(interpreter: Path) -> list[Path]:
    """What the interpreter needs until the process is confined."""
    return [interpreter, libraries_of(interpreter)]


def hidden_folders(shown: list[Path]) -> Iterator[Path]:
    """Folders of installed packages below what is shown: the grader may be one of them."""
    for root in {path.resolve() for path in shown if path.is_dir()}:
        for name in _PACKAGES:
            yield from (path for path in root.glob(f"python3*/{name}") if path.is_dir())
