"""Our solutions need no more instructions than they did, beside the textbook's.

Callgrind counts them: however busy the machine is, they are the same ones.
"""

import re
from pathlib import Path

import numpy as np
import pytest

from grader import resources
from grader.bench.libraries import Libraries
from grader.bench.rays import scattered_rays
from grader.build.compiler import find_compiler
from grader.oracle.generated import landscape
from grader.run.transfer import ray_table
from grader.sandbox.launch import Order, launch

pytestmark = [pytest.mark.usefixtures("cache"), pytest.mark.xdist_group("bench")]

SECONDS = 3600.0

CONSTRUCT, INTERSECT = "ex03_construct", "ex03_intersect"
MOST = {
    ("clear", CONSTRUCT): 0.42,
    ("clear", INTERSECT): 0.72,
    ("fast", CONSTRUCT): 0.42,
    ("fast", INTERSECT): 0.30,
}
"""Instructions for each one of the textbook's: a fifth more than with g++ 12, since compilers
differ."""


def ran(*words: str | Path) -> str:
    """Run a program to its end, and return what it says of itself."""
    outcome = launch(Order([str(word) for word in words], SECONDS))
    assert outcome.code == 0, outcome.err.decode(errors="replace")[-2000:]
    return outcome.err.decode()


@pytest.fixture(scope="module")
def program(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Compile what is watched, and lay out what it does."""
    folder = tmp_path_factory.mktemp("counted")
    mesh = landscape(4_000, 1)
    rays = ray_table(scattered_rays(mesh, 2_000))
    counts = np.array([len(mesh.vertices), len(mesh.faces), len(rays)], np.uint64)
    parts = (counts, mesh.vertices, mesh.faces, rays)
    (folder / "input").write_bytes(b"".join(part.tobytes() for part in parts))
    source, header = Path(__file__).with_name("counted.c"), resources.stub_folder() / "abi"
    words = [find_compiler().path, "-x", "c", "-O2", f"-I{header}", str(source)]
    ran(*words, "-o", folder / "counted")
    return folder / "counted", folder / "input"


def instructions(program: tuple[Path, Path], library: Path, function: str) -> int:
    """Count those inside of a function, and of all that it calls."""
    watch = ("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null")
    executable, given = program
    said = ran(*watch, f"--toggle-collect={function}", executable, library, given)
    found = re.search(r"Collected : (\d+)", said)
    assert found, said
    return int(found[1])


@pytest.mark.parametrize("function", [CONSTRUCT, INTERSECT])
def test_instructions_did_not_become_more(
    program: tuple[Path, Path], libraries: Libraries, function: str
) -> None:
    """For a tree over 4,000 faces, and for 2,000 rays on it."""
    found = {
        name: instructions(program, getattr(libraries, name), function)
        for name in ("textbook", "clear", "fast")
    }
    assert min(found.values()) > 100_000, found
    for name in ("clear", "fast"):
        assert found[name] < MOST[name, function] * found["textbook"], found
