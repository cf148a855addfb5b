"""Which compilers the tests build with."""

from collections.abc import Callable

from grader.model.stages import Build, Diagnostic

COMPILERS = ("g++", "clang++")
Compile = Callable[..., Build]
"""Builds a source once with a compiler: see the fixture `compiled`."""


def errors(build: Build) -> list[Diagnostic]:
    """Pick the errors of a build that failed."""
    assert (build.library, build.sanitized, build.calls) == (None, None, None)
    return [each for each in build.diagnostics if each.severity == "error"]
