"""Which checks fail together with which misconception? Read from a table of known mistakes.

`patterns.csv` comes from the kill matrix of the wrong submissions and from what each of them
misunderstands: `python -m tests.diagnose.table` writes it.
"""

import csv
from collections.abc import Collection, Mapping
from functools import cache
from importlib.resources import files

Pattern = frozenset[str]


@cache
def patterns() -> Mapping[str, tuple[Pattern, ...]]:
    """Map each misconception to the sets of checks that are known to fail with it."""
    text = files("grader.diagnose").joinpath("patterns.csv").read_text(encoding="utf-8")
    known: dict[str, tuple[Pattern, ...]] = {}
    for line in csv.DictReader(text.splitlines()):
        pattern = frozenset(line["checks"].split())
        known[line["misconception"]] = (*known.get(line["misconception"], ()), pattern)
    return known


def explained(misconception: str) -> Pattern:
    """Return every check that is known to fail with a misconception."""
    return frozenset[str]().union(*patterns().get(misconception, ()))


def likeness(misconception: str, failed: Collection[str]) -> float:
    """How far the failed checks are those of a misconception: 1 if exactly they are."""
    known = patterns().get(misconception, ())
    given = frozenset(failed)
    return max((len(one & given) / max(len(one | given), 1) for one in known), default=0.0)
