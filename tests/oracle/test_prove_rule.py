"""The rule of closest hits rejects no right way to write a ray tracer, and some wrong ones."""

from pathlib import Path

import numpy as np

from grader.model.trials import TraceTrial
from grader.oracle.rays import Request
from grader.oracle.tracing import traced
from tests.oracle.prove_rule import Proof, prove, sizes, ways
from tests.oracle.tracers import BOXES, REALS, TRIANGLES, Arithmetic, Way
from tests.oracle.treebuilder import planted


def test_a_sample_of_the_proof_has_no_false_reject(tmp_path: Path) -> None:
    """All triangle tests in two arithmetics, on every traced mesh; a night does the rest."""
    proof = prove(sizes()["ci"], tmp_path)
    assert proof.total("rejected") == 0, "\n".join(proof.lines())
    assert proof.total("verdicts") > 100_000
    assert all(count.verdicts for count in proof.counts.values())
    # Whatever comes closer to its tolerance than this will be rejected some day.
    assert max(count.worst for count in proof.counts.values()) < 0.9


def test_every_combination_has_its_turn() -> None:
    """Each triangle test meets each slab test, with and without an early out."""
    seen = {
        (way.triangle, way.box, way.early, way.real)
        for turn in range(2 * len(BOXES))
        for way in ways(turn)
    }
    assert len(seen) == len(TRIANGLES) * len(BOXES) * 2 * len(REALS)


def one_trial() -> TraceTrial:
    """Draw ordinary rays of one mesh."""
    mesh, tree = planted("terrain-600")
    return traced(Request(3, "terrain-600", False, 20), mesh, tree)


def test_a_reject_is_counted_and_named() -> None:
    """The proof would notice: rays that miss everything are wrong on most of the rays."""
    trial, proof = one_trial(), Proof()
    nothing = np.full(trial.family.size, np.inf, np.float32)
    proof.add(trial, nothing, Way(0, 1, True, "float"), Arithmetic("g++", 2, False))
    assert proof.total("rejected") > 0.3 * trial.family.size
    (named,) = (line for line in proof.lines() if "first rejected" in line)
    assert "g++ -O2, box test division, early out: terrain-600" in named
