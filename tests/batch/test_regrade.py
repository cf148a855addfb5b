"""A new rubric, seed or grader: who would change, and why, is shown before it is applied."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch.comparison import compared, lines, provenance_changes
from grader.batch.job import Job
from grader.batch.runner import Batch
from grader.batch.store import opened_store
from grader.batch.work import Order, Refused
from grader.cli.regrading import regraded
from grader.errors import UsageError
from grader.report.as_json import to_json
from grader.score.rubric import SHIPPED
from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.stand_in import SETTINGS, anew, begun, job
from tests.cli.calls import call
from tests.report import samples


def test_equal_results_do_not_differ() -> None:
    """Times and processors may be others."""
    before = to_json(samples.perfect())
    after = before | {"timing": {}, "provenance": {}}
    assert compared(before, after) is None


def test_a_change_names_its_checks_and_why() -> None:
    """Only those that end otherwise."""
    change = compared(to_json(samples.perfect()), to_json(samples.failing()))
    assert change is not None
    first, *checks = lines(change)
    assert first.startswith("50 of 50 -> ")
    assert [line.partition(":")[0] for line in checks] == [
        "bvh.children-partition-their-parent",
        "bvh.boxes-are-tight",
        "hits.closest-wins",
        "hits.survives-every-ray",
    ]
    assert "it waits for bvh.boxes-are-tight" in checks[0]
    assert "reaches out" in checks[1]


def test_other_points_for_the_same_are_named() -> None:
    """The verdict is the same, and the rubric is another one."""
    before = to_json(samples.perfect())
    checks = [dict(one) for one in before["checks"]]
    checks[4] |= {"score": 8, "max_score": 8}
    change = compared(before, before | {"checks": checks, "score": 49, "max_score": 49})
    assert change is not None
    assert lines(change)[1:] == [
        "bvh.children-partition-their-parent: pass 9 of 9 -> pass 8 of 8: "
        "it is worth something else"
    ]


def test_parts_of_a_provenance_that_differ_are_named() -> None:
    """The processor may be another one: it decides nothing."""
    before = to_json(samples.perfect())["provenance"]
    after = before | {"seed": 7, "cpu": "another", "flags": ["-O0"]}
    changes = provenance_changes(before, after)
    assert [one.partition(":")[0] for one in changes] == ["seed", "flags"]


@pytest.fixture
def new(tmp_path: Path, log: Path) -> Job:
    """Other settings for a class that was graded already, of which one would change."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "moody", "cy.cpp": " "})
    old = job(tmp_path / "out")
    grade(path, old)
    settings, wish = replace(SETTINGS, seed=7), replace(old.wish, seed=7)
    return replace(old, settings=settings, wish=wish, preview=True)


def test_nothing_changes_before_it_is_applied(
    new: Job, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is said who would change, in which check, and why."""
    assert regraded(new, apply=False) == 0
    said = capsys.readouterr().out
    assert "seed: 41 -> 7" in said
    assert "bob: 50 of 50 -> " in said
    assert "bvh.boxes-are-tight: pass 12 of 12 -> fail " in said
    assert "ada: " not in said
    assert points(new.folder) == {"ada": 50, "bob": 50, "cy": 0}
    with opened_store(new.folder) as store:
        assert store.current() == SETTINGS


def test_what_was_shown_is_applied(new: Job, log: Path) -> None:
    """Without grading again; the results of before stay in the store."""
    regraded(new, apply=False)
    graded = len(begun(log))
    assert regraded(new, apply=True) == 0
    assert len(begun(log)) == graded
    found = points(new.folder)
    assert found["ada"] == 50
    assert found["bob"] not in (0, 50, None)
    with opened_store(new.folder) as store:
        assert store.current() == new.settings
        bob = next(one for one in store.students() if one.name == "bob")
        assert store.result(bob.sha256 or "", SETTINGS) is not None


def test_an_end_while_folders_are_written_says_what_holds(
    new: Job, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The settings are the new ones by then; the same command finishes."""
    with monkeypatch.context() as patch:

        def ended(_: Batch) -> None:
            raise KeyboardInterrupt

        patch.setattr(Batch, "write", ended)
        assert regraded(new, apply=True) == 130
    said = capsys.readouterr().err
    assert "the new results are those of the class" in said
    assert "the same command goes on" in said
    assert regraded(new, apply=True) == 0
    assert points(new.folder)["bob"] not in (0, 50, None)


@pytest.mark.parametrize("option", [["--regrade"], ["--drop", "ada"]])
def test_a_folder_without_a_class_is_not_begun(tmp_path: Path, option: list[str]) -> None:
    """A slip in its name leaves nothing behind."""
    done = call("batch", "-o", str(tmp_path / "typo"), *option)
    assert done.exit_code == 2
    assert "there is no batch.sqlite" in done.output
    assert not (tmp_path / "typo").exists()


def test_the_settings_of_the_class_are_no_news(tmp_path: Path, log: Path) -> None:
    """Nothing is deleted; with `--apply` only what an earlier call did not write is written."""
    out = tmp_path / "out"
    grade(folder_of(tmp_path, "class", {"ada.cpp": "withheld once", "bob.cpp": CODE}), job(out))
    begun_before = begun(log)
    same = replace(job(out), preview=True)
    with pytest.raises(UsageError, match="these very settings"):
        regraded(same, apply=False)
    (out / "students/bob/result.json").unlink()
    assert regraded(same, apply=True) == 3
    assert points(out) == {"ada": None, "bob": 50}
    assert begun(log) == begun_before
    with opened_store(out) as store:
        ada, _ = store.students()
        assert store.result(ada.sha256 or "", SETTINGS) is not None


def test_a_fault_of_the_cluster_says_what_is_kept(
    new: Job, capsys: pytest.CaptureFixture[str]
) -> None:
    """As it does when a class is graded for the first time."""
    refused = replace(new, entry="tests.batch.test_regrade:refused")
    assert regraded(refused, apply=True) == 3
    told = capsys.readouterr().err
    assert "bvhgrade: another machine" in told
    assert "what was graded is kept, and the same command goes on" in told


def test_namesakes_are_told_apart(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By their ids, or by their folders where there are none."""
    files = {f"{name}.cpp": "moody" for name in ("ada", "bob", "cy", "di")}
    out = tmp_path / "out"
    grade(folder_of(tmp_path, "class", files), job(out))
    ids = {"ada": "u1", "bob": "u2", "cy": "", "di": ""}
    with opened_store(out) as store:
        for one in list(store.students()):
            store.put(replace(one, name="Ada", id=ids[one.slug]), b"")
    moody = replace(anew(out), wish=replace(job(out).wish, seed=7))
    assert regraded(moody, apply=False) == 0
    said = capsys.readouterr().out
    for name in ("Ada (u1)", "Ada (u2)", "Ada (cy)", "Ada (di)"):
        assert f"\n{name}: 50 of 50 -> " in said


def test_who_handed_in_no_file_changes_too(
    tmp_path: Path, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Zero points of another maximum; nothing of it is in the store."""
    out = tmp_path / "out"
    grade(folder_of(tmp_path, "class", {"ada.cpp": CODE, "cy.cpp": " "}), job(out))
    path = tmp_path / "rubric.toml"
    path.write_text(SHIPPED.read_text().replace("\npoints = 3\n", "\npoints = 4\n", 1))
    old = job(out)
    settings = replace(SETTINGS, rubric_sha256="3" * 64)
    new = replace(old, settings=settings, wish=replace(old.wish, rubric=path), preview=True)
    assert regraded(new, apply=False) == 0
    said = capsys.readouterr().out
    assert "cy: 0 of 50 -> 0 of 51" in said
    assert "1 stay as they are" in said
    assert regraded(anew(out), apply=False) == 0
    assert "2 stay as they are" in capsys.readouterr().out


def test_a_download_has_no_place_in_a_regrade(tmp_path: Path) -> None:
    """It was passed over without a word; nothing is looked at, let alone graded."""
    ended = call("batch", str(tmp_path), "-o", str(tmp_path / "out"), "--regrade")
    assert ended.exit_code == 2
    assert "--regrade grades what" in ended.output
    ended = call("batch", str(tmp_path), "-o", str(tmp_path / "out"), "--drop", "ada")
    assert ended.exit_code == 2
    assert "--drop only takes a student out" in ended.output


def refused(order: Order, tell: Callable[[str], None]) -> Refused:
    """Grade nothing, as a machine does that would grade otherwise."""
    return Refused("another machine")


def test_there_has_to_be_something_to_compare_with(tmp_path: Path) -> None:
    """A mistyped folder."""
    with pytest.raises(UsageError, match="no results yet"):
        regraded(job(tmp_path), apply=False)
