"""Compiles sources of the tests with the grader's own build."""

from hashlib import sha256
from pathlib import Path

from grader import resources
from grader.build.compile import call_graph, compile_reference, compile_submission
from grader.build.compiler import find_compiler
from grader.build.diagnostics import SOURCE_NAME
from grader.build.workspace import GRADED, workspace
from grader.model.stages import Build, CallGraph, Submission

BEGIN = '#include "bvh.h"\n#include "intersection.h"\n#include "mesh.h"\n'
"""Three lines; a test's own source begins in line 4."""

INTERSECT = "Intersection intersect(const Mesh&, const IntersectionRay&) { return {}; }\n"
CONSTRUCT = "void BVH::construct(const Mesh&) { nodes.clear(); }\n"
STARTER = resources.stub_folder() / "src" / "exercise03.cpp"


def submission_of(source: str) -> Submission:
    """Make a submission of some text."""
    text = source.encode()
    return Submission("student", "exercise03.cpp", text, sha256(text).hexdigest())


def whole_build(source: str, folder: Path) -> Build:
    """Build everything that a grade needs."""
    return compile_submission(submission_of(source), folder / "whole")


def library_of(source: str, folder: Path) -> Path:
    """Build the graded library only, of a source that must compile."""
    return compile_reference(submission_of(source), folder / "graded")


def graph_of(source: str, folder: Path) -> CallGraph:
    """Read the call graph only, of a source that must compile."""
    (folder / SOURCE_NAME).parent.mkdir()
    (folder / SOURCE_NAME).write_text(source)
    graph = call_graph(workspace(find_compiler(), GRADED), folder)
    assert graph
    return graph
