"""Libraries of hostile and right sources, compiled once for all tests of workers."""

from pathlib import Path

import pytest

from grader import resources
from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.run.session import Engine
from tests.compiled import BEGIN, INTERSECT, engine_of, library_of, whole_build

HOSTILE = Path(__file__).with_name("hostile.cpp")


@pytest.fixture(scope="session")
def hostile(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Engine, Engine]:
    """Give the graded and the sanitized engine of `hostile.cpp`."""
    build = whole_build(HOSTILE.read_text(), tmp_path_factory.mktemp("hostile"))
    assert build.library, build.diagnostics
    assert build.sanitized
    runtime = sanitizer_runtime(find_compiler())
    return (
        engine_of(build.library),
        engine_of(build.sanitized, runtime),
    )


@pytest.fixture(scope="session")
def reference(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give the engine of the model solution."""
    source = resources.reference_source().read_text()
    return engine_of(library_of(source, tmp_path_factory.mktemp("reference")))


@pytest.fixture(scope="session")
def crashing_at_load(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give a library whose static constructor crashes and that defines no construct."""
    crash = "static int crash = *reinterpret_cast<volatile int*>(sizeof(char) - 1);\n"
    folder = tmp_path_factory.mktemp("crash")
    return engine_of(library_of(BEGIN + INTERSECT + crash, folder))


@pytest.fixture(scope="session")
def half(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give a library that defines only intersect."""
    folder = tmp_path_factory.mktemp("half")
    return engine_of(library_of(BEGIN + INTERSECT, folder))
