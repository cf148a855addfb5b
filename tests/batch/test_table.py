"""The table of a large class is made of small rows."""

import json
from pathlib import Path

import pytest

from grader.batch.files import Results
from grader.batch.store import opened_store
from grader.batch.table import write_table
from grader.kept import Result
from grader.report.as_json import to_text
from grader.report.class_row import Row
from tests.batch.stand_in import SETTINGS, job
from tests.batch.test_downloads import read
from tests.report import samples


def test_rows_of_a_class_share_what_is_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 10,000 students each has some thirty checks, and few verdicts."""
    rows: list[Row] = []
    text = to_text(samples.failing())
    read(tmp_path, {"ada.cpp": "a", "ben.cpp": "b"}, "plain")

    def page(shown: list[Row], *_: str) -> str:
        rows.extend(shown)
        return ""

    monkeypatch.setattr("grader.batch.table.to_class_page", page)
    out = job(tmp_path / "out")
    with opened_store(out.folder) as store:
        store.know(SETTINGS)
        for student in list(store.students()):
            store.keep(student.sha256 or "", SETTINGS, Result(text, ()))
        assert write_table(out, store, Results(store, out)).graded == 2
    ada, ben = rows
    assert (ada.name, ben.name) == ("ada", "ben")
    assert len(ada.verdicts) == len(json.loads(text)["checks"])
    for one, other in ((ada.verdicts, ben.verdicts), (ada.causes, ben.causes)):
        assert one
        assert all(a is b for a, b in zip(one, other, strict=True))
