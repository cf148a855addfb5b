"""What is said where a package or a display is missing."""

import os

INSTALL = 'the viewer needs more packages: pip install "bvhgrade[view]"'
NO_DISPLAY = (
    "no window can be opened here: there is no display, or it has no OpenGL 3.3. "
    "bvhgrade view --web shows the same in a browser, --screenshot FILE.png draws it into a "
    "file"
)


def has_display() -> bool:
    """Whether the environment names a display of X11 or of Wayland."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
