"""What is said where a package or a display is missing."""

INSTALL = 'the viewer needs more packages: pip install "bvhgrade[view]"'
NO_DISPLAY = (
    "no window can be opened here: there is no display, or it has no OpenGL 3.3. "
    "bvhgrade view --web shows the same in a browser, --screenshot FILE.png draws it into a "
    "file"
)
