"""Archives for the tests of the intake, right and hostile ones."""

import io
import tarfile
import zipfile
from collections.abc import Sequence

Entries = Sequence[tuple[str, bytes]]


def zipped(entries: Entries) -> bytes:
    """Pack a zip; the same name may come twice."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries:
            archive.writestr(_info(name), content, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def _info(name: str) -> zipfile.ZipInfo:
    # Through a list, because the constructor cuts names at a NUL.
    info = zipfile.ZipInfo("x")
    info.filename = name
    return info


def linked_zip(name: str, target: str) -> bytes:
    """Pack a zip whose only entry is a symbolic link."""
    packed = io.BytesIO()
    info = zipfile.ZipInfo(name)
    info.create_system = 3
    info.external_attr = 0o120777 << 16
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr(info, target)
    return packed.getvalue()


def tarred(entries: Entries, mode: str = "gz") -> bytes:
    """Pack a tar.gz, or with another mode a tar or tar.xz."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode=f"w:{mode}") as archive:  # type: ignore[call-overload]  # the mode is put together
        for name, content in entries:
            info = tarfile.TarInfo(name)
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    return packed.getvalue()


def special_tar(name: str, kind: bytes) -> bytes:
    """Pack a tar.gz whose only entry is a link, a pipe or a device."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as archive:
        info = tarfile.TarInfo(name)
        info.type, info.linkname = kind, "/etc/passwd"
        archive.addfile(info)
    return packed.getvalue()
