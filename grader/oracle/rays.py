"""Which rays are traced on a mesh, and what is right for each of them?"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, FrozenArrays, Integers, Mesh, Rays
from grader.oracle.brute import Candidates, candidates
from grader.oracle.bundle import stage_for
from grader.oracle.meshes import generator
from grader.oracle.ordinary import ORDINARY
from grader.oracle.special import SPECIAL

FACELESS = {False: ("inbound", "camera", "from-inside", "beside"), True: ("any-length",)}
"""Families that a mesh without faces has; by whether they are special."""


@dataclass(frozen=True, slots=True, eq=False)
class Family(FrozenArrays):
    """Rays of several families."""

    rays: Rays
    names: tuple[str, ...]
    index: Integers
    """(R,) int64, index into `names` of each ray."""


@dataclass(frozen=True, slots=True)
class Request:
    """Which rays are wanted."""

    seed: int
    mesh: str
    """Name of the mesh: each draws other rays."""

    special: bool
    count: int
    """Rays of each family."""


def families_of(request: Request, mesh: Mesh) -> tuple[str, ...]:
    """Return the names of the families that a mesh can have."""
    known: Mapping[str, object] = SPECIAL if request.special else ORDINARY
    return tuple(known) if len(mesh.faces) else FACELESS[request.special]


def rays_on(request: Request, mesh: Mesh, tree: Bvh) -> Family:
    """Draw the rays of all families.

    Args:
        request: Which rays.
        mesh: The triangles.
        tree: A tree over them, to find hits quickly.
    """

    def look(rays: Rays) -> Candidates:
        return candidates(mesh, rays, tree)

    names = families_of(request, mesh)
    makers = SPECIAL if request.special else ORDINARY
    drawn = [
        makers[name](
            stage_for(mesh, generator(request.seed, request.mesh, name), look), request.count
        )
        for name in names
    ]
    return Family(
        rays=joined(drawn),
        names=names,
        index=np.repeat(np.arange(len(names)), request.count),
    )


def joined(parts: list[Rays]) -> Rays:
    """Return rays one after the other."""
    return Rays(
        origin=np.concatenate([part.origin for part in parts]),
        direction=np.concatenate([part.direction for part in parts]),
        t_min=np.concatenate([part.t_min for part in parts]),
        t_max=np.concatenate([part.t_max for part in parts]),
    )
