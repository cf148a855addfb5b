"""What is told of a counterexample: the check's words, the node table, the path of a ray."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from grader.counterexample.explain import Explanation, Setting, false_hit, lost_hit
from grader.counterexample.nearest import nearest_tree
from grader.counterexample.probe import Probe, sizes
from grader.counterexample.shown import with_ray, with_tree
from grader.counterexample.table import MOST_FACES, path_table, tree_table
from grader.model.cases import TreeCase
from grader.model.counterexample import Counterexample
from grader.model.trials import AlteredTrial, ConstructTrial, ImageTrial, TraceTrial, Trial
from grader.model.verdict import Evidence
from grader.oracle.brute import chosen
from grader.verify.closest import closest_sure

PATH_FACES = 1_000
"""Faces of a mesh that is shown: its tree, or the recorded path of a ray."""


def described(probe: Probe, trial: Trial, found_in: str, evidence: Evidence) -> Counterexample:
    """Tell a trial that fails.

    Args:
        probe: Of the check that fails.
        trial: What fails.
        found_in: Name of the trial that it was reduced from.
        evidence: What the check says against it.
    """
    example = evidence.examples[0]
    faces, rays = sizes(trial)
    told = Counterexample(
        check=probe.check_id,
        trial=trial,
        faces=faces,
        rays=rays,
        found_in=found_in,
        message=example.message,
        expected=example.expected,
        got=example.got,
    )
    if probe.dies:
        return told
    match trial:
        case ConstructTrial() if faces <= PATH_FACES:
            return _with_trees(told, probe, trial)
        case TraceTrial() | AlteredTrial() | ImageTrial() if faces <= PATH_FACES:
            return _with_path(told, probe, trial)
    return told


def _with_trees(told: Counterexample, probe: Probe, trial: ConstructTrial) -> Counterexample:
    for case in probe.cases(trial):
        if isinstance(case, TreeCase):
            expected = nearest_tree(trial.mesh, case.bvh)
            small = len(trial.mesh.faces) <= MOST_FACES
            table = tree_table(expected, case.bvh) if small else None
            model = with_tree(told.check, trial.mesh, case.bvh, expected)
            return replace(told, table=table, model=model)
    return told


def _with_path(
    told: Counterexample, probe: Probe, trial: TraceTrial | AlteredTrial | ImageTrial
) -> Counterexample:
    ray = telling_ray(trial)
    path = None if ray is None else probe.path(trial, ray)
    if ray is None or path is None:
        return told
    setting = Setting(trial.mesh, trial.tree, path)
    found = explanation(setting, trial, ray)
    small = len(trial.mesh.faces) <= MOST_FACES
    rays = chosen(trial.rays, np.array([ray]))
    # Of a path that was cut, nobody knows which nodes were not tested.
    is_whole = path.total and not setting.is_cut
    table = path_table(setting, rays, found.node) if small and is_whole else None
    model = with_ray(told.check, setting, trial, ray, found)
    return replace(told, explanation=found.text, table=table, model=model)


def telling_ray(trial: TraceTrial | AlteredTrial | ImageTrial) -> int | None:
    """Return the ray that the trial is about; None if there are several."""
    rays: Sequence[int] = range(len(trial.rays.t_min))
    if isinstance(trial, AlteredTrial):
        rays = np.flatnonzero(trial.lost).tolist()
    return rays[0] if len(rays) == 1 else None


def explanation(
    setting: Setting, trial: TraceTrial | AlteredTrial | ImageTrial, ray: int
) -> Explanation:
    """Say where the ray's hit was lost, or where it comes from."""
    answers, t = trial.answers, setting.path.found
    nearest = closest_sure(answers, ray)
    if nearest < 0:
        return false_hit(setting)
    face, limit = int(answers.face[nearest]), float(answers.limit[ray])
    is_found = abs(t - answers.t[nearest]) <= answers.tolerance[nearest]
    if isinstance(trial, AlteredTrial) and trial.lost[ray]:
        # Behind what is gone there may be another face, of which nothing is known here.
        return Explanation(
            f"face {face} is in no leaf that this ray reaches ({trial.change}), and yet it was "
            "found: not through the tree"
            if is_found
            else ""
        )
    if t > limit:
        return lost_hit(setting, face, float(answers.t[nearest]))
    return Explanation("") if is_found else false_hit(setting)
