"""Is a right submission ever rejected by the rule of closest hits? Measured, not believed.

`python -m tests.oracle.prove_rule --size nightly` traces the meshes and families of rays of the
plan, but for what `too_much` names and the rays of pictures and altered trees, with every
triangle test, in float and double, of two compilers with all levels of optimisation, with and
without FMA, and holds each t against the rule: at least ten million verdicts. `--size ci` takes
a sample of all that in some seconds. Exit status 1 if anything was rejected.
"""

import argparse
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from grader.model.mesh import Answers, Floats, Integers
from grader.model.trials import TraceTrial
from grader.oracle.exact import exact_trial, lattice
from grader.oracle.meshes import SHAPES, TRACED
from grader.oracle.plan import LATTICES
from grader.oracle.rays import Request
from grader.oracle.spines import DEEPEST, spine_trial
from grader.oracle.thicket import thicket, thicket_trial
from grader.oracle.tracing import traced
from grader.oracle.witness import contradictions
from grader.tolerances import MAX_DEPTH
from grader.verify.closest import is_ambiguous, judge
from tests.oracle.tracers import (
    BOXES,
    REALS,
    TRIANGLES,
    UNSOUND_IF_FUSED,
    Arithmetic,
    Tracer,
    Way,
    compiled,
    every_arithmetic,
)
from tests.oracle.treebuilder import planted, tree_of


@dataclass(frozen=True, slots=True)
class Size:
    """How much is traced."""

    meshes: tuple[str, ...]
    rays: int
    """Of each family on each mesh."""

    seeds: tuple[int, ...]
    arithmetics: tuple[Arithmetic, ...]


def sizes() -> dict[str, Size]:
    """Return the sizes by name."""
    every = tuple(every_arithmetic())
    other = tuple(name for name in SHAPES if name not in TRACED and not too_much(name))
    return {
        "ci": Size(TRACED, 6, (1,), (every[4], every[-1])),
        "nightly": Size((*TRACED, *other), 40, (1,), every),
    }


def too_much(name: str) -> bool:
    """Tell whether a shape has no face, too many for a night, or is no place for rays.

    There normals are too small or large for a float, or no face has an area.
    """
    return name in ("cloud-0", "cloud-65539", "scaled-tiny", "scaled-huge", "one-point")


@dataclass(slots=True)
class Count:
    """What was seen of one triangle test in one precision."""

    verdicts: int = 0
    rejected: int = 0
    uncounted: int = 0
    worst: float = 0.0
    """The largest error of a right t on rays without a doubtful face, in its tolerance."""

    where: str = ""
    """The first ray that was rejected."""


Counts = dict[tuple[str, str], Count]


@dataclass(slots=True)
class Proof:
    """What was seen of all of them."""

    counts: Counts = field(
        default_factory=lambda: {(test, real): Count() for test in TRIANGLES for real in REALS}
    )

    def add(self, trial: TraceTrial, t: Floats, way: Way, arithmetic: Arithmetic) -> None:
        """Judge what one way returned for the rays of one trial."""
        judgement = judge(trial.answers, t)
        wrong = judgement.missed_closer | judgement.no_surface
        count = self.counts[TRIANGLES[way.triangle], way.real]
        count.verdicts += t.size
        count.rejected += int(wrong.sum())
        count.uncounted += int(judgement.uncounted.sum())
        clear = np.where(is_ambiguous(trial.answers), -1, judgement.accepted)
        count.worst = max(count.worst, largest_error(trial.answers, t, clear))
        if wrong.any() and not count.where:
            ray = int(np.flatnonzero(wrong)[0])
            family = trial.families[trial.family[ray]]
            box = BOXES[way.box] + (", early out" if way.early else "")
            count.where = (
                f"{arithmetic}, box test {box}: {trial.name}, ray {ray} ({family}), "
                f"t = {t[ray]}, sure hit at most at {trial.answers.limit[ray]}"
            )

    def total(self, name: str) -> int:
        """Add up one number of all counts."""
        return sum(getattr(count, name) for count in self.counts.values())

    def lines(self) -> Iterator[str]:
        """Word everything as a table."""
        yield f"{'triangle test':<24}{'real':<8}{'verdicts':>12}{'rejected':>10}" + (
            f"{'uncounted':>11}{'largest error / tolerance':>27}"
        )
        for (test, real), count in self.counts.items():
            yield f"{test:<24}{real:<8}{count.verdicts:>12,}{count.rejected:>10,}" + (
                f"{count.uncounted:>11,}{count.worst:>27.3f}"
            )
            if count.where:
                yield f"    first rejected: {count.where}"
        total, rejected = self.total("verdicts"), self.total("rejected")
        yield f"{total:,} verdicts, {rejected:,} false rejects"


def largest_error(answers: Answers, t: Floats, accepted: Integers) -> float:
    """Return the largest |t - t of the triangle| / tolerance of the hits that were accepted."""
    ray = np.flatnonzero(accepted >= 0)
    triangle = accepted[ray]
    error = np.abs(t[ray].astype(np.float64) - answers.t[triangle])
    with np.errstate(invalid="ignore"):
        share = error / answers.tolerance[triangle]
    return float(np.nan_to_num(share).max(initial=0.0))


def trials_of(size: Size) -> Iterator[TraceTrial]:
    """Draw the rays and their answers as the plan does, but for pictures and altered trees."""
    for seed in size.seeds:
        for name in size.meshes:
            mesh, tree = planted(name, seed)
            for special in (False, True):
                trial = traced(Request(seed, name, special, size.rays), mesh, tree)
                assert not list(contradictions([trial]))
                yield trial
        for up in LATTICES:
            mesh = lattice(seed, up)
            yield exact_trial(seed, up, mesh, tree_of(mesh))
        bundle = thicket(seed)
        yield thicket_trial(seed, bundle, tree_of(bundle))
        for deepest in (DEEPEST, MAX_DEPTH):
            yield spine_trial(seed, deepest)


def ways(turn: int) -> Iterator[Way]:
    """List every triangle test in both precisions; slab tests and early outs take turns."""
    for triangle in range(len(TRIANGLES)):
        for real in REALS:
            turn += 1
            yield Way(triangle, turn % len(BOXES), turn // len(BOXES) % 2 == 0, real)


def prove(size: Size, folder: Path) -> Proof:
    """Trace and judge everything."""
    proof = Proof()
    with ThreadPoolExecutor(2) as pool:
        tracers = list(pool.map(lambda each: compiled(each, folder), size.arithmetics))
        for number, trial in enumerate(trials_of(size)):
            orders = list(_orders(tracers, number))
            found = pool.map(lambda order, trial=trial: _traced(trial, *order), orders)
            for (tracer, way), t in zip(orders, found, strict=True):
                proof.add(trial, t, way, tracer.arithmetic)
    return proof


def _orders(tracers: Iterable[Tracer], number: int) -> Iterator[tuple[Tracer, Way]]:
    for turn, tracer in enumerate(tracers):
        for way in ways(number + 3 * turn):
            unsound = TRIANGLES[way.triangle] in UNSOUND_IF_FUSED
            if not (tracer.arithmetic.fused and unsound):
                yield tracer, way


def _traced(trial: TraceTrial, tracer: Tracer, way: Way) -> Floats:
    return tracer.trace(trial.mesh, trial.tree, trial.rays, way)


def main(arguments: Sequence[str]) -> int:
    """Prove, and print what was seen."""
    known = sizes()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", choices=known, default="ci")
    size = known[parser.parse_args(arguments).size]
    with tempfile.TemporaryDirectory() as folder:
        proof = prove(size, Path(folder))
    for line in proof.lines():
        print(line)  # noqa: T201 - a script
    return 1 if proof.total("rejected") else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
