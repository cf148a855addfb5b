"""What is taken off, kept or spread in a measurement is what its page says."""

import json
from pathlib import Path

import pytest

from grader.bench import classes, goals, solutions, table, waiting, whole
from grader.bench.record import Cost
from grader.model.mesh import Floats, Mesh
from grader.output import OUTPUT, RESULT
from grader.run.trials import at_once
from grader.verify import tree
from tests.verify.builder import build, soup


def test_the_start_of_a_class_is_no_cost_of_its_files(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Half a second a file, in a small class and in a large one: the ratio is 1."""
    took = {2: (9.0, 50.0), 10: (13.0, 54.0), 1_000: (508.0, 108.0)}
    monkeypatch.setattr(classes, "_graded", lambda _, count: took[count])
    time, memory = classes.measured(tmp_path, 10, 1_000)
    assert time.ratio is not None
    assert memory.ratio is not None
    assert (time.goal, time.ratio.median) == (goals.CLASS_TIME, 1.0)
    assert time.detail == "500 ms of 1,000 / 500 ms of 10"
    assert (memory.goal, memory.ratio.median) == (goals.CLASS_MEMORY, 2.0)


@pytest.mark.parametrize("seen", [False, True])
def test_the_table_of_a_mesh_is_computed_in_every_round(
    monkeypatch: pytest.MonkeyPatch, seen: bool
) -> None:
    """It is kept for the mesh, and a later round would be too cheap."""
    made: list[Mesh] = []
    whole_table = tree._face_minima

    def compute(mesh: Mesh) -> Floats:
        made.append(mesh)
        return whole_table(mesh)

    monkeypatch.setattr(tree, "LARGE", 1)
    monkeypatch.setattr(tree, "_face_minima", compute)
    mesh = soup(40)
    for _ in range(2):
        solutions.check_cost(mesh, build(mesh), seen)
    assert len(made) == 2


def test_own_seconds_are_without_compilers_and_workers(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As the result says; the help is measured beside it."""
    asked = []

    def run(*words: str | Path, folder: Path | None = None) -> Cost:
        asked.append(words[0])
        if folder is not None:
            (folder / OUTPUT).mkdir(exist_ok=True)
            timing = {"total": 3.0, "compile": 1.5, "submission": 0.5}
            (folder / OUTPUT / RESULT).write_text(json.dumps({"timing": timing}))
        return Cost(0.0, 0.25)

    monkeypatch.setattr(waiting, "grader_cost", run)
    quick, helped = waiting.measured(tmp_path, 2)
    assert asked == ["check", "--help"] * 2
    assert quick.ratio is not None
    assert helped.ratio is not None
    assert (quick.ratio.median, helped.ratio.median) == (1.0, 0.25)
    assert (quick.is_met, helped.is_met) == (True, False)


def test_the_floor_is_spread_over_all_cores() -> None:
    """Compilers with what is precompiled, and both kinds of runs."""
    names = ("precompiled", "run", "sanitized")
    costs = {name: [Cost(2.0, 9.0), Cost(4.0, 9.0), Cost(3.0, 9.0)] for name in names}
    costs["grade"] = [Cost(1.0, 7.0), Cost(1.0, 5.0), Cost(1.0, 6.0)]
    floor = whole._floor(costs)
    assert (floor.least, floor.program) == (9.0 / at_once(), 6.0)


def test_a_table_says_what_else_the_machine_did() -> None:
    """Who compares two of them has to know."""
    assert " cores, load " in table._machine()
