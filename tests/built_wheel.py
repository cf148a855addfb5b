"""The wheel as the project's own build makes it."""

import os
import subprocess
import sys
from pathlib import Path

from tests.own_files import ROOT


def built_wheel(folder: Path) -> Path:
    """Build it into a folder, with nothing of this checkout in the environment."""
    command = [sys.executable, "-m", "build", "--no-isolation", "--wheel", "-o", str(folder)]
    kept = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
    built = subprocess.run(
        [*command, str(ROOT)], cwd=folder, env=kept, capture_output=True, text=True, check=False
    )
    assert built.returncode == 0, built.stdout + built.stderr
    (wheel,) = folder.glob("bvhgrade-*.whl")
    return wheel
