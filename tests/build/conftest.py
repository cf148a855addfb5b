"""What tests of builds start with."""

from functools import cache as once
from pathlib import Path

import pytest

from grader.model.stages import Build
from tests.build.compilers import Compile
from tests.compiled import whole_build


@pytest.fixture(scope="session")
def compiled(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Compile:
    """Give a function that builds a source once with a compiler."""

    @once
    def build(source: str, compiler: str = "g++") -> Build:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("CXX", compiler)
            return whole_build(source, tmp_path_factory.mktemp("build"))

    return build
