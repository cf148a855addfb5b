"""What of a class is shown as alike? Files of several students, and pairs from a share on."""

from collections.abc import Sequence
from pathlib import Path
from statistics import median

from grader.batch.records import names_of
from grader.batch.store import read_store
from grader.errors import UsageError
from grader.output import STORE, write_whole
from grader.report.html.alike import Class, Side, to_alike_page
from grader.similar.pairs import Pair, compared

PAGE = "similar.html"

MOST_SHOWN = 50
"""Pairs whose code is shown side by side."""


def write_alike(folder: Path, least: float, footer: str, language: str) -> tuple[Path, Class]:
    """Compare the submissions of a class, and write a page about those that are alike.

    Args:
        folder: Where `bvhgrade batch` keeps the class.
        least: The share from which on a pair is shown, 0 to 1.
        footer: With what they were compared.
        language: `en` or `de`.

    Raises:
        UsageError: No class is kept there, or another batch uses it.
        MissingTool: copydetect is not installed.
        GraderError: They could not be compared.
        OutputFault: The page cannot be written.
    """
    names, sources = handed_in(folder)
    found = compared(sources)
    alike = [pair for pair in found.pairs if pair.share >= least]
    given_up = tuple(names[number] for number in found.given_up)
    count = len(sources)
    whole = Class(
        submissions=sum(map(len, names)),
        files=count,
        usual=usual_share(found.pairs, count - len(given_up)),
        least=least,
        alike=len(alike),
        given_up=given_up,
    )
    shown = [sides(pair, names, sources) for pair in alike[:MOST_SHOWN]]
    identical = [owners for owners in names if len(owners) > 1]
    path = folder / PAGE
    write_whole(path, to_alike_page(whole, shown, identical, footer, language))
    return path, whole


def handed_in(folder: Path) -> tuple[list[tuple[str, ...]], list[bytes]]:
    """Read the different files of a class, and who handed each of them in, told apart.

    Raises:
        UsageError: No class is kept there, or another batch uses it.
    """
    if not (folder / STORE).is_file():
        raise UsageError(
            f"{folder}: there is no {STORE}, but submissions are compared as `bvhgrade batch` "
            "kept them; name the folder that it wrote to"
        )
    owners: dict[str, list[str]] = {}
    with read_store(folder) as store:
        told = names_of(store.students())
        for student in store.students():
            if student.sha256 is not None:
                owners.setdefault(student.sha256, []).append(told[student.slug])
        sources = [store.source(sha256) for sha256 in owners]
    return [tuple(names) for names in owners.values()], sources


def usual_share(found: Sequence[Pair], files: int) -> float:
    """Return the median of all pairs; those with nothing in common are not among the found."""
    every = files * (files - 1) // 2
    if not every:
        return 0.0
    return float(median([*(pair.share for pair in found), *[0.0] * (every - len(found))]))


def sides(
    pair: Pair, names: Sequence[tuple[str, ...]], sources: Sequence[bytes]
) -> tuple[Side, Side]:
    """Put together what is shown of a pair."""
    first, second = (
        Side(
            names[number],
            sources[number].decode("utf-8", "replace"),
            share,
            tuple((place.begin, place.end) for place in places),
        )
        for number, share, places in zip(
            (pair.first, pair.second), pair.shares, pair.places, strict=True
        )
    )
    return first, second
