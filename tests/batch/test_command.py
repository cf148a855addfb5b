"""`bvhgrade batch` grades real submissions, and says what is wrong with a call."""

import json
import sqlite3
import subprocess
import sys
from pathlib import Path

import jsonschema
import pytest

from grader.batch.sources import opened_class
from grader.cli.batch import graded, tell_of
from grader.output import ready
from grader.report.as_json import schema_text
from tests.batch.classes import class_of, folder_of, results, zip_of
from tests.batch.stand_in import SETTINGS, job
from tests.cli.calls import call
from tests.cli.test_processes import environment
from tests.own_files import ROOT

PATIENCE = 600.0
SUBMISSIONS = ROOT / "tests/submissions"
RIGHT = (SUBMISSIONS / "right/own-slab-test.cpp").read_bytes()
WRONG = (SUBMISSIONS / "wrong/axis-always-x.cpp").read_bytes()


def typed(*words: str | Path, cache: Path) -> subprocess.Popen[bytes]:
    """Type the command."""
    return subprocess.Popen(
        [sys.executable, "-m", "grader", "batch", *map(str, words)],
        env=environment(BVHGRADE_CACHE=str(cache)),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def batch(*words: str | Path, cache: Path) -> subprocess.CompletedProcess[str]:
    """Type the command, and wait for its end."""
    with typed(*words, cache=cache) as process:
        out, err = process.communicate(timeout=PATIENCE)
    return subprocess.CompletedProcess(words, process.returncode, out.decode(), err.decode())


@pytest.mark.xdist_group("batch")
def test_three_real_submissions(tmp_path: Path, cache: Path) -> None:
    """A download of Moodle: one right, one with a mistake, and the right one again."""
    given = {
        "Ada Lovelace_11_assignsubmission_file/exercise03.cpp": RIGHT,
        "Ben Berg_12_assignsubmission_file/exercise03.cpp": WRONG,
        "Cy Clo_13_assignsubmission_file/mine.cpp": RIGHT,
    }
    path = zip_of(tmp_path, "CG-Exercise 3-4711", given)
    ended = batch(path, "-o", tmp_path / "out", cache=cache)
    assert (ended.returncode, ended.stdout.splitlines()[:1]) == (
        0,
        ["3 submissions, Moodle layout"],
    ), ended.stderr
    assert "grading 2 different files" in ended.stderr
    found = results(tmp_path / "out")
    scores = {slug: result["score"] for slug, result in found.items()}
    assert scores["ada-lovelace-11"] == scores["cy-clo-13"] == 50
    assert 0 < scores["ben-berg-12"] < 50
    for result in found.values():
        jsonschema.validate(result, json.loads(schema_text()))
    (named,) = (tmp_path / "out/students/ben-berg-12/counterexamples").iterdir()
    assert named.name == "bvh.splits-the-longest-axis.json"
    assert found["cy-clo-13"]["submission"]["name"] == "Cy Clo"

    again = batch(path, "-o", tmp_path / "out", cache=cache)
    assert again.returncode == 0
    assert "grading 0 different files" in again.stderr
    other = batch(path, "-o", tmp_path / "out", "--seed", "7", cache=cache)
    assert other.returncode == 2
    assert "seed: 41 -> 7" in other.stderr


def test_a_folder_without_submissions_is_refused(tmp_path: Path, cache: Path) -> None:
    """And what lies there instead is named, harmlessly."""
    path = folder_of(tmp_path, "class", {"\x1b[31mnotes.txt": "x"})
    ended = batch(path, "-o", tmp_path / "out", "--unsafe-no-isolation", cache=cache)
    assert ended.returncode == 2
    assert f"{path}: there is no submission in it" in ended.stderr
    assert "\\x1b[31mnotes.txt" in ended.stdout


def test_all_that_is_not_graded_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """However much there is: a student's file may be among it."""
    others = {f"{number}.pdf": "" for number in range(30)}
    with class_of(folder_of(tmp_path, "class", {"ada.cpp": RIGHT, **others})) as class_:
        tell_of(Path("class.zip"), class_)
    *named, last = capsys.readouterr().out.splitlines()
    assert named == [f"nobody's: `{name}`" for name in sorted(others)]
    assert last == "1 submissions, plain layout"


def test_what_is_nobody_s_is_counted_at_the_end(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its names stand above hundreds of lines then."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "a", "ben.pdf": "", "cy.txt": ""})
    out = job(ready(tmp_path / "out"))
    assert graded(path, out) == 0
    assert capsys.readouterr().err.endswith("nobody's: 2 named above; look whether they are\n")
    assert graded(folder_of(tmp_path, "other", {"ada.cpp": "a"}), out) == 0
    assert "nobody's" not in capsys.readouterr().err


def test_results_do_not_lie_among_the_submissions(tmp_path: Path) -> None:
    """The next call would take them for submissions."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "a"})
    done = call("batch", str(path), "-o", str(path))
    assert done.exit_code == 2
    assert "name another folder with -o" in done.output
    assert [each.name for each in path.iterdir()] == ["ada.cpp"]


def test_a_fault_of_the_reader_is_not_the_class_s(tmp_path: Path) -> None:
    """Whatever breaks while a class is open, its folder can be read."""
    path = folder_of(tmp_path, "class", {"ada.cpp": "a"})
    with pytest.raises(BrokenPipeError), opened_class(path):
        raise BrokenPipeError


def test_a_store_holds_everything(tmp_path: Path) -> None:
    """Settings are written as text that a person reads."""
    from grader.batch.settings import read_settings
    from grader.batch.store import opened_store

    with opened_store(tmp_path) as store:
        store.know(SETTINGS)
    with sqlite3.connect(tmp_path / "batch.sqlite") as base:
        ((text,),) = base.execute("SELECT text FROM settings").fetchall()
    base.close()
    assert read_settings(text) == SETTINGS
