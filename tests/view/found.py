"""Counterexamples of every kind, whose rays are half of them lost by one submission."""

from pathlib import Path

import numpy as np

from grader.cli.progress import silent
from grader.counterexample.written import to_text
from grader.model.counterexample import Counterexample
from grader.model.mesh import Mesh, Rays
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.options import Options
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers
from grader.oracle.meshes import mesh_named
from grader.view.subject import Subject, of_file
from tests.verify.builder import build, soup

OPTIONS = Options(41, None, (), silent, isolated=False)


MESSAGE = "what the check said \x1b of it"


REMARK = "hits.closest-wins, when this was found: what the check said \\x1b of it"


MESH, OTHER = soup(30), soup(12, seed=5)


def aimed(mesh: Mesh) -> Rays:
    """Aim at the middles of some faces, from afar."""
    target = mesh.vertices[mesh.faces[:6]].mean(axis=1)
    origin = np.tile(np.array([[-6.0, 0.3, 0.2]], np.float32), (len(target), 1))
    count = len(target)
    return Rays(
        origin,
        (target - origin).astype(np.float32),
        np.zeros(count, np.float32),
        np.full(count, np.inf, np.float32),
    )


def middle() -> float:
    """Divide the rays into those that are lost and the others."""
    return float(np.median(aimed(MESH).direction[:, 1]))


def trials() -> list[Trial]:
    """Make one of each kind."""
    tree, rays = build(MESH), aimed(MESH)
    found = answers(MESH, rays, balanced_tree(MESH))
    others = answers(OTHER, rays, balanced_tree(OTHER))
    count = len(rays.t_min)
    none = np.zeros(count, np.bool_)
    families = ("aimed",), np.zeros(count, np.int64)
    return [
        ConstructTrial("construct", MESH),
        ConstructTrial("empty", soup(0)),
        ConstructTrial("tiny", mesh_named(41, "scaled-tiny")),
        ConstructTrial("huge", mesh_named(41, "scaled-huge")),
        RebuildTrial("rebuild", MESH, OTHER),
        TraceTrial("trace", MESH, tree, rays, found, *families, special=False),
        AlteredTrial("altered", MESH, tree, rays, found, none, "nothing"),
        WorkTrial("work", MESH, tree, rays, 1.0, 1.0),
        RepeatTrial("repeat", MESH, tree, OTHER, build(OTHER), rays, found, others),
        ImageTrial("image", MESH, tree, count, 1, rays, found, found.limit.astype(np.float32)),
    ]


def stored(trial: Trial, folder: Path) -> Subject:
    """Write a counterexample as the grader does, and open the file."""
    rays = 0 if isinstance(trial, ConstructTrial | RebuildTrial) else len(trial.rays.t_min)
    found = Counterexample("hits.closest-wins", trial, 30, rays, trial.name, MESSAGE, "", "")
    file = folder / "found.json"
    file.write_text(to_text(found))
    return of_file(file)
