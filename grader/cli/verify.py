"""The command that grades again and says whether a stored result still holds."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.grading import graded, is_withheld
from grader.cli.options import rubric_option, submission_type, time_option, unsafe_option
from grader.cli.order import Order, ordered
from grader.cli.status import FULL_MARKS, LOST_POINTS, OUR_FAULT
from grader.errors import UsageError
from grader.gradebook.known import class_of
from grader.model.stages import SOURCE_NAME
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
    from grader.batch.settings import Settings
    from grader.report.as_json import Json


@click.command()
@click.argument("result", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.argument("submission", type=submission_type, required=False)
@rubric_option
@time_option
@unsafe_option
def verify(
    result: Path,
    submission: Path | None,
    **given: Any,  # noqa: ANN401 - click's own
) -> None:
    """Grade SUBMISSION again as RESULT says, and compare.

    RESULT is a result.json; its seed is taken, and --rubric has to name its rubric. In the
    folder of a class, `batch` has kept the SUBMISSION and the time limit.

    Exit status: 0 reproduced, 1 something differs, 2 wrong usage, 3 the grader failed.
    """
    from grader.batch.comparison import points
    from grader.gradebook.results import read_result
    from grader.report.as_json import to_json

    stored = read_result(result)
    settings = settings_of(result)
    limit = given["time_limit"] or (settings.time_limit if settings else None)
    given |= {"seed": stored["provenance"]["seed"], "time_limit": limit, "language": "en"}
    with submitted(result, submission, stored["submission"]["sha256"]) as path:
        order = ordered(path, given)
        others = other_settings(settings, order) if settings else []
        grade = graded(replace(order, views=False))
    found = differences(stored, to_json(grade), others)
    for line in found or [f"reproduced: {points(stored)}"]:
        click.echo(line_for_terminal(line))
    if is_withheld(grade):
        raise Exit(OUR_FAULT)
    raise Exit(LOST_POINTS if found else FULL_MARKS)


@contextmanager
def submitted(result: Path, named: Path | None, sha256: str | None) -> Iterator[Path]:
    """Find what was graded: the file that was named, or what the class's store holds.

    Raises:
        UsageError: No file was named, and none was graded, or no store holds these bytes.
    """
    if named is not None:
        yield named
        return
    if sha256 is None:
        raise UsageError(
            f"{result} tells of no file: none was found in what was handed in, or it could not "
            "be read, so nothing is kept that could be graded again; name what was handed in: "
            "bvhgrade verify RESULT SUBMISSION"
        )
    home = class_of(result.parent)
    if home is None:
        raise UsageError(
            f"{result} is in no class's folder, which would hold the submission; name it as "
            "well: bvhgrade verify RESULT SUBMISSION"
        )
    from grader.batch.store import read_store

    with read_store(home) as store:
        source = store.source(sha256)
    with TemporaryDirectory() as folder:
        path = Path(folder) / SOURCE_NAME
        path.write_bytes(source)
        yield path


def settings_of(result: Path) -> "Settings | None":
    """Find what the class that a result lies in was graded with; None if that is not known.

    Raises:
        UsageError: A batch uses the store.
    """
    folder = class_of(result.parent)
    if folder is None:
        return None
    from grader.batch.store import read_store

    slug = result.resolve().parent.name
    with read_store(folder) as store:
        settings = store.current()
        written = {one.written for one in store.students() if one.slug == slug}
    # After a regrade that ended early, a folder still holds what earlier settings gave.
    return settings if settings and settings.digest in written else None


def other_settings(before: "Settings", order: Order) -> list[str]:
    """Say what decides points, is in no `result.json`, and was otherwise for the class.

    Raises:
        UsageError: The rubric is wrong.
        MissingTool: Nothing here isolates a submission.
    """
    from grader.batch.settings import Wish, settled

    now = settled(Wish(order.seed, order.rubric, order.time_limit, order.isolated))
    # The rest is in the provenance of the result.
    return before.changes(replace(before, grader=now.grader, time_limit=now.time_limit))


def differences(stored: "Json", again: "Json", others: Sequence[str] = ()) -> list[str]:
    """Say what differs: the file, what decides points, and then the points; nothing if none.

    Args:
        stored: The result that is looked at.
        again: What the same submission gets now.
        others: What is different in the settings of its class.
    """
    from grader.batch.comparison import compared, lines, points, provenance_changes

    file = other_file(stored, again)
    changes = provenance_changes(stored["provenance"], again["provenance"])
    found = [*file, *(f"provenance, {change}" for change in changes)]
    found += [f"settings, {other}" for other in others]
    if change := compared(stored, again):
        first, *checks = lines(change)
        found += [f"points, {first}", *(f"check, {line}" for line in checks)]
    elif found and not file:
        # Of another file, equal points say nothing.
        found += [f"points: the same, {points(stored)}"]
    return found


def other_file(stored: "Json", again: "Json") -> list[str]:
    """Say whether another file was graded, or none for another reason."""
    before, after = (one["submission"]["sha256"] for one in (stored, again))
    if before and after:
        return [] if before == after else ["the submission is not the file that was graded"]
    was, now = (_refusal(one) for one in (stored, again))
    return [] if was == now else [f"the submission, {was} -> {now}"]


def _refusal(result: "Json") -> str:
    """Word why there was no file to grade."""
    if result["submission"]["sha256"]:
        return "a file"
    return f"no file ({' '.join(one['text'] for one in result['build']['diagnostics'])})"
