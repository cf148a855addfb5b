"""How does Embree's cost come about? Its program is run in a process of its own."""

import json
import sys
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from grader.bench.libraries import DATA
from grader.bench.programs import program
from grader.build.compiler import find_compiler
from grader.errors import BuildFault
from grader.model.mesh import Mesh, Rays
from grader.run.transfer import ray_table
from grader.sandbox.launch import Order, launch

GIVEN = "given.npz"
"""Where mesh and rays are laid out for those who are compared."""

_SECONDS = 600.0


@dataclass(frozen=True, slots=True)
class Embree:
    """Embree, ready to be timed on one mesh and some bundles of rays."""

    given: Path
    loop: Path

    def seconds(self) -> dict[str, float]:
        """Run it once; CPU seconds of `construct` and of each bundle of rays, by its name.

        Raises:
            WorkerFault: It did not come back with numbers.
        """
        words = [sys.executable, "-m", "grader.bench.peers.embree"]
        outcome = program([*words, str(self.given), str(self.loop)])
        found: dict[str, float] = json.loads(outcome.out)
        return found


def laid_out(folder: Path, mesh: Mesh, bundles: dict[str, Rays]) -> Path:
    """Write the mesh and the rays that Embree, and every other ray tracer, is timed on."""
    arrays: dict[str, Any] = {name: ray_table(rays) for name, rays in bundles.items()}
    arrays |= {"vertices": mesh.vertices, "faces": mesh.faces}
    np.savez(folder / GIVEN, **arrays)
    return folder / GIVEN


def embree_for(folder: Path, given: Path) -> Embree | None:
    """Make Embree ready to be timed; None if embreex is not installed.

    Args:
        folder: Where the loop around it is compiled.
        given: What `laid_out` wrote.

    Raises:
        BuildFault: The loop around it does not compile.
    """
    if find_spec("embreex") is None:
        return None
    folder.mkdir()
    loop = folder / "loop.so"
    words = [find_compiler().path, "-x", "c", "-O2", "-fPIC", "-shared"]
    outcome = launch(Order([*words, str(DATA / "embree_loop.c"), "-o", str(loop)], _SECONDS))
    if outcome.code != 0:
        raise BuildFault(f"the loop around Embree: {outcome.err.decode(errors='replace')}")
    return Embree(given, loop)
