"""What does the page say, and where is it to be opened?"""

import socket
import sys
from collections.abc import Sequence
from pathlib import Path

from grader.counterexample.reading import LARGEST
from grader.language import Words, translator
from grader.plain import as_name
from grader.report.html import page as pages
from grader.view.dropped import LARGEST_MESH
from grader.view.needed import has_display
from grader.view.picture import titles

HERE = "127.0.0.1"


def invitation(port: int, words: Words) -> str:
    """Say where the address is to be opened."""
    if sys.platform != "linux" or has_display():
        return words("Open this address in a browser of this machine; Ctrl-C ends:")
    text = words(
        "There is no display here. Run `ssh -L {port}:{here}:{port} {machine}` on your own "
        "machine and open this address there; Ctrl-C ends:"
    )
    return text.format(port=port, here=HERE, machine=socket.gethostname())


def written(path: Path, scenes: Sequence[str], language: str) -> str:
    """Write the page."""
    words = translator(language)
    told = {
        "step": words("step {step} of {steps}"),
        "box": words("node {node}"),
        "triangle": words("face {face}"),
        "unknown": words("something else"),
        "hit": words("hit"),
        "missed": words("missed"),
        "lost": words("lost here"),
        "gone": words("The program has ended; start it again."),
        "large": words("{name} has more than {most} bytes."),
    }
    most = {"json": LARGEST, "mesh": LARGEST_MESH}
    name = f"bvhgrade view {as_name(path.name)}"
    values = {
        "title": name,
        "name": name,
        "scenes": list(scenes),
        "modes": [(mode.value, title) for mode, title in titles(words).items()],
    }
    return pages.page("view", language, values, {"data": {"words": told, "most": most}})
