"""Compiles sources of the tests with the grader's own build."""

from hashlib import sha256
from pathlib import Path

from grader import resources
from grader.build.compile import (
    call_graph,
    compile_reference,
    compile_submission,
    prepared,
)
from grader.build.compiler import find_compiler
from grader.build.compiling import Compilation
from grader.build.workspace import GRADED, workspace
from grader.model.stages import Build, CallGraph, Further, Submission
from grader.run.session import Allowance, Engine
from grader.sandbox.selftest import unconfined
from grader.score.rubric import load_rubric

BEGIN = '#include "bvh.h"\n#include "intersection.h"\n#include "mesh.h"\n'
"""Three lines; a test's own source begins in line 4."""

INTERSECT = "Intersection intersect(const Mesh&, const IntersectionRay&) { return {}; }\n"
CONSTRUCT = "void BVH::construct(const Mesh&) { nodes.clear(); }\n"
PATIENT = Allowance(60.0, 180.0)
STARTER = resources.stub_folder() / "src" / "exercise03.cpp"


def submission_of(source: str) -> Submission:
    """Make a submission of some text."""
    text = source.encode()
    return Submission("student", "exercise03.cpp", text, sha256(text).hexdigest())


def compilation(folder: Path, further: frozenset[Further] = frozenset(Further)) -> Compilation:
    """Compile in a folder with the usual limits; the levels have tests of their own."""
    return Compilation(folder, unconfined(), load_rubric().limits.compiler, further)


def engine_of(library: Path, preload: str = "") -> Engine:
    """Make an engine with the limits of the shipped rubric."""
    return Engine(library, load_rubric().limits, unconfined(), preload)


def whole_build(source: str, folder: Path) -> Build:
    """Build everything that a grade needs."""
    return compile_submission(submission_of(source), compilation(folder / "whole"))


def partial_build(source: str, folder: Path, *further: Further) -> Build:
    """Build the graded library, and only this beside it."""
    order = compilation(folder / "partial", frozenset(further))
    return compile_submission(submission_of(source), order)


def library_of(source: str, folder: Path) -> Path:
    """Build the graded library only, of a source that must compile."""
    return compile_reference(submission_of(source), folder / "graded")


def graph_of(source: str, folder: Path) -> CallGraph:
    """Read the call graph only, of a source that must compile."""
    work = prepared(submission_of(source), compilation(folder))
    graph = call_graph(workspace(find_compiler(), GRADED), work)
    assert graph
    return graph
