"""Another ray tracer that fails costs its own line of the table, and nothing else."""

from collections.abc import Sequence
from pathlib import Path

import pytest

from grader.bench import against_embree, others
from grader.bench.against_embree import GIVEN, embree_for, laid_out
from grader.bench.rays import camera_rays, scattered_rays
from grader.errors import WorkerFault
from grader.oracle.generated import landscape
from grader.sandbox.launch import Outcome


def test_one_that_fails_is_told_and_the_other_is_timed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As trimesh does without embreex; what is printed may be no numbers, too."""
    said: list[WorkerFault | bytes] = [
        WorkerFault("no module embreex"),
        b'{"construct": 1, "camera": 4, "scattered": 5}',
    ]

    def program(command: Sequence[str]) -> Outcome:
        assert command[-1] == str(tmp_path / GIVEN)
        told = said.pop(0)
        if isinstance(told, WorkerFault):
            raise told
        return Outcome(0, timed_out=False, out=told, err=b"", seconds=0.0, cpu_seconds=0.0)

    monkeypatch.setattr(others, "program", program)
    monkeypatch.setattr(others, "find_spec", lambda _: True)
    peers, remarks = others.measured(tmp_path)
    assert [(each.name, each.camera) for each in peers] == [(others.NAMES["mitsuba"], 0.25)]
    assert remarks == ("trimesh did not come back with numbers",)
    said += [b"{}", b"no numbers"]
    assert others.measured(tmp_path)[0] == ()


def test_rays_are_laid_out_for_the_others_without_embree(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Mitsuba needs no embreex."""
    mesh = landscape(100, 1)
    bundles = {"camera": camera_rays(mesh, 2), "scattered": scattered_rays(mesh, 3)}
    monkeypatch.setattr(against_embree, "find_spec", lambda _: None)
    assert embree_for(tmp_path / "embree", laid_out(tmp_path, mesh, bundles)) is None
    assert (tmp_path / GIVEN).is_file()
