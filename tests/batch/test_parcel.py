"""What travels between machines is bytes, and nothing that comes back is believed untested."""

import hashlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from grader.batch.parcel import (
    Terms,
    packed_answer,
    packed_files,
    packed_order,
    read_answer,
    read_order,
    unpack_files,
)
from grader.batch.settings import settled
from grader.batch.work import Failed, Order, Refused
from grader.errors import UsageError
from grader.kept import Result
from grader.model.stages import Submission
from grader.output import VIEWS
from grader.sandbox.office import Done, Gone
from grader.score.rubric import SHIPPED
from tests.batch.stand_in import SETTINGS, WISH, graded
from tests.oracle.own import own_folder

SOURCE = "int ä;\r\n__main__\0".encode("latin-1")
SUBMISSION = Submission("Äda", "äda/b.cpp", SOURCE, hashlib.sha256(SOURCE).hexdigest())
ORDER = Order(SUBMISSION, WISH, SETTINGS)
TERMS = Terms("tests.batch.stand_in:graded", 60.0, "", "topic")


@pytest.fixture
def right(log: Path) -> dict[str, Any]:
    """What a worker says of the order, as values."""
    result = graded(ORDER, lambda _: None)
    assert isinstance(result, Result)
    told: dict[str, Any] = json.loads(packed_answer(Done(7, result)))
    assert read_answer(json.dumps(told).encode(), 7, ORDER) == Done(7, result)
    broken = Done(7, replace(result, traceback="Traceback"))
    assert read_answer(packed_answer(broken), 7, ORDER) == broken
    return told


def test_an_order_arrives_without_a_name() -> None:
    """Whatever bytes a submission has; nobody there has to know whose they are."""
    nameless = replace(SUBMISSION, student="submission", path="exercise03.cpp")
    letter = packed_order(ORDER, TERMS)
    assert read_order(letter) == (replace(ORDER, submission=nameless), TERMS)
    assert b"b.cpp" not in letter


@pytest.mark.parametrize(
    "news",
    [
        *(Gone(7, "it ended"), Gone(7, "it ended", "Traceback")),
        *(Done(7, Failed("no memory")), Done(7, Failed("it failed", "Traceback"))),
        Done(7, Refused("another")),
    ],
)
def test_what_is_no_result_arrives_as_it_was(news: Done | Gone) -> None:
    """With its reason."""
    assert read_answer(packed_answer(news), 7, ORDER) == news


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("submission", "sha256", "0" * 64),
        ("provenance", "seed", 42),
        ("provenance", "rubric_sha256", "0" * 64),
        ("provenance", "scenes_sha256", "0" * 64),
        ("provenance", "isolation", "seccomp"),
    ],
)
def test_the_result_of_something_else_is_not_taken(
    right: dict[str, Any], part: str, name: str, value: object
) -> None:
    """Of another submission, or graded in another way."""
    result = json.loads(right["text"])
    result[part][name] = value
    news = read_answer(json.dumps(right | {"text": json.dumps(result)}).encode(), 7, ORDER)
    assert isinstance(news, Gone)
    assert (name if part == "provenance" else part) in news.why


@pytest.mark.parametrize(
    "attached",
    [
        [["../../result.json", "{}"]],
        [["report.html", "<script>"]],
        [["counterexamples/no-such-check.json", '{"schema": 1}']],
        [[VIEWS, "no JSON"]],
        [[VIEWS, '{"schema": 1}'], [VIEWS, '{"schema": 1}']],
        [[VIEWS]],
        [VIEWS],
        {},
        None,
    ],
)
def test_a_file_that_no_result_has_is_not_taken(
    right: dict[str, Any], attached: object
) -> None:
    """Its name would become a path."""
    answer = json.dumps(right | {"attachments": attached}).encode()
    assert isinstance(read_answer(answer, 7, ORDER), Gone)


@pytest.mark.parametrize(
    "answer",
    [
        None,
        "{}",
        b"",
        b"{}",
        b"\xff",
        b"[1]",
        b'{"schema": 1}',
        b'{"schema": 1, "text": "{}", "attachments": []}',
        b'{"schema": 1, "text": 3, "attachments": []}',
        b"[" * 100_000,
    ],
)
def test_an_answer_that_is_none_is_one_more_try(answer: object) -> None:
    """It is news of this order, and of no other."""
    news = read_answer(answer, 7, ORDER)
    assert isinstance(news, Gone)
    assert news.ticket == 7


def test_own_files_arrive_as_they_were(tmp_path: Path) -> None:
    """Same digests, same archive twice, and nothing at all without a rubric."""
    assert packed_files(None) == b""
    assert unpack_files(b"", tmp_path) is None
    own_folder(tmp_path)
    (tmp_path / "ours/notes.obj").write_text("a model, of which no grade depends")
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    packed = packed_files(rubric)
    assert packed == packed_files(rubric)
    there = tmp_path / "there"
    there.mkdir()
    found = unpack_files(packed, there)
    assert found == there / "rubric.toml"
    assert not (there / "ours/notes.obj").exists()
    here = settled(replace(WISH, rubric=rubric))
    assert settled(replace(WISH, rubric=found)) == here


@pytest.mark.parametrize("named", ["../ours", "{folder}/ours"])
def test_scenes_that_lie_elsewhere_are_refused(tmp_path: Path, named: str) -> None:
    """An archive cannot hold them where the rubric names them."""
    own_folder(tmp_path)
    (tmp_path / "exam").mkdir()
    rubric = tmp_path / "exam/rubric.toml"
    named = named.format(folder=tmp_path)
    rubric.write_text(SHIPPED.read_text() + f'[scenes]\nfolder = "{named}"\n')
    with pytest.raises(UsageError, match="beside"):
        packed_files(rubric)
