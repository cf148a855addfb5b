"""Enough is named rightly and hardly anything wrongly, as far as the corpus can tell."""

import pytest

from grader.certify.corpus import digest_of, name_of, wrong_submissions
from tests.diagnose.measure import RIGHTLY, SILENT, WRONGLY, judged, row, shares, stored

AT_LEAST, AT_MOST = 0.70, 0.02


def current() -> dict[str, dict[str, str]]:
    """Leave out what was named for a file that has changed since."""
    digests = {name_of(one.path): digest_of(one.path) for one in wrong_submissions()}
    return {
        name: each for name, each in stored().items() if digests.get(name) == each["sha256"]
    }


def test_enough_is_named_rightly() -> None:
    """At least 70 in 100; those that were not graded yet count as not named."""
    assert shares(current())[RIGHTLY] >= AT_LEAST


def test_hardly_anything_is_named_wrongly() -> None:
    """At most 2 in 100."""
    assert shares(current())[WRONGLY] <= AT_MOST


@pytest.mark.parametrize("stem", ["boxes-from-one-vertex"])
def test_the_stored_row_is_what_the_grader_says(stem: str) -> None:
    """One of them, graded anew."""
    (one,) = [each for each in wrong_submissions() if each.path.stem == stem]
    assert row(one.path) == stored()[name_of(one.path)]


@pytest.mark.parametrize(
    ("named", "right", "word"),
    [("", "a", SILENT), ("a", "a", RIGHTLY), ("a", "b a", RIGHTLY), ("a b", "a", WRONGLY)],
)
def test_whatever_is_named_has_to_be_right(named: str, right: str, word: str) -> None:
    """One wrong name beside a right one misleads."""
    assert judged(named, right) == word
