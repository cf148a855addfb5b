"""What do other ray tracers in Python take for the same rays? Reported, and no goal."""

import json
import sys
from importlib.util import find_spec
from pathlib import Path

from grader.bench.programs import program
from grader.bench.record import Peer

NAMES = {
    "trimesh": "trimesh.ray (embreex), `intersects_first`",
    "mitsuba": "Mitsuba scalar_rgb, `ray_intersect_preliminary` in a loop",
}


def measured(folder: Path) -> tuple[Peer, ...]:
    """Time each that is installed, once, in a process of its own.

    Args:
        folder: Where the mesh and the rays were laid out for Embree.
    """
    given = folder / "embree" / "given.npz"
    if not given.exists():
        return ()
    return tuple(_peer(name, given) for name in NAMES if find_spec(name) is not None)


def _peer(name: str, given: Path) -> Peer:
    words = ["-m", "grader.bench.peers.others", name, str(given)]
    found = json.loads(program([sys.executable, *words]).out)
    # Microseconds a ray are millions of rays a second, turned over.
    return Peer(NAMES[name], found["construct"], 1 / found["camera"], 1 / found["scattered"])
