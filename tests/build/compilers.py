"""Which compilers the tests build with."""

from collections.abc import Callable

from grader.model.stages import Build

COMPILERS = ("g++", "clang++")
Compile = Callable[..., Build]
"""Builds a source once with a compiler: see the fixture `compiled`."""
