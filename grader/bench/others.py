"""What do other ray tracers in Python take for the same rays? Reported, and no goal."""

import json
import sys
from importlib.util import find_spec
from pathlib import Path

from grader.bench.against_embree import GIVEN
from grader.bench.programs import program
from grader.bench.record import Peer
from grader.errors import WorkerFault

NAMES = {
    "trimesh": "trimesh.ray (embreex), `intersects_first`",
    "mitsuba": "Mitsuba scalar_rgb, `ray_intersect_preliminary` in a loop",
}


def measured(folder: Path) -> tuple[tuple[Peer, ...], tuple[str, ...]]:
    """Time each that is installed, once, in a process of its own.

    Args:
        folder: Where the mesh and the rays were laid out.

    Returns:
        Those that were timed, and a remark on each that did not come back with numbers.
    """
    peers, remarks = [], []
    for name in NAMES:
        if find_spec(name) is None:
            continue
        try:
            peers.append(_peer(name, folder / GIVEN))
        except (WorkerFault, ValueError, KeyError):
            # It is no goal: what was measured of ours stays, whatever is wrong with it.
            remarks.append(f"{name} did not come back with numbers")
    return tuple(peers), tuple(remarks)


def _peer(name: str, given: Path) -> Peer:
    words = ["-m", "grader.bench.peers.others", name, str(given)]
    found = json.loads(program([sys.executable, *words]).out)
    # Microseconds a ray are millions of rays a second, turned over.
    return Peer(NAMES[name], found["construct"], 1 / found["camera"], 1 / found["scattered"])
