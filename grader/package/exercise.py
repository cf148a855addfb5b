"""What is the exercise that students get? Files of a pinned list, each as it was written down.

The grader looks for a solution where the starter lies if none is named, so whoever tries the
exercise there leaves a solution in it, and notes beside it. Neither may reach students.
"""

import hashlib
from pathlib import Path

from grader import resources
from grader.errors import UsageError
from grader.model.stages import SOURCE_PATH
from grader.package.archive import Member

PINS = Path(__file__).with_name("exercise.sha256")
"""Written by `python -m tests.package.pins`, read by `sha256sum --check` as well."""


def exercise() -> tuple[Member, ...]:
    """Read the exercise as students get it, and nothing else that lies there.

    Raises:
        UsageError: A file is missing, or another one than was written down.
    """
    return tuple(Member(name, _read(name, sha256)) for name, sha256 in pins().items())


def starter() -> bytes:
    """Read what students begin with.

    Raises:
        UsageError: It is missing, or another one than was written down.
    """
    return _read(SOURCE_PATH, pins()[SOURCE_PATH])


def pins() -> dict[str, str]:
    """Map the exercise's files to their sha256."""
    lines = PINS.read_text(encoding="utf-8").splitlines()
    return {name: sha256 for sha256, name in (line.split("  ", 1) for line in lines)}


def _read(name: str, sha256: str) -> bytes:
    path = resources.stub_folder() / name
    kept = "move your work elsewhere, and put the file back as it was"
    if not path.is_file():
        raise UsageError(f"{path}: this file of the exercise is missing; {kept}")
    data = path.read_bytes()
    if hashlib.sha256(data).hexdigest() != sha256:
        raise UsageError(
            f"{path}: not what students are to get, and it may hold a solution; {kept}; "
            "whoever develops the exercise pins it anew, as CONTRIBUTING.md says"
        )
    return data
