"""Recorded paths made by hand: what a submission's process would tell."""

import numpy as np

from grader.counterexample.explain import Setting
from grader.model.mesh import Bvh, Floats, Mesh
from grader.model.path import NO_NODE, Path
from tests.verify.builder import build, mesh_of

CORNERS = np.array([[-9, -8, 0], [9, -7, 0.3], [0, 9, 0.1]])
PILE: Mesh = mesh_of(CORNERS + np.arange(5)[:, None, None] * (0, 0, 20))
"""Five faces above each other: two leaves, the lower one of two faces."""

TREE: Bvh = build(PILE)


class Walk:
    """A path that grows test by test."""

    def __init__(self) -> None:
        self._steps: list[tuple[bool, bool, int, float, float, Floats]] = []

    def box(
        self, node: int, hit: bool = True, t_max: float = np.inf, known: bool = True
    ) -> "Walk":
        """Add a test of a node's box; of a copy of it, if the node is not known."""
        corners = np.concatenate([TREE.low[node], TREE.high[node], np.zeros(3, np.float32)])
        self._steps.append((True, hit, node if known else NO_NODE, 0.0, t_max, corners))
        return self

    def face(self, face: int, t: float | None, t_max: float = np.inf, turn: int = 0) -> "Walk":
        """Add a test of a face, which hits at t or not at all."""
        corners = np.roll(PILE.vertices[PILE.faces[face]], turn, axis=0).ravel()
        at = np.inf if t is None else t
        self._steps.append((False, t is not None, NO_NODE, at, t_max, corners))
        return self

    def setting(self, found: float = np.inf) -> Setting:
        """Make the setting of this path, with what `intersect` returned."""
        count = len(self._steps)
        columns = list(zip(*self._steps, strict=True)) or [()] * 6
        return Setting(
            PILE,
            TREE,
            Path(
                is_box=np.array(columns[0], np.bool_),
                hit=np.array(columns[1], np.bool_),
                node=np.array(columns[2], np.uint32),
                t=np.array(columns[3], np.float32),
                t_min=np.zeros(count, np.float32),
                t_max=np.array(columns[4], np.float32),
                corners=np.array(columns[5], np.float32).reshape(count, 9),
                found=found,
                total=count,
            ),
        )
