"""What does a program cost before it does anything? Goal 3, beside pytest and check50."""

import os
import sys
from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from grader.bench import goals
from grader.bench.libraries import by_hand
from grader.bench.programs import grader_cost, program
from grader.bench.record import Cost, Goal, Reading
from grader.bench.statistics import Run, interleaved, ratios, spread
from grader.bench.whole import unseen
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, workspace

SOURCE = """#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
void BVH::construct(const Mesh&) { nodes.clear(); }
Intersection intersect(const Mesh&, const IntersectionRay&) { return {}; }
"""

PYTEST = """import subprocess

def test_it():
    subprocess.run({command!r}, check=True)
"""

CHECK50 = """import check50

@check50.check()
def compiles():
    check50.run({line!r}).exit(0)
"""


IMPORTS = "import grader.cli.grading, grader.pipeline, grader.kept, grader.report.terminal"
PROOF = "from grader.sandbox.selftest import proved_isolation; proved_isolation()"


def measured(folder: Path, rounds: int) -> list[Reading]:
    """Compile two empty functions, by each program that is installed, in turns.

    Ours is asked for the check that they compile, and for nothing else: so are the others.
    What ours cannot do without is timed beside it, part by part.
    """
    source = folder / "trivial.cpp"
    source.write_text(SOURCE)
    framework = workspace(find_compiler(), GRADED)
    command = [*by_hand(framework), str(source), *framework.link_words]
    command += ["-o", str(folder / "trivial.so")]
    ready = [*framework.compile_command, str(source), *framework.link_words, *command[-2:]]
    runs: dict[str, Run] = {
        "ours": lambda: _ours(source, folder),
        "imports": partial(_cost, [sys.executable, "-c", IMPORTS], folder),
        "proof": partial(_cost, [sys.executable, "-c", f"{IMPORTS}; {PROOF}"], folder),
        "compiler": partial(_cost, ready, folder),
    }
    if find_spec("pytest") is not None:
        runs["pytest"] = partial(_cost, _with_pytest(folder, command), folder)
    if find_spec("check50") is not None:
        alone = folder / "alone"  # it copies the folder that it stands in
        alone.mkdir()
        runs["check50"] = partial(_cost, _with_check50(folder, command), alone)
    wall = {name: [each.wall for each in of] for name, of in interleaved(runs, rounds).items()}
    return [
        _compared(goals.PYTEST, wall, "pytest"),
        _compared(goals.CHECK50, wall, "check50"),
    ]


def _ours(source: Path, folder: Path) -> Cost:
    only = ("--only", "build.compiles")
    return grader_cost("check", unseen(source, folder), *only, folder=folder)


def _with_pytest(folder: Path, command: Sequence[str]) -> list[str]:
    test = folder / "test_trivial.py"
    test.write_text(PYTEST.format(command=list(command)))
    words = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    return [*words, "-c", os.devnull, "--rootdir", str(folder), str(test)]


def _with_check50(folder: Path, command: Sequence[str]) -> list[str]:
    checks = folder / "checks"
    checks.mkdir()
    (checks / ".cs50.yaml").write_text("check50: true\n")
    (checks / "__init__.py").write_text(CHECK50.format(line=" ".join(command)))
    return [sys.executable, "-m", "check50", "--dev", str(checks), "-o", "json"]


def _cost(command: Sequence[str], folder: Path) -> Cost:
    outcome = program(command, folder)
    return Cost(outcome.cpu_seconds, outcome.seconds)


def _compared(goal: Goal, wall: dict[str, list[float]], name: str) -> Reading:
    if name not in wall:
        return Reading(goal, None, f"{name} is not installed")
    detail = f"{spread(wall['ours']).median:.2f} s / {spread(wall[name]).median:.2f} s"
    return Reading(goal, ratios(wall["ours"], wall[name]), detail, _why(wall))


def _why(wall: dict[str, list[float]]) -> str:
    """Tell the parts of ours, none of which can be left out."""
    whole, imports, proof, compiler = (
        spread(wall[name]).median for name in ("ours", "imports", "proof", "compiler")
    )
    return (
        f"of {whole:.2f} s, Python and all that it imports take {imports:.2f} s, the proof of "
        f"the isolation {max(proof - imports, 0):.2f} s, and compiling once {compiler:.2f} s, "
        "each measured alone. The others confine nothing and import less."
    )
