"""The confined process that compares sources; it is started alone.

What it needs is loaded, then it gives up all rights but to compute: no file, no program, no
network. Only then it reads the sources. It answers with numbers.

Format, little endian. Input: the number of sources, and for each its length and its bytes; the
first one is the starter. Output: how many others were given up and the number of each (from 0);
then a record for each pair of others that have something in common: both numbers, both shares
(float64), two counts of places, and the places.
"""

import io
import signal
import struct
import sys
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any, BinaryIO

LENGTH = struct.Struct("<Q")
PAIR = struct.Struct("<IIddII")
PLACE = struct.Struct("<II")

SHORTEST = 25
"""Characters, with each name as one, that have to agree in a row; copydetect's own default."""

SURE = 30
"""From how many on an agreement is always found (copydetect's guarantee threshold)."""

FILE_SECONDS = 20.0
"""Processor seconds for one file; the largest that can be handed in, 1 MiB of code, takes 4."""


class TooLong(BaseException):
    """A file takes too long; no Exception, so that no library takes it for one of its own."""


def main(words: list[str]) -> None:
    """Load, close all doors, read, compare, answer."""
    from copydetect.utils import filter_code

    from grader.sandbox.inside import enter, landlock

    # Lexers and encodings are loaded when they are first used.
    filter_code("int main() { return 'a'; } // \u00e4", "", "cpp")
    # enter.py finds its helper by name, as it does in a box.
    sys.modules["landlock"] = landlock
    given, *rights = words
    enter.confine(dict(word.split("=", 1) for word in rights))
    with open(int(given), "rb") as file:  # noqa: PTH123 - a descriptor, and no path
        sources = list(read_sources(file))
    for record in compared(sources):
        sys.stdout.buffer.write(record)
    sys.stdout.buffer.flush()


def read_sources(stream: BinaryIO) -> Iterator[str]:
    """Read what is to be compared."""
    (count,) = LENGTH.unpack(stream.read(LENGTH.size))
    for _ in range(count):
        (size,) = LENGTH.unpack(stream.read(LENGTH.size))
        yield stream.read(size).decode("utf-8", "replace")


def write_sources(sources: list[bytes]) -> bytes:
    """Write the input; the first one is the starter."""
    pieces = [LENGTH.pack(len(sources))]
    for source in sources:
        pieces += [LENGTH.pack(len(source)), source]
    return b"".join(pieces)


def compared(sources: list[str]) -> Iterator[bytes]:
    """Compare each pair; what the starter has as well counts for nobody."""
    from copydetect import compare_files

    starter, *others = sources
    every = every_hash(fingerprint(starter).filtered_code)
    prints = [(number, timed(source)) for number, source in enumerate(others)]
    given_up = [number for number, one in prints if one is None]
    yield LENGTH.pack(len(given_up)) + b"".join(map(LENGTH.pack, given_up))
    known = [(number, without(every, one)) for number, one in prints if one is not None]
    for (i, first), (j, second) in combinations(known, 2):
        if not first.hashes & second.hashes:
            continue
        _, shares, places = compare_files(first, second)
        yield packed(i, j, shares, places)


def timed(source: str) -> Any:  # noqa: ANN401 - copydetect has no types
    """Reduce a source to fingerprints; None if that takes longer than FILE_SECONDS.

    The lexer's patterns divide some comments in 2^n ways. CPython looks for signals while it
    tries them, so that a handler that raises ends even that.
    """
    before = signal.signal(signal.SIGPROF, _too_long)
    try:
        signal.setitimer(signal.ITIMER_PROF, FILE_SECONDS)
        try:
            return fingerprint(source)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
    except TooLong:
        return None
    finally:
        signal.signal(signal.SIGPROF, before)


def _too_long(*_: object) -> None:
    raise TooLong


def fingerprint(source: str) -> Any:  # noqa: ANN401 - copydetect has no types
    """Reduce a source to the fingerprints of its shape; names and comments do not count."""
    from copydetect import CodeFingerprint

    text = io.StringIO(source)
    return CodeFingerprint("", SHORTEST, SURE - SHORTEST + 1, language="cpp", fp=text)


def every_hash(code: str) -> frozenset[int]:
    """All fingerprints that a text could have, wherever its windows begin."""
    from copydetect.utils import hashed_kgrams

    return frozenset(hashed_kgrams(code, SHORTEST).tolist())


def without(common: frozenset[int], one: Any) -> Any:  # noqa: ANN401 - copydetect has no types
    """Take fingerprints away that everybody has.

    By hand, because copydetect 0.5 searches its list of them as if no fingerprint could occur
    twice in a source (`assume_unique`), and takes others away as well.
    """
    from copydetect.utils import get_token_coverage

    one.hashes = {each for each in one.hashes if int(each) not in common}
    one.hash_idx = {each: one.hash_idx[each] for each in one.hashes}
    one.token_coverage = get_token_coverage(one.hash_idx, one.k, len(one.filtered_code))
    return one


def packed(i: int, j: int, shares: tuple[float, float], places: Any) -> bytes:  # noqa: ANN401 - arrays of copydetect
    """Write one record."""
    first, second = (
        [PLACE.pack(int(begin), int(end)) for begin, end in zip(*one, strict=True)]
        for one in places
    )
    both = [float(share) for share in shares]
    return PAIR.pack(i, j, *both, len(first), len(second)) + b"".join([*first, *second])


def started(given: int, rights: Mapping[str, str]) -> list[str]:
    """Write the command that starts this process.

    Args:
        given: Descriptor of the input.
        rights: What it has to give up, in the words of `grader.sandbox`.
    """
    told = [f"{name}={value}" for name, value in rights.items()]
    return [sys.executable, "-P", "-m", "grader.similar.reader", str(given), *told]


if __name__ == "__main__":
    main(sys.argv[1:])
