"""Which libraries are timed, and how are they built? All from sources of ours."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from grader import resources
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, Workspace, workspace
from grader.errors import BuildFault
from grader.model.stages import SOURCE_NAME
from grader.sandbox.launch import Order, launch

DATA = Path(__file__).with_name("data")
TEXTBOOK = DATA / "textbook.cpp"
COMPILE_SECONDS = 3600.0

_COUNTING = re.compile(rb"^.*\+\+ex03::counters\..*\n", re.MULTILINE)
_RECORDING = re.compile(rb"^    if \(ex03::path != nullptr\).*\n.*\n    \}\n", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Libraries:
    """The graded builds of the solutions that are compared."""

    textbook: Path
    clear: Path
    fast: Path
    uncounted: Path
    """The clear solution in a framework whose given tests count and record nothing."""


def build_libraries(folder: Path) -> Libraries:
    """Compile everything that is timed.

    Raises:
        BuildFault: One of them does not compile.
    """
    return Libraries(
        _library(TEXTBOOK, folder / "textbook"),
        _library(resources.reference_source(), folder / "clear"),
        _library(resources.fast_source(), folder / "fast"),
        _uncounted(folder / "uncounted"),
    )


def by_hand(framework: Workspace) -> tuple[str, ...]:
    """Return the command that compiles without what the grader precompiled."""
    return without_headers(framework.compile_command)


def without_headers(command: Sequence[str]) -> tuple[str, ...]:
    """Take what the grader precompiled out of a command."""
    words = list(command)
    while "-include" in words:
        place = words.index("-include")
        del words[place : place + 2]
    return tuple(words)


def _library(source: Path, folder: Path) -> Path:
    """Build a graded library, with as much time as a busy machine needs."""
    framework = workspace(find_compiler(), GRADED)
    folder.mkdir(parents=True)
    library = folder / "graded.so"
    words = [*framework.compile_command, str(source), *framework.link_words]
    outcome = launch(Order([*words, "-o", str(library)], COMPILE_SECONDS))
    if outcome.code != 0:
        said = outcome.err.decode(errors="replace")[-500:]
        raise BuildFault(f"{source} does not compile, but the bench times it: {said}")
    return library


def _uncounted(folder: Path) -> Path:
    """Build the clear solution with given tests whose counters were taken out."""
    stub = resources.stub_folder()
    folder.mkdir(parents=True)
    given = folder / "intersection.cpp"
    text = (stub / "src" / "intersection.cpp").read_bytes()
    given.write_bytes(_RECORDING.sub(b"", _COUNTING.sub(b"", text)))
    sources = [path for path in (stub / "src").glob("*.cpp") if path.name not in _REPLACED]
    sources += [given, *(stub / "abi").glob("*.cpp"), resources.reference_source()]
    library = folder / "uncounted.so"
    words = [*by_hand(workspace(find_compiler(), GRADED)), "-w", "-DEX03_SPARE=64"]
    words += [f"-I{stub / name}" for name in ("src", "abi")]
    words += ["-ftls-model=initial-exec", "-shared", "-Wl,-Bsymbolic", "-pthread"]
    outcome = launch(Order([*words, *map(str, sources), "-o", str(library)], COMPILE_SECONDS))
    if outcome.code != 0:
        said = outcome.err.decode(errors="replace")[-500:]
        raise BuildFault(f"the framework without counters does not build: {said}")
    return library


_REPLACED = ("intersection.cpp", SOURCE_NAME)
