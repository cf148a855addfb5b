"""A replay passes only what a check decided; whatever else comes of it is told."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import grader.replay
from grader.cli import cli
from grader.counterexample.written import to_text
from grader.model.mesh import Bvh
from grader.model.trials import ConstructTrial, ImageTrial, TraceTrial, Trial
from grader.model.verdict import Evidence
from grader.replay import CHANGED
from grader.resources import reference_source
from grader.run.session import Engine
from grader.run.trials import Engines
from grader.verify import every_check
from tests.compiled import BEGIN, INTERSECT, engine_of, library_of
from tests.counterexample.test_search import traced
from tests.report.small_inputs import small
from tests.verify.builder import soup

Replayed = Callable[..., tuple[int, str]]

SLEEPS = 3

ENDS = f"""{BEGIN}#include <chrono>
#include <cstdlib>
#include <thread>
void BVH::construct(const Mesh& mesh) {{
  const size_t faces = mesh.getFaces().size();
  if (faces == 4) std::abort();
  if (faces == {SLEEPS}) std::this_thread::sleep_for(std::chrono::hours(1));
  for (volatile int i = 0; faces == 2; i = 1) {{}}
  nodes.assign(1, Node{{mesh.getBounds(), 0, uint32_t(faces)}});
  faceIndices.assign(faces == 1 ? 0 : faces, 0);
}}
{INTERSECT}"""
"""Dies, sleeps, loops or leaves an unreadable tree, by the number of faces."""

CHECK = "bvh.root-holds-all-faces"


@pytest.fixture(scope="module")
def engines(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engines:
    """Give the graded build alone."""
    return Engines(engine_of(library_of(ENDS, tmp_path_factory.mktemp("ends"))))


@pytest.fixture(scope="module")
def reference(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give the model solution."""
    source = reference_source().read_text()
    return engine_of(library_of(source, tmp_path_factory.mktemp("right")))


@pytest.fixture
def replayed(engines: Engines, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Replayed:
    """Show a counterexample again on what is built already."""
    monkeypatch.setattr(grader.replay, "engines_for", lambda *_: engines)

    def run(check: str, faces: int, sanitized: bool = False) -> tuple[int, str]:
        if faces == SLEEPS:
            monkeypatch.setattr(grader.replay, "PATIENCE", 3.0)
        trial = ConstructTrial("tree", soup(faces), sanitized=sanitized)
        file = tmp_path / "file.json"
        file.write_text(to_text(replace(small(), check=check, trial=trial)))
        done = CliRunner().invoke(cli, ["check", str(tmp_path), "--replay", str(file)])
        return done.exit_code, " ".join(done.output.split())

    return run


@pytest.mark.parametrize(
    ("faces", "told"),
    [
        (4, "ended by SIGABRT"),
        (2, "stopped after 1 s of computing time"),
        (1, "because bvh.is-readable fails on this input"),
    ],
)
def test_what_is_not_decided_is_no_pass(replayed: Replayed, faces: int, told: str) -> None:
    """A crash, an endless loop, an unreadable tree: how it ended, no failure, and status 1."""
    status, output = replayed(CHECK, faces)
    assert (status, told in output) == (1, True), output
    assert "any more" not in output
    assert "blocked Node 0" in output
    assert "concluded" not in output


def test_what_only_the_clock_ended_is_nobody_s_fault(replayed: Replayed) -> None:
    """A sleep, or a machine that is too busy: status 3, since nothing is known."""
    status, output = replayed(CHECK, SLEEPS)
    assert (status, "it did not come back within 3 s" in output) == (3, True), output
    assert "Nothing is concluded about the submission" in output
    assert "any more" not in output


def test_a_build_that_is_missing_is_no_pass(replayed: Replayed) -> None:
    """With sanitizers it does not compile: nothing was run at all."""
    status, output = replayed("bvh.memory-is-safe", 9, sanitized=True)
    assert (status, "could not be made" in output) == (1, True), output


def test_a_check_that_breaks_is_our_own_fault(
    replayed: Replayed, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Status 3, and nothing is concluded about the submission."""

    def breaks(_: object) -> Evidence:
        raise ZeroDivisionError

    broken = [replace(each, decide=breaks) for each in every_check() if each.id == CHECK]
    monkeypatch.setattr("grader.counterexample.probe.every_check", lambda: broken)
    status, output = replayed(CHECK, 5)
    assert (status, "itself failed here (ZeroDivisionError)" in output) == (3, True), output
    assert "Nothing is concluded" in output
    assert "Traceback" not in output
    assert "What a maintainer needs is in " in output


def test_what_is_decided_is_told(replayed: Replayed) -> None:
    """A check that passes says so; one that fails does not."""
    status, output = replayed(CHECK, 5)
    assert (status, f"{CHECK} does not fail on this input any more" in output) == (0, True)
    status, output = replayed("bvh.leaves-hold-at-most-four", 5)
    assert (status, "expected" in output) == (1, True), output


def shrunk(tree: Bvh) -> Bvh:
    """Make one box smaller than its faces."""
    high = tree.high.copy()
    high[1] = tree.low[1]
    return replace(tree, high=high)


def moved(tree: Bvh) -> Bvh:
    """Give a leaf the faces of another one."""
    last = np.flatnonzero(tree.end)[-1]
    begin, end = tree.begin.copy(), tree.end.copy()
    begin[last], end[last] = begin[last - 1], end[last - 1]
    return replace(tree, begin=begin, end=end)


def pictured(trace: TraceTrial) -> ImageTrial:
    """Take the same rays for the pixels of a picture."""
    t = trace.answers.limit.astype(np.float32)
    return ImageTrial("nested", trace.mesh, trace.tree, t.size, 1, trace.rays, trace.answers, t)


@pytest.fixture
def right(
    reference: Engine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[str, Trial], tuple[int, str]]:
    """Show a counterexample again with right code."""
    monkeypatch.setattr(grader.replay, "engines_for", lambda *_: Engines(reference))

    def run(check: str, trial: Trial) -> tuple[int, str]:
        file = tmp_path / "file.json"
        file.write_text(to_text(replace(small(), check=check, trial=trial)))
        done = CliRunner().invoke(cli, ["check", str(tmp_path), "--replay", str(file)])
        return done.exit_code, " ".join(done.output.split())

    return run


@pytest.mark.parametrize("edit", [shrunk, moved])
@pytest.mark.parametrize("check", ["hits.closest-wins", "image.equals-mitsuba"])
def test_an_edited_tree_blames_nobody(
    right: Callable[[str, Trial], tuple[int, str]], check: str, edit: Callable[[Bvh], Bvh]
) -> None:
    """Right code loses hits in a tree that somebody has changed: told so, and status 3."""
    trace = traced()
    for tree, status, told in ((trace.tree, 0, "any more"), (edit(trace.tree), 3, CHANGED)):
        asked = replace(trace, tree=tree)
        ended, output = right(check, pictured(asked) if check.startswith("image") else asked)
        assert (ended, told in output) == (status, True), output
        assert "expected" not in output
