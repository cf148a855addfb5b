"""What becomes of a mutant is found out, stored and counted."""

from collections import Counter
from pathlib import Path

import pytest

from grader.certify import fates, study
from grader.certify.fates import Fate, Studied, counts_of, share_caught, survivors
from grader.certify.ledger import Ledger
from grader.certify.mutants import REFERENCE, Mutant, mutants_of, originals

SEED = 41


def mutant(change: str) -> Mutant:
    """Find the first mutant of the reference whose change holds a text."""
    source = originals()[REFERENCE].read_bytes()
    return next(one for one in mutants_of(REFERENCE, source) if change in one.change)


def told(fate: Fate, change: str = "a -> b") -> Studied:
    """Make up what became of a mutant."""
    return Studied("0", SEED, "x.cpp", "name", 1, change, fate.value, "")


@pytest.mark.parametrize(
    ("change", "fate", "by"),
    [
        ("-> faces.push_front(", Fate.INVALID, ""),
        ("-> const auto [a, b, c, ab, ac] = triangle;", Fate.SAME_CODE, ""),
        ("-> if (all.size() < numFacesPerLeaf ", Fate.CAUGHT, "bvh.leaves-hold-at-most-four"),
        ("-> rest.t_min = hit.t;", Fate.CAUGHT, "hits.closest-wins"),
    ],
)
@pytest.mark.usefixtures("cache")
def test_what_becomes_of_a_mutant(change: str, fate: Fate, by: str) -> None:
    """Most are decided by one compilation and a few small trials."""
    found = study.studied(mutant(change), SEED)
    assert (found.fate, found.by.partition(",")[0]) == (fate.value, by)


def test_explained_survivors_count_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who is known to be right is neither caught nor a survivor."""
    monkeypatch.setattr(fates, "explained_changes", lambda: {("x.cpp", "c -> d"): "why"})
    found = [
        *[told(Fate.CAUGHT)] * 3,
        told(Fate.SURVIVED),
        told(Fate.SURVIVED, "c -> d"),
        told(Fate.SAME_RESULTS),
        told(Fate.INVALID),
    ]
    counts = counts_of(found)["x.cpp"]
    assert (counts["caught"], counts["survived"], counts["explained"]) == (3, 1, 1)
    assert share_caught([counts]) == 0.6
    assert survivors(found) == [told(Fate.SURVIVED), told(Fate.SAME_RESULTS)]


@pytest.mark.parametrize(
    ("size", "grader", "kept"),
    [(2, "abc", False), (3, "abc", True), (4, "abc", True), (2, "new", True)],
)
def test_a_small_sample_does_not_replace_a_large_one(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, size: int, grader: str, kept: bool
) -> None:
    """Of the same grader; of another one the stored counts say nothing."""
    monkeypatch.setattr(fates, "counts_file", lambda: tmp_path / "mutants.csv")
    first, second = (counts_of([told(Fate.CAUGHT)] * each) for each in (3, size))
    fates.store_counts(first | {"y.cpp": first["x.cpp"]}, 1, "abc")
    fates.store_counts(second, 2, grader)
    lines = (tmp_path / "mutants.csv").read_text().splitlines()
    assert lines[1].startswith(f"x.cpp,2,{grader}," if kept else "x.cpp,1,abc,")
    studied = Counter({"abc": 3})  # those of y.cpp
    studied[grader if kept else "abc"] += size if kept else 3
    assert fates.stored_mutants() == studied
    assert fates.stored_counts() == {**(second if kept else first), "y.cpp": first["x.cpp"]}


def test_enough_of_the_stored_mutants_are_caught() -> None:
    """At least 97 of 100 that nobody has explained."""
    assert share_caught(fates.stored_counts().values()) >= 0.97


def test_every_explanation_is_of_a_mutant() -> None:
    """A change that no edit makes explains nothing."""
    made = {
        (name, one.change)
        for name, path in originals().items()
        for one in mutants_of(name, path.read_bytes())
    }
    assert set(fates.explained_changes()) <= made


def test_the_ledger_keeps_mutants(tmp_path: Path) -> None:
    """Written and read back, beside the rows of the corpus."""
    ledger = Ledger(tmp_path / "rows", "g")
    ledger.add_studied(told(Fate.CAUGHT))
    assert list(ledger.studied()) == [told(Fate.CAUGHT)]
    assert list(ledger.rows()) == []
