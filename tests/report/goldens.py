"""Terminal reports as files: `python -m tests.report.goldens` writes them anew."""

import io
from dataclasses import dataclass
from pathlib import Path

from rich.console import Console

from grader.model.grade import Grade
from grader.report.failure import Occasion
from grader.report.terminal import print_grade
from tests.report import samples

FOLDER = Path(__file__).with_suffix("")

OCCASION = Occasion(
    command="bvhgrade check src/exercise03.cpp --seed 41",
    written=Path("bvhgrade-out/report.html"),
    viewer="bvhgrade view src/exercise03.cpp",
)


@dataclass(frozen=True, slots=True)
class Screen:
    """What a report is printed on."""

    width: int = 80
    terminal: bool = False
    no_color: bool = False
    encoding: str = "utf-8"


SCREENS = {
    "56": Screen(width=56),
    "80": Screen(),
    "120": Screen(width=120),
    "color": Screen(terminal=True),
    "no-color": Screen(terminal=True, no_color=True),
    "cp1252": Screen(encoding="cp1252"),
}


def printed(grade: Grade, screen: Screen, occasion: Occasion = OCCASION) -> bytes:
    """Print a report on a screen of memory and return the bytes that a terminal would get."""
    memory = io.BytesIO()
    stream = io.TextIOWrapper(memory, encoding=screen.encoding, newline="\n")
    environment = {"TERM": "xterm-256color", **({"NO_COLOR": "1"} if screen.no_color else {})}
    console = Console(
        file=stream,
        width=screen.width,
        force_terminal=screen.terminal,
        color_system="256" if screen.terminal else None,
        _environ=environment,
    )
    print_grade(console, grade, occasion)
    stream.flush()
    return memory.getvalue()


def cases() -> dict[str, tuple[str, str]]:
    """Name each golden file: every grade in a pipe, and failures on every screen."""
    files = {f"{name}-80.txt": (name, "80") for name in samples.EVERY}
    files |= {f"failing-{screen}.txt": ("failing", screen) for screen in SCREENS}
    files |= {f"uncompiled-{width}.txt": ("uncompiled", width) for width in ("56", "120")}
    return files


def main() -> None:
    """Write every golden file."""
    FOLDER.mkdir(exist_ok=True)
    for name, (sample, screen) in cases().items():
        (FOLDER / name).write_bytes(printed(samples.EVERY[sample](), SCREENS[screen]))


if __name__ == "__main__":
    main()
