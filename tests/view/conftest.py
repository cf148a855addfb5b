"""Engines of submissions, compiled once, and displays that nobody sees."""

import shutil
import subprocess
from collections.abc import Callable, Generator, Iterator
from pathlib import Path

import pytest

from grader import resources
from grader.run.session import Engine
from grader.view.stage import Stage
from grader.view.subject import Subject
from tests.compiled import engine_of, library_of
from tests.view import sources
from tests.view.found import middle
from tests.view.served import Open, opened

Compiled = Callable[[str], Engine]
Staged = Callable[..., Stage]


@pytest.fixture(scope="session")
def compiled(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Compiled:
    """Give what compiles a source, each one once."""
    known: dict[str, Engine] = {}

    def engine(source: str) -> Engine:
        if source not in known:
            known[source] = engine_of(library_of(source, tmp_path_factory.mktemp("view")))
        return known[source]

    return engine


@pytest.fixture(scope="session")
def right(compiled: Compiled) -> Engine:
    """Give the engine of the model solution."""
    return compiled(resources.reference_source().read_text())


@pytest.fixture
def staged() -> Iterator[Staged]:
    """Give what puts a subject on a stage; all of them are closed at the end."""
    stages: list[Stage] = []

    def stage(subject: Subject, engine: Engine) -> Stage:
        stages.append(Stage(subject, engine))
        return stages[-1]

    yield stage
    for one in stages:
        one.close()


@pytest.fixture(scope="session")
def display() -> Generator[str]:
    """Start an X server without a screen, and name it.

    Raises:
        RuntimeError: There is none, and a test that cannot run is red.
    """
    program = shutil.which("Xvfb")
    if program is None:
        raise RuntimeError("Xvfb is not installed: sudo apt-get install xvfb")
    words = [program, "-displayfd", "1", "-screen", "0", "1600x1000x24", "-nolisten", "tcp"]
    with subprocess.Popen(
        words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as server:
        assert server.stdout is not None
        number = server.stdout.readline().strip()
        assert number, "Xvfb did not start"
        yield f":{number}"
        server.terminate()


@pytest.fixture(scope="module")
def house(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Open]:
    """Serve a right submission."""
    file = tmp_path_factory.mktemp("web") / "exercise03.cpp"
    file.write_text(sources.reference())
    with opened(file) as found:
        yield found


@pytest.fixture
def file(cache: Path, tmp_path: Path) -> Path:
    """Give a submission that loses half of the rays."""
    path = tmp_path / "exercise03.cpp"
    path.write_text(sources.tracing(f"if (ray.direction.y > {middle()}) {{ return {{}}; }}"))
    return path
