"""What do the submissions in `right/` and `wrong/` say of themselves in their first lines?"""

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

from grader import resources
from grader.errors import UsageError

EXPECT = re.compile(r"^// expect: (?P<checks>[a-z0-9.-]+(?:, [a-z0-9.-]+)*)$")
UNTOUCHED = re.compile(r"^// untouched: (?P<part>[ab-])$")
MISTAKE = re.compile(r"^// mistake: (?P<sentence>\S.*)$")
RIGHT = re.compile(r"^// right: (?P<sentence>\S.*)$")


@dataclass(frozen=True, slots=True)
class Wrong:
    """A submission with one mistake."""

    path: Path
    checks: tuple[str, ...]
    """Checks that must fail; the first one owns the mistake."""

    untouched: str
    """The part that must keep all its points; `-` if the mistake is in both."""


def checkout() -> Path:
    """Find the folder of the checkout that this package lies in.

    Raises:
        UsageError: It is an installed wheel, which has no tests.
    """
    folder = resources.stub_folder().parent
    if not (folder / "tests" / "submissions").is_dir():
        raise UsageError(
            "certify grades the submissions below tests/ of a checkout, which an installed "
            "bvhgrade does not have; clone the project and call it there"
        )
    return folder


def corpus_folder() -> Path:
    """Find the folder that holds `right/` and `wrong/`."""
    return checkout() / "tests" / "submissions"


def right_submissions() -> list[Path]:
    """Files that must earn everything."""
    return sorted((corpus_folder() / "right").glob("*.cpp"))


def wrong_submissions() -> list[Wrong]:
    """Files with one mistake each, and what they expect of the grader."""
    return [read_wrong(path) for path in sorted((corpus_folder() / "wrong").glob("*.cpp"))]


def every_submission() -> list[Path]:
    """The right files, and the wrong ones."""
    return [*right_submissions(), *(one.path for one in wrong_submissions())]


def read_wrong(path: Path) -> Wrong:
    """Read the three header lines of a wrong submission.

    Raises:
        ValueError: One of them is missing or malformed.
    """
    head = path.read_text(encoding="utf-8-sig").splitlines()[:3]
    patterns = (EXPECT, UNTOUCHED, MISTAKE)
    matches = [pattern.match(line) for pattern, line in zip(patterns, head, strict=True)]
    expect, untouched, mistake = matches
    if not (expect and untouched and mistake):
        message = f"{path.name}: the first three lines must be expect, untouched and mistake"
        raise ValueError(message)
    return Wrong(path, tuple(expect["checks"].split(", ")), untouched["part"])


def name_of(path: Path) -> str:
    """Folder and file."""
    return f"{path.parent.name}/{path.name}"


def digest_of(path: Path) -> str:
    """What ties a row to the file that was graded."""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:12]
