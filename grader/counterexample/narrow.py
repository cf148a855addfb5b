"""How does each kind of trial become smaller while a check still fails on it?"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from grader.counterexample.cutting import (
    Tracing,
    Trees,
    cut_construct,
    cut_faces,
    cut_rays,
    cut_rebuild,
    cut_repeat,
    has_own_tree,
)
from grader.counterexample.probe import Probe
from grader.counterexample.reduce import reduced
from grader.model.mesh import Integers
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
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import candidates

FEW, MANY = 40, 120
"""Candidates of a round: where each needs a tree and answers, and where it does not."""

ROUNDS = 6
PIXELS = 4096
"""Rays of a picture that are tried first."""

BEFORE = (0, 1, 7, 63)
"""Rays before one that fails: what a submission remembers of them may be its mistake."""

SINGLES = 256
"""Rays that are tried one by one."""

WORKING_RAYS = 24

PAIRS = ((1, 5), (5, 1), (5, 0), (0, 5), (5, 5), (5, 9), (9, 5), (9, 9), (17, 5), (9, 17))
"""Faces of two meshes that are built one after the other."""

REPEATS = (
    ((1, 1), 1),
    ((1, 1), 2),
    ((1, 1), 8),
    ((5, 5), 1),
    ((5, 5), 8),
    ((9, 9), 64),
    ((9, 9), 512),
    ((64, 64), 64),
    ((64, 64), 1024),
)
"""Faces of two meshes on which the same rays are traced again and again, and their rays."""


class Narrowing:
    """One failing check on one trial."""

    def __init__(self, probe: Probe, trees: Trees) -> None:
        """Prepare.

        Args:
            probe: Asks whether the check still fails.
            trees: The model solution's trees of small meshes.
        """
        self._probe = probe
        self._trees = trees

    def smaller(self, trial: Trial) -> Trial:
        """Return a trial that is as small as was found; the same one if none is smaller."""
        match trial:
            case ConstructTrial():
                return self._construct(trial)
            case RebuildTrial():
                return self._rebuild(trial)
            case RepeatTrial():
                return self._repeat(trial)
            case WorkTrial():
                return self._work(trial)
            case AlteredTrial():
                return self._altered(trial)
        return self._faces(self._one_ray(trial))

    def _construct(self, trial: ConstructTrial) -> ConstructTrial:
        def fails(subsets: Sequence[Integers]) -> int | None:
            return self._probe.first_failing(cut_construct(trial, subsets))

        every = np.arange(len(trial.mesh.faces))
        return cut_construct(trial, [reduced(every, fails, MANY, ROUNDS)])[0]

    def _faces(self, trial: Tracing, most: int = FEW) -> Tracing:
        """Leave out faces of a trial of part b."""
        if has_own_tree(trial):
            return trial
        every, cut = np.arange(len(trial.mesh.faces)), [trial]

        def fails(subsets: Sequence[Integers]) -> int | None:
            made = cut_faces(trial, subsets, self._trees)
            found = self._probe.first_failing(made)
            if found is None:
                return None
            cut[0] = made[found]
            # The smallest subsets may make no trial, and are left out in front then.
            return found + len(subsets) - len(made)

        reduced(every, fails, most, ROUNDS, on_the_ray(trial))
        return cut[0]

    def _one_ray(self, trial: TraceTrial | ImageTrial) -> Tracing:
        """Find a ray that fails alone, or after few others."""
        if self._probe.dies:
            return self._first_of(trial, singles(trial))
        every = np.arange(len(trial.rays.t_min))
        # A mistake that most pixels show is found sooner among few of them.
        for rays in [every[:: every.size // PIXELS], every] if every.size > PIXELS else [every]:
            chosen = self._probe.wrong_ray(cut_rays(trial, rays))
            if chosen is not None:
                ends = (rays[max(0, chosen - before) : chosen + 1] for before in BEFORE)
                return self._first_of(trial, [cut_rays(trial, end) for end in ends])
        return trial

    def _work(self, trial: WorkTrial) -> Tracing:
        """Few rays, then few faces, then one ray, then fewer faces."""
        few = self._first_of(trial, [cut_rays(trial, np.arange(WORKING_RAYS))])
        small = self._faces(few)
        return self._faces(self._first_of(small, singles(small)))

    def _altered(self, trial: AlteredTrial) -> Tracing:
        """Few faces, then one ray whose hit is gone beside one whose hit is not."""
        # A file holds one tree: an example has to fail on the altered one alone.
        small = self._faces(replace(trial, sound=None))
        if not isinstance(small, AlteredTrial):
            return small
        return self._first_of(small, pairs_of_rays(small))

    def _rebuild(self, trial: RebuildTrial) -> RebuildTrial:
        sizes = (len(trial.first.faces), len(trial.second.faces))
        for size in smaller_pairs(PAIRS, sizes):
            a, b = (np.arange(each) for each in size)
            cut = cut_rebuild(trial, a, b)
            if self._probe.alone(cut):
                return cut
        return trial

    def _repeat(self, trial: RepeatTrial) -> RepeatTrial:
        sizes = (len(trial.mesh.faces), len(trial.other_mesh.faces))
        for size, rays in REPEATS:
            if size not in smaller_pairs([size], sizes):
                continue
            a, b = (np.arange(each) for each in size)
            cut = cut_repeat(trial, (a, b), np.arange(rays), self._trees)
            if self._probe.alone(cut):
                return cut
        return trial

    def _first_of(self, trial: Tracing, proposals: Sequence[Tracing]) -> Tracing:
        """Return the first proposal that fails, the trial itself if none does."""
        found = self._probe.first_failing(proposals) if proposals else None
        return trial if found is None else proposals[found]


def singles(trial: Tracing) -> list[Tracing]:
    """Each of some rays as a trial of its own."""
    count = len(trial.rays.t_min)
    kept = np.unique(np.linspace(0, count - 1, min(count, SINGLES)).astype(np.int64))
    return [cut_rays(trial, kept[k : k + 1]) for k in range(kept.size)] if count > 1 else []


def pairs_of_rays(trial: AlteredTrial) -> list[Tracing]:
    """Each of some rays whose hit is gone, beside some whose hit is not."""
    lost, left = np.flatnonzero(trial.lost)[:WORKING_RAYS], np.flatnonzero(~trial.lost)[:2]
    return [cut_rays(trial, np.sort(np.array([a, b]))) for b in left for a in lost]


def smaller_pairs(
    pairs: Iterable[tuple[int, int]], sizes: tuple[int, int]
) -> list[tuple[int, int]]:
    """Those pairs that are no larger than two sizes, and not both of them."""
    return [
        pair for pair in pairs if pair != sizes and pair[0] <= sizes[0] and pair[1] <= sizes[1]
    ]


def on_the_ray(trial: Tracing) -> Integers:
    """(K,) int64, faces that a single ray meets, from front to back; none of several rays."""
    if len(trial.rays.t_min) != 1:
        return np.zeros(0, np.int64)
    found = candidates(trial.mesh, trial.rays, balanced_tree(trial.mesh))
    return found.face[np.argsort(found.t, kind="stable")]
