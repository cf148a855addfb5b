"""Debian's Chromium, without a graphics card."""

import shutil

SOFTWARE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
"""WebGL without a graphics card."""


def chromium() -> str:
    """Find Debian's Chromium.

    Raises:
        RuntimeError: There is none, and a test that cannot run is red.
    """
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if found is None:
        raise RuntimeError("chromium is not installed: sudo apt-get install chromium")
    return found
