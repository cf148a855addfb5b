"""How do a submission and its result travel between machines? By value, as bytes and JSON.

Nothing in it is pickled, and no disk is shared: an instructor's own rubric and scenes travel as
an archive. What comes back is read as strictly as a stored result, and is believed only if it
says that it is of this submission and of these settings.
"""

import base64
import hashlib
import io
import json
import zipfile
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from grader.batch.settings import Settings, Wish
from grader.batch.work import Failed, Order, Refused, unlike
from grader.errors import UsageError
from grader.gradebook.results import parsed_json, parsed_result
from grader.kept import Result
from grader.model.stages import SOURCE_NAME, Submission
from grader.output import VIEWS
from grader.package.archive import zipped
from grader.package.course import RUBRIC, course_files
from grader.plain import as_name
from grader.report.facts import counterexample_file
from grader.sandbox.office import Done, Gone

NOBODY = "submission"
"""What a submission is called where nobody has to know whose it is."""

LARGEST_ANSWER = 64 << 20
"""Bytes of an answer; a result with all its pictures has a fiftieth of that."""


@dataclass(frozen=True, slots=True)
class Terms:
    """How a machine is to grade; the same for a whole class."""

    entry: str
    """What a clerk does with a submission."""

    seconds: float
    """Wall time of an order after which something is wrong with a clerk."""

    own_sha256: str
    """Of the archive of own files; empty if there are none."""

    topic: str
    """Under which a worker tells how far it is."""


def packed_order(order: Order, terms: Terms) -> bytes:
    """Write down an order, without own files, and without anybody's name.

    A result's folder gets name and path from the store, whatever the result itself says.
    """
    given = order.submission
    if not isinstance(given, Submission):
        raise AssertionError("what holds no file is not given away")
    told = {
        "terms": asdict(terms),
        "source": base64.b64encode(given.source).decode(),
        "seed": order.wish.seed,
        "time_limit": order.wish.time_limit,
        "isolated": order.wish.isolated,
        "settings": asdict(order.settings),
    }
    return json.dumps(told).encode()


def read_order(letter: bytes) -> tuple[Order, Terms]:
    """Read what `packed_order` wrote; where the rubric lies here is not known yet."""
    told = json.loads(letter)
    source = base64.b64decode(told["source"])
    digest = hashlib.sha256(source).hexdigest()
    submission = Submission(NOBODY, SOURCE_NAME, source, digest)
    wish = Wish(told["seed"], None, told["time_limit"], told["isolated"])
    return Order(submission, wish, Settings(**told["settings"])), Terms(**told["terms"])


def packed_files(rubric: Path | None) -> bytes:
    """Pack an instructor's rubric, and the scenes that it names; nothing if there is none.

    Raises:
        UsageError: The rubric is wrong, or its scenes lie where no archive can hold them.
    """
    return b"" if rubric is None else zipped(course_files(rubric))


def unpack_files(own: bytes, folder: Path) -> Path | None:
    """Unpack own files into an empty folder of ours; the rubric, if there is one."""
    if not own:
        return None
    with zipfile.ZipFile(io.BytesIO(own)) as archive:
        archive.extractall(folder)
    return folder / RUBRIC


def packed_answer(news: Done | Gone) -> bytes:
    """Write down what became of an order."""
    if isinstance(news, Gone):
        return json.dumps({"schema": 1, "gone": news.why, "said": news.said}).encode()
    answer = news.result
    if isinstance(answer, Result):
        told: Any = {"text": answer.text, "attachments": answer.attachments}
    else:
        told = {"refused" if isinstance(answer, Refused) else "failed": answer.why}
    if not isinstance(answer, Refused):
        told["traceback"] = answer.traceback
    return json.dumps({"schema": 1, **told}).encode()


def read_answer(answer: object, ticket: int, order: Order) -> Done | Gone:
    """Read an answer, and believe only what can be the result of this order."""
    if not isinstance(answer, bytes) or len(answer) > LARGEST_ANSWER:
        return Gone(ticket, "what came back is no answer")
    try:
        told = parsed_json(answer, "what came back", 1)
        if "gone" in told:
            return Gone(ticket, as_name(str(told["gone"])), str(told.get("said", "")))
        if "failed" in told:
            failed = Failed(str(told["failed"]), str(told.get("traceback", "")))
            return Done(ticket, failed)
        if "refused" in told:
            return Done(ticket, Refused(str(told["refused"])))
        return Done(ticket, _result(told, order))
    except UsageError as fault:
        return Gone(ticket, str(fault))


def _result(told: dict[str, Any], order: Order) -> Result:
    """Take a result apart.

    Raises:
        UsageError: It is none, or another one's.
    """
    text, attachments = told.get("text"), told.get("attachments")
    if not isinstance(text, str) or not isinstance(attachments, list):
        raise UsageError("what came back is no result")
    result = parsed_result(text.encode(), "the result that came back")
    _require_ours(result, order)
    allowed = {VIEWS, *(counterexample_file(check["id"]) for check in result["checks"])}
    files: dict[str, str] = {}
    for each in attachments:
        match each:
            case [str(name), str(content)] if name in allowed and name not in files:
                files[name] = content
            case _:
                raise UsageError("a file came back that no result has")
    if VIEWS in files:
        parsed_json(files[VIEWS].encode(), f"{VIEWS} that came back", 1)
    return Result(text, tuple(files.items()), str(told.get("traceback", "")))


def _require_ours(result: dict[str, Any], order: Order) -> None:
    wrong = unlike(result, order.settings)
    if not isinstance(order.submission, Submission):
        raise AssertionError("what holds no file is not given away")
    if result["submission"]["sha256"] != order.submission.sha256:
        wrong.append("submission")
    if wrong:
        raise UsageError(f"the result that came back is of another {', '.join(wrong)}")
