"""What does the file of a counterexample hold? Everything that is needed to see it again.

Numbers are written so that they come back bit for bit: every float32 is a float64. An infinite
t_max is null, and of a tree only the nodes in use are listed. Answers are not written: whoever
reads the file computes them anew.
"""

from typing import Any

import numpy as np

from grader.model.counterexample import Counterexample
from grader.model.mesh import Bvh, Mesh, Rays
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
from grader.report.escape import for_json

Json = dict[str, Any]

FORMAT = "bvhgrade counterexample"
VERSION = 1

KINDS: dict[type, str] = {
    ConstructTrial: "construct",
    RebuildTrial: "rebuild",
    TraceTrial: "trace",
    AlteredTrial: "altered",
    WorkTrial: "work",
    RepeatTrial: "repeat",
    ImageTrial: "image",
}


def to_text(found: Counterexample) -> str:
    """Write a counterexample as the text of its file."""
    trial = found.trial
    content: Json = {
        "format": FORMAT,
        "version": VERSION,
        "check": found.check,
        "kind": KINDS[type(trial)],
        "name": trial.name,
        "message": found.message,
        "expected": found.expected,
        "got": found.got,
        "explanation": found.explanation,
        "sanitized": getattr(trial, "sanitized", False),
        "full_levels": getattr(trial, "full_levels", False),
        "special": getattr(trial, "special", False),
        "meshes": [mesh_json(mesh) for mesh in meshes_of(trial)],
        "trees": [tree_json(tree) for tree in trees_of(trial)],
        "rays": [] if isinstance(trial, ConstructTrial | RebuildTrial) else rays_json(trial),
    }
    return for_json(content) + "\n"


def meshes_of(trial: Trial) -> tuple[Mesh, ...]:
    """Return the meshes of a trial, one or two."""
    match trial:
        case RebuildTrial():
            return trial.first, trial.second
        case RepeatTrial():
            return trial.mesh, trial.other_mesh
    return (trial.mesh,)


def trees_of(trial: Trial) -> tuple[Bvh, ...]:
    """Return the trees that rays are traced on; none in part a."""
    match trial:
        case ConstructTrial() | RebuildTrial():
            return ()
        case RepeatTrial():
            return trial.tree, trial.other_tree
    return (trial.tree,)


def mesh_json(mesh: Mesh) -> Json:
    """Write a mesh."""
    return {"vertices": mesh.vertices.tolist(), "faces": mesh.faces.tolist()}


def tree_json(tree: Bvh) -> Json:
    """Write a tree: how many nodes it has, and those that are not `Node{}`."""
    used = np.flatnonzero(tree.end)
    nodes = [
        {
            "index": int(node),
            "low": tree.low[node].tolist(),
            "high": tree.high[node].tolist(),
            "faces": [int(tree.begin[node]), int(tree.end[node])],
        }
        for node in used
    ]
    return {"count": len(tree.end), "nodes": nodes, "face_indices": tree.order.tolist()}


def rays_json(
    trial: TraceTrial | AlteredTrial | WorkTrial | RepeatTrial | ImageTrial,
) -> list[Json]:
    """Write the rays, each with the name of the family that it was drawn from."""
    rays: Rays = trial.rays
    return [
        {
            "origin": rays.origin[k].tolist(),
            "direction": rays.direction[k].tolist(),
            "t_min": float(rays.t_min[k]),
            "t_max": float(rays.t_max[k]) if np.isfinite(rays.t_max[k]) else None,
            "family": _family(trial, k),
        }
        for k in range(len(rays.t_min))
    ]


def _family(trial: Trial, ray: int) -> str:
    return trial.families[trial.family[ray]] if isinstance(trial, TraceTrial) else ""
