"""Grades made by hand, one for each way in which a grading can end."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from grader.model.grade import Cause, CheckScore, Grade, PartScore, Provenance, Timing
from grader.model.stages import Build, CallGraph, Diagnostic, Rejected, Stop, Submission
from grader.model.verdict import Example, Verdict
from tests.report.small_inputs import small, small_trace

SOURCE = b"""#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

static AABB boxOf(const Mesh& mesh, uint32_t face) {
    AABB box;
    box.extend(mesh.getTriangleFromFaceIndex(face).v1);
    return box;
}

void BVH::construct(const Mesh& mesh) {
    nodes.clear();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    return {};
}
"""

CALLS = CallGraph(
    calls=(),
    lines=(
        ("_ZL5boxOfRK4Meshj", 5),
        ("_ZN3BVH9constructERK4Mesh", 11),
        ("_Z9intersectRK4MeshRK15IntersectionRay", 15),
    ),
)

CHECKS = (
    ("build.compiles", "both", 0, "The file compiles with the framework"),
    ("bvh.is-readable", "a", 0, "The tree can be read: ranges and face indices are in bounds"),
    ("bvh.root-holds-all-faces", "a", 1, "Node 0 holds all faces and the mesh's box"),
    (
        "bvh.face-indices-are-a-permutation",
        "a",
        3,
        "The face indices hold every face of the mesh exactly once",
    ),
    (
        "bvh.children-partition-their-parent",
        "a",
        9,
        "The children at 2i+1 and 2i+2 share their parent's faces without loss or overlap",
    ),
    ("bvh.boxes-are-tight", "a", 12, "Every node's box is exactly the one of its triangles"),
    ("work.uses-the-tree", "b", 2, "The tree decides which triangles are tested"),
    ("hits.closest-wins", "b", 20, "The closest of all hits is returned"),
    ("hits.survives-every-ray", "b", 3, "No ray ends the program"),
)

PROVENANCE = Provenance(
    grader="0.1.0",
    rubric_sha256="ab" * 32,
    scenes_sha256="cd" * 32,
    seed=41,
    compiler="g++ 12.2.0",
    flags=("-O2", "-ffp-contract=off"),
    isolation="bubblewrap+landlock+seccomp",
    cpu="A processor",
)

TIMING = Timing(
    compile=1.9,
    submission=0.8,
    grader=0.7,
    total=3.1,
    stages=(("build", 1.9), ("run", 0.8)),
)

BUILD = Build(
    library=Path("/cache/submission.so"),
    sanitized=None,
    deep=None,
    calls=CALLS,
    diagnostics=(),
    compiler="g++ 12.2.0",
    flags=("-O2", "-ffp-contract=off"),
    seconds=1.9,
)

SUBMISSION = Submission(
    student="s0427", path="src/exercise03.cpp", source=SOURCE, sha256="ef" * 32
)


def check(number: int) -> CheckScore:
    """Make the passing score of one row of `CHECKS`."""
    name, part, points, title = CHECKS[number]
    return CheckScore(
        check=name,
        part=part,
        title=title,
        verdict=Verdict.PASS,
        score=points,
        max_score=points,
        visibility="visible",
        examined=524_287,
        wrong=0,
        message="",
        expected="",
        got="",
        examples=(),
        blocked_by=None,
        stop=Stop.FINISHED,
        line=0,
        cases=(),
        seconds=0.21,
    )


def graded(checks: Sequence[CheckScore]) -> Grade:
    """Sum checks up to a whole grade."""
    parts = tuple(
        PartScore(
            part=part,
            title=title,
            score=sum(score.score for score in checks if score.part == part),
            max_score=25,
            started=True,
        )
        for part, title in (("a", "BVH construction"), ("b", "Accelerated intersection"))
    )
    broken = any(score.verdict is Verdict.BROKEN for score in checks)
    return Grade(
        submission=SUBMISSION,
        build=BUILD,
        parts=parts,
        checks=tuple(checks),
        score=None if broken else sum(part.score for part in parts),
        max_score=50,
        needs_review=broken,
        provenance=PROVENANCE,
        timing=TIMING,
    )


def perfect() -> Grade:
    """Full marks."""
    return graded([check(number) for number in range(len(CHECKS))])


def changed(**changes: CheckScore) -> Grade:
    """Full marks but for the checks at the given places: `changed(c5=...)`."""
    scores = [changes.get(f"c{number}", check(number)) for number in range(len(CHECKS))]
    return graded(scores)


def loose_boxes(message: str = "node 1 of 3 triangles: one of them reaches out") -> CheckScore:
    """A failure with everything that a failure may carry."""
    wanted, got = "node 1 box.max = (1.25, 1, 0)", "node 1 box.max = (0.75, 1, 0)"
    return replace(
        check(5),
        verdict=Verdict.FAIL,
        score=4.5,
        wrong=2,
        message=message,
        expected=wanted,
        got=got,
        cause=Cause("box.of-the-parent", "A child gets the box of its parent.", 60, 61),
        examples=(Example("strip-x of 9 faces, node 1: box.max is too small", wanted, got),),
        line=7,
        counterexample=small(),
    )


def first_hit_wins() -> CheckScore:
    """A failure in part b that points at a whole function."""
    return replace(
        check(7),
        verdict=Verdict.FAIL,
        score=0,
        wrong=61,
        examined=4000,
        message="61 of 4,000 wrong, first in `nested`: ray 17: a closer hit was missed",
        expected="t = 1.25",
        got="t = 2.25",
        counterexample=small_trace(),
    )


def crash() -> CheckScore:
    """A check that a crash failed."""
    return replace(
        check(8),
        verdict=Verdict.FAIL,
        score=0,
        wrong=1,
        message="SIGSEGV in intersect on the mesh with one face",
        stop=Stop.CRASHED,
    )


def failing() -> Grade:
    """Failures in both parts, and a check that waits for one of them."""
    waiting = replace(
        check(4), verdict=Verdict.BLOCKED, score=0, blocked_by="bvh.boxes-are-tight"
    )
    return changed(c4=waiting, c5=loose_boxes(), c7=first_hit_wins(), c8=crash())


def broken() -> Grade:
    """Our own fault in one check, which another one needs."""
    fault = replace(
        check(6),
        verdict=Verdict.BROKEN,
        score=0,
        examined=0,
        message="Embree and the rule of closest hits disagree on ray 3",
    )
    waiting = replace(check(7), verdict=Verdict.BLOCKED, score=0, blocked_by=fault.check)
    return changed(c6=fault, c7=waiting)


def starter() -> Grade:
    """The unedited starter: nothing was done, and nothing is wrong."""
    said = "not started: it still does what the given code does"
    idle = [
        replace(check(number), verdict=Verdict.BLOCKED, score=0, message=said)
        for number in range(1, len(CHECKS))
    ]
    grade = graded([check(0), *idle])
    return replace(grade, parts=tuple(replace(part, started=False) for part in grade.parts))


def waiting(blocker: str) -> list[CheckScore]:
    """Every check but the first, blocked."""
    return [
        replace(check(number), verdict=Verdict.BLOCKED, score=0, examined=0, blocked_by=blocker)
        for number in range(1, len(CHECKS))
    ]


def uncompiled() -> Grade:
    """A file with errors."""
    said = (
        Diagnostic(7, 16, "error", "'class Mesh' has no member named 'getTriangle'"),
        Diagnostic(7, 16, "note", "declared here"),
        Diagnostic(12, 5, "warning", "unused variable 'x'"),
        Diagnostic(12, 10, "error", "expected ';' before '}' token"),
        Diagnostic(0, 0, "error", "link: undefined reference to `v[red](int)'"),
        Diagnostic(16, 5, "error", "could not convert '{}' to 'Intersection'"),
    )
    first = replace(
        check(0), verdict=Verdict.FAIL, wrong=4, examined=1, message="4 errors", line=7
    )
    grade = graded([first, *waiting(first.check)])
    return replace(grade, build=replace(BUILD, library=None, diagnostics=said))


def rejected() -> Grade:
    """Nothing that could be graded."""
    reason = "the folder holds two exercise03.cpp: a/exercise03.cpp and b/exercise03.cpp"
    first = replace(check(0), verdict=Verdict.FAIL, wrong=1, examined=1, message=reason)
    grade = graded([first, *waiting(first.check)])
    return replace(grade, build=None, submission=Rejected("s0428", reason))


EVERY = {
    "perfect": perfect,
    "failing": failing,
    "broken": broken,
    "starter": starter,
    "uncompiled": uncompiled,
    "rejected": rejected,
}
"""One grade for each ending."""
