"""What is said where a package or a display is missing."""

import os

from grader.errors import MissingTool
from grader.plain import one_line

INSTALL = 'the viewer needs more packages: pip install "bvhgrade[view]"'
BROKEN = (
    "a package of the viewer is installed, but cannot be loaded ({fault}); bvhgrade view --web "
    "needs none of them"
)
NO_DISPLAY = (
    "no window can be opened here: there is no display, or it has no OpenGL 3.3. "
    "bvhgrade view --web shows the same in a browser, --screenshot FILE.png draws it into a "
    "file"
)


def has_display() -> bool:
    """Whether the environment names a display of X11 or of Wayland."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def lacking(fault: ImportError) -> MissingTool:
    """Say which is the matter: a package is not there, or something keeps it from loading."""
    if isinstance(fault, ModuleNotFoundError):
        return MissingTool(INSTALL)
    return MissingTool(BROKEN.format(fault=one_line(str(fault), 300)))
