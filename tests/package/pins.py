"""Writes `grader/package/exercise.sha256`: `python -m tests.package.pins`.

Only the files that git keeps belong to the exercise. Read `git diff student_stub` first.
"""

import hashlib
import subprocess
from pathlib import Path

from grader.package.exercise import PINS
from tests.own_files import ROOT

STUB = ROOT / "student_stub"


def table() -> str:
    """Write a line a file, as `sha256sum` does."""
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=STUB, capture_output=True, text=True, check=True
    )
    names = sorted(name for name in listed.stdout.split("\0") if name)
    return "".join(
        f"{hashlib.sha256((STUB / name).read_bytes()).hexdigest()}  {name}\n" for name in names
    )


def main(path: Path = PINS) -> None:
    """Write the list anew."""
    path.write_text(table(), encoding="utf-8")


if __name__ == "__main__":
    main()
