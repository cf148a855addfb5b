"""Failing checks of real libraries get small inputs, which the model solution passes."""

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from grader.certify.corpus import corpus_folder
from grader.cli import cli
from grader.counterexample.search import Search, counterexample, with_counterexamples
from grader.counterexample.written import to_text
from grader.model.counterexample import Counterexample
from grader.model.stages import Stop
from grader.model.trials import ConstructTrial, ImageTrial, TraceTrial, Trial
from grader.model.verdict import Verdict
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers
from grader.run.session import Engine
from grader.run.trials import Engines
from grader.solution import Solution
from tests.compiled import engine_of, library_of
from tests.report import samples
from tests.run.test_requests import rays
from tests.verify.builder import build, mesh_of, soup


def engine(name: str, folder: Path) -> Engine:
    """Compile a submission of the corpus."""
    source = (corpus_folder() / "wrong" / f"{name}.cpp").read_text()
    return engine_of(library_of(source, folder))


@pytest.fixture(scope="module")
def reversed_halves(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give a library that puts the larger centres on the left."""
    return engine("comparator-with-greater", tmp_path_factory.mktemp("greater"))


@pytest.fixture(scope="module")
def last_hit(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Give a library that returns the last hit and not the closest."""
    return engine("last-hit-wins", tmp_path_factory.mktemp("last"))


def traced(name: str = "soup, ordinary rays") -> TraceTrial:
    """Rays through a pile of 37 faces, with answers."""
    corners = np.array([[-9, -8, 0], [9, -7, 0.3], [0, 9, 0.1]])
    mesh = mesh_of(corners + np.arange(37)[:, None, None] * (0, 0, 0.1))
    found = answers(mesh, rays(), balanced_tree(mesh))
    family = np.zeros(len(rays().t_min), np.int64)
    return TraceTrial(name, mesh, build(mesh), rays(), found, ("inbound",), family, False)


def searched(
    engine: Engine,
    check: str,
    trials: Sequence[Trial],
    seconds: float = 60.0,
    visibility: str = "visible",
) -> Counterexample | None:
    """Look for the counterexample of one check that failed on some trials."""
    failed = replace(
        samples.check(1),
        check=check,
        verdict=Verdict.FAIL,
        visibility=visibility,
        stop=Stop.FINISHED,
        cases=tuple((trial.name, Verdict.FAIL) for trial in trials),
    )
    deadline = time.monotonic() + seconds
    search = Search(trials, Engines(engine), Solution(), deadline, False, lambda _: False)
    if seconds and visibility == "visible":
        return counterexample(failed, search)
    return with_counterexamples(samples.graded([failed]), search).checks[0].counterexample


def test_a_wrong_tree_needs_five_faces(reversed_halves: Engine) -> None:
    """Of 600 faces five are left, the fewest that are split at all; and always the same."""
    trials = [ConstructTrial("tree over soup", soup(600))]
    found = searched(reversed_halves, "bvh.splits-at-the-median", trials)
    assert found
    assert (found.faces, found.rays, found.found_in) == (5, 0, "tree over soup")
    assert len(set(found.trial.mesh.faces.ravel().tolist())) == len(found.trial.mesh.vertices)  # type: ignore[union-attr]  # a trial of part a
    assert "node 0: the left half reaches to" in found.message
    again = searched(reversed_halves, "bvh.splits-at-the-median", trials)
    assert again
    assert to_text(again) == to_text(found)


def test_a_wrong_hit_needs_two_faces_and_one_ray(last_hit: Engine) -> None:
    """The closest and the one that was taken instead."""
    found = searched(last_hit, "hits.closest-wins", [traced()])
    assert found
    assert (found.faces, found.rays) == (2, 1)
    assert "overwritten by a hit at t =" in found.explanation
    assert found.expected.startswith("a hit on face ")
    assert found.got.startswith("t is ")


def test_a_file_shows_a_wrong_tree_again(reversed_halves: Engine, tmp_path: Path) -> None:
    """`check --replay` builds the submission, fails on the input, and draws both trees."""
    trials = [ConstructTrial("tree over soup", soup(600))]
    found = searched(reversed_halves, "bvh.splits-at-the-median", trials)
    assert found
    file = tmp_path / "median.json"
    file.write_text(to_text(found))
    source = corpus_folder() / "wrong" / "comparator-with-greater.cpp"
    shown = CliRunner().invoke(cli, ["check", str(source), "--replay", str(file)])
    assert shown.exit_code == 1, shown.output
    assert found.message.split(",")[0] in " ".join(shown.output.split())
    assert shown.output.count("faceIndices") == 2
    file.write_text(to_text(found).replace('"construct"', '"rebuild"'))
    refused = CliRunner().invoke(cli, ["check", str(source), "--replay", str(file)])
    assert (refused.exit_code, "median.json" in refused.output) == (2, True), refused.output


def test_what_does_not_fail_has_no_counterexample(last_hit: Engine) -> None:
    """A check that the submission passes on the named case is not talked into failing."""
    trials = [ConstructTrial("tree over soup", soup(37))]
    assert searched(last_hit, "bvh.splits-at-the-median", trials) is None


def test_the_clock_ends_a_search_without_a_trace(last_hit: Engine) -> None:
    """No time left: no counterexample, and not a larger one."""
    assert searched(last_hit, "hits.closest-wins", [traced()], seconds=0.0) is None


def test_inputs_of_hidden_checks_are_not_looked_for(last_hit: Engine) -> None:
    """A student's own run keeps what the rubric hides."""
    trials = [traced()]
    assert searched(last_hit, "hits.closest-wins", trials, visibility="hidden") is None


def pictured() -> list[Trial]:
    """Take a picture of a plan: 65,536 pixels of nested spheres."""
    return [trial for trial in Solution().plan(41).trials if trial.name == "nested"]


def test_a_rare_pixel_needs_few_faces_and_one_ray(last_hit: Engine) -> None:
    """Among every sixteenth pixel there is none that is wrong."""
    found = searched(last_hit, "image.equals-mitsuba", pictured())
    assert found
    assert (found.found_in, found.rays) == ("nested", 1)
    assert found.faces <= 9


def test_no_input_comes_from_a_hidden_scene(last_hit: Engine) -> None:
    """Not even for a teacher: what is stored is what a student reads."""
    (picture,) = pictured()
    assert isinstance(picture, ImageTrial)
    hidden = replace(picture, shown=False)
    assert searched(last_hit, "image.equals-mitsuba", [hidden]) is None


@pytest.mark.usefixtures("cache")
def test_a_pixel_that_is_wrong_after_another_needs_both(tmp_path: Path) -> None:
    """Alone it is right: what the submission remembers of the ray before is its mistake."""
    forgetful = engine("same-face-as-the-pixel-before", tmp_path)
    found = searched(forgetful, "image.equals-mitsuba", pictured())
    assert found
    assert found.rays == 2
