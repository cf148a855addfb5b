"""The stub, built once with the reference and once with the unedited starter."""

import ctypes
from pathlib import Path

import pytest

from tests.student_stub.library import REFERENCE, build, load


@pytest.fixture(scope="session")
def reference_build(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give the build folder of the stub with the reference as submission."""
    folder = tmp_path_factory.mktemp("reference")
    build(folder, f"-DEXERCISE_SOURCE={REFERENCE}", "-DCMAKE_CXX_COMPILER=g++")
    return folder


@pytest.fixture(scope="session")
def library(reference_build: Path) -> ctypes.CDLL:
    """Give the loaded library of the reference."""
    return load(reference_build / "libexercise03.so")
