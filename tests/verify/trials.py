"""One trial of each kind, small and without right answers."""

import numpy as np

from grader.model.mesh import Answers, Mesh, Rays
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
from tests.verify.builder import build, soup

RAYS = Rays(
    np.zeros((3, 3), np.float32),
    np.ones((3, 3), np.float32),
    np.zeros(3, np.float32),
    np.full(3, np.inf, np.float32),
)
NOTHING = Answers(
    limit=np.full(3, np.inf),
    first=np.zeros(4, np.int64),
    face=np.zeros(0, np.int64),
    t=np.zeros(0),
    tolerance=np.zeros(0),
    kind=np.zeros(0, np.uint8),
)


def construct(faces: int, sanitized: bool = False) -> ConstructTrial:
    """Make a trial of part a; the mesh is the same point everywhere if it is large."""
    if faces < 1000:
        return ConstructTrial(f"construct {faces} {sanitized}", soup(faces), sanitized)
    vertices, corners = np.zeros((1, 3), np.float32), np.zeros((faces, 3), np.uint32)
    return ConstructTrial(f"construct {faces}", Mesh(vertices, corners), sanitized)


def trace(special: bool, sanitized: bool) -> TraceTrial:
    """Make a trial of ordinary or special rays."""
    mesh = soup(9)
    return TraceTrial(
        f"trace {special} {sanitized}",
        mesh,
        build(mesh),
        RAYS,
        NOTHING,
        ("random",),
        np.zeros(3, np.int64),
        special,
        sanitized,
    )


def rebuilds(mesh: Mesh) -> tuple[RebuildTrial, ...]:
    """Make both trials of two meshes of part a."""
    return (
        RebuildTrial("rebuild", mesh, soup(5)),
        RebuildTrial("rebuild sanitized", mesh, soup(5), sanitized=True),
    )


def repeats(mesh: Mesh) -> tuple[RepeatTrial, ...]:
    """Make both trials of two meshes of part b."""
    one, other = build(mesh), build(soup(5))
    given = (mesh, one, soup(5), other, RAYS, NOTHING, NOTHING)
    return RepeatTrial("repeat", *given), RepeatTrial(
        "repeat sanitized", *given, sanitized=True
    )


def every_trial() -> tuple[Trial, ...]:
    """Make a trial of each kind and flavour, the one with four million faces aside."""
    mesh, tree, t = soup(9), build(soup(9)), np.full(3, np.inf, np.float32)
    return (
        construct(0),
        construct(37),
        construct(256, sanitized=True),
        construct(257, sanitized=True),
        *rebuilds(mesh),
        *(
            trace(special, sanitized)
            for special in (False, True)
            for sanitized in (False, True)
        ),
        AlteredTrial("altered", mesh, tree, RAYS, NOTHING, np.zeros(3, np.bool_), "nothing"),
        WorkTrial("work", mesh, tree, RAYS, 1.0, 1.0),
        *repeats(mesh),
        ImageTrial("image", mesh, tree, 3, 1, RAYS, NOTHING, t),
    )
