"""Are these bytes fit to be compiled?"""

import hashlib

from grader.model.stages import Rejected, Submission

_SAMPLE = 4096
_WIDE_MARKS = (b"\xff\xfe", b"\xfe\xff", b"\x00\x00\xfe\xff")
_UTF8_MARK = b"\xef\xbb\xbf"
_ARCHIVE_MARKS = (b"PK\x03\x04", b"PK\x05\x06", b"\x1f\x8b", b"Rar!", b"7z\xbc\xaf")


def screen(student: str, path: str, source: bytes, source_limit: int) -> Submission | Rejected:
    """Accept the bytes of a source file, or say what is wrong with them.

    Args:
        student: Who handed it in, printable.
        path: Where the file lay, printable.
        source: At most `source_limit` + 1 bytes of it.
        source_limit: Largest size in bytes.
    """
    reason = _fault(source, source_limit)
    if reason:
        return Rejected(student, f"{path}: {reason}")
    return Submission(student, path, source, hashlib.sha256(source).hexdigest())


def _fault(source: bytes, source_limit: int) -> str:
    if len(source) > source_limit:
        return (
            f"the file is larger than {source_limit // 1024:,} KiB, the most that is accepted"
        )
    if source.startswith(_ARCHIVE_MARKS):
        return (
            "this is an archive with the name of a source file; hand it in under its own name"
        )
    if _is_wide(source):
        return (
            "the file is saved as UTF-16, but the compiler reads UTF-8; save it again as UTF-8 "
            '(VS Code: "Save with Encoding" in the status bar; Visual Studio: "Save As", then '
            '"Save with Encoding"; Notepad: the list beside "Save")'
        )
    if not source.removeprefix(_UTF8_MARK).strip():
        return "the file is empty; was it saved before it was handed in?"
    return ""


def _is_wide(source: bytes) -> bool:
    """UTF-16 or UTF-32: a byte order mark, or every second byte of a Latin text is zero."""
    if source.startswith(_WIDE_MARKS):
        return True
    sample = source[:_SAMPLE]
    even, odd = sample[0::2], sample[1::2]
    zeros = max(even.count(0), odd.count(0))
    return len(sample) >= 4 and zeros * 4 > len(sample)
