"""How does an archive get the same bytes whenever it is made? It holds no time and no order."""

import io
import zipfile
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The first moment that a zip can hold."""

UNIX = 3
COMPRESSED = (".npz", ".png", ".whl")
"""Files that are compressed already."""

LEFTOVERS = ("__pycache__", ".DS_Store")


@dataclass(frozen=True, slots=True)
class Member:
    """A file of an archive."""

    name: str
    """Relative path with slashes."""

    data: bytes
    executable: bool = False


def zipped(members: Iterable[Member]) -> bytes:
    """Pack files, in the order of their names.

    Raises:
        ValueError: Two have the same name.
    """
    packed, names = io.BytesIO(), set[str]()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for member in sorted(members, key=lambda one: one.name):
            if member.name in names:
                raise ValueError(f"{member.name} is packed twice")
            names.add(member.name)
            entry = zipfile.ZipInfo(member.name, EARLIEST)
            done = member.name.endswith(COMPRESSED)
            entry.compress_type = zipfile.ZIP_STORED if done else zipfile.ZIP_DEFLATED
            # Set here, because the default is another one on Windows.
            entry.create_system = UNIX
            entry.external_attr = (0o100755 if member.executable else 0o100644) << 16
            archive.writestr(entry, member.data)
    return packed.getvalue()


def below(folder: str, members: Iterable[Member]) -> tuple[Member, ...]:
    """Put files into a folder of the archive."""
    return tuple(replace(one, name=f"{folder}/{one.name}") for one in members)


def files_of(folder: Path, without: Iterable[str] = ()) -> tuple[Member, ...]:
    """Read all files of a folder, but nothing that a compiler or an interpreter left behind.

    Args:
        folder: What to read.
        without: Names of folders at its top to leave out.
    """
    left_out = frozenset(without)
    found = []
    for path in sorted(folder.rglob("*")):
        inside = path.relative_to(folder)
        if not path.is_file() or inside.parts[0] in left_out:
            continue
        if not any(part in LEFTOVERS for part in inside.parts):
            found.append(Member(inside.as_posix(), path.read_bytes(), _runs(path)))
    return tuple(found)


def _runs(path: Path) -> bool:
    return bool(path.stat().st_mode & 0o100)
