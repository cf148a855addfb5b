"""Does Embree agree with all answers of a plan?

It does not see the pictures, which have Mitsuba as a witness, nor the trials of the sanitized
build, which are judged by how a worker ends.
"""

from collections.abc import Iterable, Iterator

import numpy as np

from grader.model.mesh import Answers, Mesh, Rays
from grader.model.trials import AlteredTrial, RepeatTrial, TraceTrial, Trial
from grader.oracle.embree import contradicted, embree_t


def contradictions(trials: Iterable[Trial]) -> Iterator[tuple[str, str]]:
    """Yield the name of each trial that Embree contradicts, and in what: our own fault.

    Raises:
        MissingTool: embreex is not installed.
    """
    for trial in trials:
        for mesh, rays, answers in _claims(trial):
            if fault := _fault(mesh, rays, answers):
                yield trial.name, f"{trial.name}: {fault}"


def _claims(trial: Trial) -> Iterator[tuple[Mesh, Rays, Answers]]:
    """Yield what a trial says of rays on whole meshes."""
    match trial:
        case RepeatTrial(sanitized=False):
            yield trial.mesh, trial.rays, trial.answers
            yield trial.other_mesh, trial.rays, trial.other_answers
        case TraceTrial(sanitized=False) | AlteredTrial():
            yield trial.mesh, trial.rays, trial.answers


def _fault(mesh: Mesh, rays: Rays, answers: Answers) -> str:
    """Word a contradiction between the rule and Embree; empty if there is none."""
    theirs = embree_t(mesh, rays)
    wrong = np.flatnonzero(contradicted(rays, answers, theirs))
    if wrong.size == 0:
        return ""
    ray = int(wrong[0])
    return (
        "the rule of closest hits and Embree contradict each other on "
        f"{wrong.size} clear rays, first on ray {ray}, where the rule says at most "
        f"t = {answers.limit[ray]:.9g} and Embree {theirs[ray]:.9g}"
    )
