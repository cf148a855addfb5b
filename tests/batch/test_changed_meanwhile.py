"""What changes or breaks beside the submissions costs nobody a point."""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch import work
from grader.batch.settings import Settings
from grader.batch.work import Failed, Order, Refused
from grader.kept import kept
from grader.model.stages import Submission
from tests.batch.classes import CODE, folder_of, grade, points, results, zip_of
from tests.batch.stand_in import WISH, begun, job
from tests.report import samples


@pytest.mark.parametrize("place", ["local", "listed"])
def test_a_class_s_zip_that_is_damaged_costs_nobody_a_point(
    tmp_path: Path, log: Path, place: str
) -> None:
    """The student did not pack it; what was read before still counts."""
    path = zip_of(tmp_path, "class", {"ada.cpp": CODE, "bob.cpp": "wrong"})
    whole, mark = path.read_bytes(), b"PK\x03\x04" if place == "local" else b"PK\x01\x02"
    # Packed by Deflate64, as large zips are; or the name beside the data is another one.
    at = whole.index(mark) + (30 if place == "local" else 10)
    broken = whole[:at] + bytes([9]) + whole[at + 1 :]
    path.write_bytes(broken)
    totals, seen = grade(path, job(tmp_path / "first"))
    assert (totals.graded, totals.withheld) == (1, 1)
    assert points(tmp_path / "first")["ada"] is None
    assert "download it again" in results(tmp_path / "first")["ada"]["checks"][0]["message"]
    path.write_bytes(whole)
    grade(path, job(tmp_path / "second"))
    path.write_bytes(broken)
    _, seen = grade(path, job(tmp_path / "second"))
    assert points(tmp_path / "second")["ada"] == 50
    assert [told.endswith("the earlier file still counts") for told in seen.troubles] == [True]


def test_a_rubric_that_changes_meanwhile_ends_the_class(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is read for each submission: some would be graded by the one, some by the other."""
    other = replace(samples.perfect().provenance, rubric_sha256="0" * 64)
    graded = replace(samples.perfect(), provenance=other)
    monkeypatch.setattr(work, "differences", lambda *_: "")
    monkeypatch.setattr(work, "grade_located", lambda *_: graded)
    settings = Settings("g", "1" * 64, other.scenes_sha256, other.seed, other.isolation, None)
    order = Order(Submission("ada", "x.cpp", b"", ""), WISH, settings)
    answer = work.graded(order, lambda _: None)
    assert isinstance(answer, Refused)
    assert answer.why.startswith("rubric_sha256: not what the class was begun with")
    same = replace(settings, rubric_sha256="0" * 64)
    assert work.graded(replace(order, settings=same), lambda _: None) == kept(graded)


def test_a_fault_that_nobody_foresaw_is_worded_by_its_kind(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its traceback comes along for a maintainer."""

    def breaks(*_: object) -> None:
        raise KeyError("secret")

    monkeypatch.setattr(work, "differences", lambda *_: "")
    monkeypatch.setattr(work, "grade_located", breaks)
    settings = Settings("g", "1" * 64, "2" * 64, 41, "none", None)
    order = Order(Submission("ada", "x.cpp", b"", ""), WISH, settings)
    answer = work.graded(order, lambda _: None)
    assert isinstance(answer, Failed)
    assert answer.why == "The grader itself failed here (KeyError); it costs no points."
    assert "secret" in answer.traceback


def test_an_empty_file_of_ours_is_written_again(tmp_path: Path, log: Path) -> None:
    """Power that fails can leave one."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE})
    grade(path, job(tmp_path / "out"))
    (tmp_path / "out/students/ada/result.json").write_text("")
    grade(path, job(tmp_path / "out"))
    assert points(tmp_path / "out") == {"ada": 50}
    assert len(begun(log)) == 1
