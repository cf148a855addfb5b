"""What does a student run often? The checks that find most mistakes, where they cost least.

The order of the first ten is that of `tests/submissions/kill-matrix.csv`: each check stands
before those that find fewer mistakes which none before it has found. On small meshes these ten
and the gates failed 190 of 243 wrong files (measured 2026-11-29). The last five find some that
the ten see on large meshes or not at all, and cost next to nothing. Left out is what takes a
build of its own, a picture, threads or a large mesh.
"""

from collections.abc import Sequence

from grader.model.stages import Further
from grader.model.trials import ImageTrial, RebuildTrial, RepeatTrial, Trial
from grader.run.trials import is_sanitized

BEST = 10
"""So many are in order; each finds more than five mistakes that none before it finds."""

CHECKS = (
    "hits.special-rays",
    "bvh.splits-at-the-median",
    "hits.survives-every-ray",
    "bvh.survives-every-mesh",
    "bvh.boxes-are-tight",
    "bvh.rebuild-starts-afresh",
    "bvh.splits-the-longest-axis",
    "source.construct-loops",
    "bvh.leaves-hold-at-most-four",
    "hits.record-is-complete",
    "work.uses-the-tree",
    "work.excludes-most-triangles",
    "bvh.face-indices-are-a-permutation",
    "hits.closest-wins",
    "bvh.root-holds-all-faces",
)

SLOW_BUILDS = frozenset((Further.SANITIZED, Further.DEEP))
"""What takes longer to compile than the submission itself."""

LARGEST_FACES = 20_000
"""Larger meshes show hardly any mistake that small ones do not, and take most of the time."""


def quick_checks(offered: Sequence[str]) -> tuple[str, ...]:
    """Return the checks of a quick run, those that a rubric does not have left out.

    Args:
        offered: Ids of the checks that may be run.
    """
    return tuple(check for check in CHECKS if check in offered)


def is_quick(trial: Trial) -> bool:
    """Tell whether a trial takes next to no time."""
    if is_sanitized(trial) or isinstance(trial, ImageTrial | RepeatTrial):
        return False
    mesh = trial.first if isinstance(trial, RebuildTrial) else trial.mesh
    return len(mesh.faces) <= LARGEST_FACES
