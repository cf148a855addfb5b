"""Which submissions of a class have how much in common?"""

import os
import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import starmap

from grader.errors import GraderError, MissingTool
from grader.package.exercise import starter
from grader.plain import printable
from grader.sandbox.box import Bounds, Box
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, launch
from grader.sandbox.selftest import proved_isolation
from grader.sandbox.slots import own_user
from grader.sandbox.words import specification
from grader.similar import reader

SECONDS = 3600
MEMORY = 8 << 30
LARGEST_ANSWER = 512 << 20


@dataclass(frozen=True, slots=True)
class Place:
    """Characters of a source, from begin to before end."""

    begin: int
    end: int


@dataclass(frozen=True, slots=True)
class Pair:
    """Two sources and what they have in common, the starter's code not counted."""

    first: int
    second: int
    """Their numbers in the list that was compared."""

    shares: tuple[float, float]
    """Of the first, and of the second: how much of what it has of its own both have, 0 to 1."""

    places: tuple[tuple[Place, ...], tuple[Place, ...]]

    @property
    def share(self) -> float:
        """The larger one: copied code that was added to stays copied."""
        return max(self.shares)


@dataclass(frozen=True, slots=True)
class Compared:
    """What came out of a comparison."""

    pairs: tuple[Pair, ...]
    """Those that have something in common, the most alike first."""

    given_up: tuple[int, ...] = ()
    """Numbers of sources that took too long to be read, and were compared with nothing."""


def compared(sources: Sequence[bytes]) -> Compared:
    """Compare sources pair by pair.

    Raises:
        MissingTool: copydetect is not installed.
        UsageError: The starter is not the one that students got.
        WorkerFault: No process could be confined on this machine.
        GraderError: The comparison did not end as it should.
    """
    if find_spec("copydetect") is None:
        raise MissingTool(
            "copydetect, which compares submissions, is not installed; "
            'pip install "bvhgrade[similar]"'
        )
    answer = _asked(reader.write_sources([starter(), *sources]))
    return read_answer(answer, len(sources))


def _asked(question: bytes) -> bytes:
    """Let the confined process compare.

    Raises:
        GraderError: It ended in another way than it should.
    """
    isolation = proved_isolation()
    box = Box((), Bounds(SECONDS, MEMORY, open_files=32))
    with own_user() as uid:
        words = dict(word.split("=", 1) for word in specification(box, isolation, waits=False))
        if uid:
            words["uid"] = str(uid)
        # A file without a name: a pipe would have to be filled while the answer is read.
        given = os.memfd_create("sources", os.MFD_CLOEXEC)
        try:
            _write(given, question)
            return _run(reader.started(given, words), given)
        finally:
            os.close(given)


def _write(given: int, question: bytes) -> None:
    with os.fdopen(os.dup(given), "wb") as file:
        file.write(question)
    os.lseek(given, 0, os.SEEK_SET)


def _run(command: Sequence[str], given: int) -> bytes:
    outcome = launch(
        Order(
            command,
            SECONDS,
            LARGEST_ANSWER,
            descriptors=(given,),
            # Hashes of texts choose the fingerprints: the same ones in every run.
            environment={**PLAIN_ENVIRONMENT, "PYTHONHASHSEED": "0"},
        )
    )
    if outcome.timed_out or len(outcome.out) >= LARGEST_ANSWER:
        raise GraderError("the submissions are too many or too large to be compared at once")
    if outcome.code != 0:
        told = printable(outcome.err.decode(errors="replace")[-1000:])
        raise GraderError(f"the comparison ended with status {outcome.code}: {told}")
    return outcome.out


def read_answer(answer: bytes, count: int) -> Compared:
    """Read the numbers that the confined process wrote.

    Raises:
        GraderError: They are none that it could have meant.
    """
    try:
        given_up, at = _given_up(answer, count)
        found = [pair for pair in _pairs(memoryview(answer), at, count) if pair.share > 0]
    except (struct.error, ValueError) as fault:
        raise GraderError("the comparison answered with what is no list of pairs") from fault
    found.sort(key=lambda one: (-one.share, one.first, one.second))
    return Compared(tuple(found), given_up)


def _given_up(answer: bytes, count: int) -> tuple[tuple[int, ...], int]:
    """Read the numbers of what was given up; returns also where they end."""
    (size,) = reader.LENGTH.unpack_from(answer)
    end = reader.LENGTH.size * (1 + size)
    if size > count or end > len(answer):
        raise ValueError("number of numbers")
    numbers = tuple(n for (n,) in reader.LENGTH.iter_unpack(answer[reader.LENGTH.size : end]))
    if any(number >= count for number in numbers):
        raise ValueError("numbers of sources")
    return numbers, end


def _pairs(view: memoryview, at: int, count: int) -> Iterator[Pair]:
    while at < len(view):
        first, second, share, other, *sizes = reader.PAIR.unpack_from(view, at)
        at += reader.PAIR.size
        places: list[tuple[Place, ...]] = []
        for size in sizes:
            end = at + size * reader.PLACE.size
            places.append(tuple(starmap(Place, reader.PLACE.iter_unpack(view[at:end]))))
            at = end
        if not (first < second < count and at <= len(view)):
            raise ValueError("numbers of sources")
        bounded = (min(max(share, 0.0), 1.0), min(max(other, 0.0), 1.0))
        yield Pair(first, second, bounded, (places[0], places[1]))
