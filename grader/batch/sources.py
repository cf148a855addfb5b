"""What lies at the top of a class's folder or zip, and what is in each thing there?

Nothing is extracted: the names of a zip are compared and shown, never used as paths, and a
folder is entered by descriptors, through no link. Who fills a class's folder is a class.
"""

import os
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from errno import EIO
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import BinaryIO, Protocol

from grader.errors import UsageError
from grader.intake.candidates import NOT_A_FILE, Damage, Entry, Fault, is_junk, parts
from grader.intake.folder import folder_entries, opened
from grader.intake.zip import ZIP_MARKS, zip_entries
from grader.output import STORE
from grader.plain import as_name

MOST_ITEMS = 20_000
"""Things at the top of a class; more is no class."""

MOST_LISTED = 1_000_000
"""Files in a class's zip, without hidden ones."""

LARGEST_NOTES = 256 << 20
"""Bytes of a file that a learning system adds to a download."""


@dataclass(frozen=True, slots=True)
class Item:
    """A file or folder at the top of a class."""

    name: str
    """As a stranger named it."""

    is_folder: bool
    holds_store: bool = False
    """Whether a file in it is called like the store of a class; anybody can do that."""


class Source(Protocol):
    """A class, wherever it lies."""

    def items(self) -> list[Item]:
        """Name what lies at its top, hidden things left out, sorted."""

    def entries(self, name: str) -> Iterator[Entry]:
        """List everything in one of these, with paths that begin there; a file is itself.

        Raises:
            OSError: It is gone, or may not be read.
        """

    def within(self, name: str) -> "Source":
        """Take one of its folders for the class."""


@dataclass(frozen=True, slots=True)
class ClassFolder:
    """A folder on this machine."""

    folder: Path

    def items(self) -> list[Item]:
        """Name what lies at its top.

        Raises:
            UsageError: It cannot be read, or it is no class.
        """
        found: list[Item] = []
        try:
            with os.scandir(self.folder) as listed:
                for each in listed:
                    if not is_junk(each.name):
                        found.append(_item(each))
                    if len(found) > MOST_ITEMS:
                        raise _too_many(str(self.folder), MOST_ITEMS)
        except OSError as fault:
            shown = as_name(str(self.folder))
            raise UsageError(f"{shown}: {fault.strerror}, but a class lies there") from fault
        return sorted(found, key=lambda item: item.name)

    def entries(self, name: str) -> Iterator[Entry]:
        """List everything in one item; a folder of it that cannot be read is a fault of all.

        Raises:
            OSError: A folder in it cannot be read.
        """
        handle = opened(self.folder / name)
        if isinstance(handle, Fault):
            yield Entry(name, partial(_always, handle))
            return
        unread: list[OSError] = []
        try:
            if stat.S_ISDIR(os.fstat(handle).st_mode):
                yield from folder_entries(handle, unread)
            else:
                yield Entry(name, partial(_read, handle))
        finally:
            os.close(handle)
        if unread:
            raise unread[0]

    def within(self, name: str) -> "ClassFolder":
        """Take one of its folders for the class."""
        return ClassFolder(self.folder / name)


def _item(entry: os.DirEntry[str]) -> Item:
    is_folder = entry.is_dir(follow_symlinks=False)
    # Not Path.exists, which raises where the folder may not be entered.
    holds_store = is_folder and os.path.exists(Path(entry.path) / STORE)  # noqa: PTH110 - above
    return Item(entry.name, is_folder, holds_store)


class ClassZip:
    """A zip, of which only the list of contents is kept."""

    def __init__(self, listed: dict[str, list[Entry]]) -> None:
        """Take what was listed, by the first part of its path."""
        self._listed = listed

    def items(self) -> list[Item]:
        """Name what lies at its top."""
        return [
            Item(name, any("/" in entry.path for entry in entries))
            for name, entries in sorted(self._listed.items())
        ]

    def entries(self, name: str) -> Iterator[Entry]:
        """List everything in one item."""
        for entry in self._listed[name]:
            inside = entry.path.partition("/")[2]
            if inside or "/" not in entry.path:
                yield Entry(inside or name, partial(_whole, entry.read))

    def within(self, name: str) -> "ClassZip":
        """Take one of its folders for the class."""
        return ClassZip(_by_top(self.entries(name), name))


def _whole(read: Callable[[int], bytes | Fault], most: int) -> bytes | Fault:
    """Read a file of the class's zip, which the student did not pack.

    Raises:
        OSError: The zip does not give it back.
    """
    content = read(most)
    if isinstance(content, Fault) and content != NOT_A_FILE:
        why = "the class's zip does not give it back; download it again, or unpack it yourself"
        raise OSError(EIO, why)
    return content


def class_zip(file: BinaryIO, shown: str) -> ClassZip:
    """Read the list of contents of a class's zip.

    Args:
        file: The zip; it stays open as long as contents are read.
        shown: What it is called in a message.

    Raises:
        UsageError: It is no zip, or not all of it is there.
    """
    if not file.read(4).startswith(ZIP_MARKS):
        raise UsageError(f"{shown}: this is no zip, but a folder or a .zip is expected")
    try:
        return ClassZip(_by_top(zip_entries(file), shown))
    except Damage as damage:
        raise UsageError(f"{shown}: the zip is damaged; download it again") from damage


def _by_top(entries: Iterator[Entry], shown: str) -> dict[str, list[Entry]]:
    listed: dict[str, list[Entry]] = {}
    number = 0
    for entry in entries:
        path = "/".join(part for part in parts(entry.path) if part not in {"", "."})
        if not path or is_junk(path):
            continue
        number += 1
        if number > MOST_LISTED:
            raise _too_many(shown, MOST_LISTED)
        # What ends with `/` stays a folder, although it may be empty.
        path += "/" if entry.path.endswith(("/", "\\")) else ""
        listed.setdefault(path.partition("/")[0], []).append(Entry(path, entry.read))
    return listed


def notes(source: Source, name: str) -> BinaryIO:
    """Read a file that a learning system put at the top, which says who everybody is.

    Raises:
        UsageError: It cannot be read as a whole, so that somebody's name would be lost.
    """
    shown = as_name(name)
    try:
        content = next((one.read(LARGEST_NOTES + 1) for one in source.entries(name)), None)
    except OSError as fault:
        raise UsageError(f"{shown}: {fault.strerror}, but it holds the names") from fault
    if content is None or isinstance(content, Fault):
        raise UsageError(f"{shown}: this is no file, but one with the names is expected")
    if len(content) > LARGEST_NOTES:
        raise UsageError(
            f"{shown}: more than {LARGEST_NOTES >> 20} MiB, so nobody knows whether all names "
            "are read; leave only the names in it, as docs/operator.md says"
        )
    return BytesIO(content)


def _too_many(shown: str, most: int) -> UsageError:
    return UsageError(f"{as_name(shown)}: more than {most:,} files, but a class is expected")


def _always(fault: Fault, _: int) -> Fault:
    return fault


def _read(handle: int, most: int) -> bytes:
    with os.fdopen(os.dup(handle), "rb") as file:
        return file.read(most)


@contextmanager
def opened_class(path: Path) -> Iterator[Source]:
    """Open the folder or zip of a class.

    Raises:
        UsageError: It is neither, or cannot be read.
    """
    shown = as_name(str(path))
    try:
        folder = path.resolve() if path.is_dir() else None
        file = None if folder else path.open("rb")
    except OSError as fault:
        raise UsageError(f"{shown}: {fault.strerror}, but a class lies there") from fault
    if folder:
        yield ClassFolder(folder)
    elif file:
        with file:
            yield class_zip(file, shown)
