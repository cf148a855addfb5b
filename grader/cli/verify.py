"""The command that grades again and says whether a stored result still holds."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click
from click.exceptions import Exit

from grader.cli.grading import graded, is_withheld
from grader.cli.options import rubric_option, submission_type, time_option, unsafe_option
from grader.cli.order import ordered
from grader.cli.status import FULL_MARKS, LOST_POINTS, OUR_FAULT
from grader.errors import UsageError
from grader.output import STORE
from grader.report.escape import line_for_terminal

if TYPE_CHECKING:
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
    folder of a class, `batch` has kept the SUBMISSION.

    Exit status: 0 reproduced, 1 something differs, 2 wrong usage, 3 the grader failed.
    """
    from grader.batch.comparison import points
    from grader.gradebook.results import read_result
    from grader.report.as_json import to_json

    stored = read_result(result)
    seed = stored["provenance"]["seed"]
    with submitted(result, submission, stored["submission"]["sha256"]) as path:
        order = ordered(path, {**given, "seed": seed, "language": "en"})
        grade = graded(replace(order, views=False))
    found = differences(stored, to_json(grade))
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
    folders = [each for each in result.resolve().parents if (each / STORE).is_file()]
    if not folders:
        raise UsageError(
            f"{result} is in no class's folder, which would hold the submission; name it as "
            "well: bvhgrade verify RESULT SUBMISSION"
        )
    from grader.batch.store import opened_store

    with opened_store(folders[0]) as store:
        source = store.source(sha256)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "exercise03.cpp"
        path.write_bytes(source)
        yield path


def differences(stored: "Json", again: "Json") -> list[str]:
    """Say what differs: the file, what decides points, and then the points; nothing if none."""
    from grader.batch.comparison import compared, lines, provenance_changes

    before, after = (one["submission"]["sha256"] for one in (stored, again))
    found = [] if before == after else ["the submission is not the file that was graded"]
    changes = provenance_changes(stored["provenance"], again["provenance"])
    found += [f"provenance, {change}" for change in changes]
    if change := compared(stored, again):
        first, *checks = lines(change)
        found += [f"points, {first}", *(f"check, {line}" for line in checks)]
    return found
