"""What all formats say alike: names of functions, what is withheld, what is worst."""

from dataclasses import replace

import pytest

from grader.model.verdict import Verdict
from grader.plain import NAME_LIMIT
from grader.report.as_json import to_json
from grader.report.facts import place, plain_name, withheld, worst
from grader.report.hosts import told
from grader.report.html import findings
from tests.report import samples


@pytest.mark.parametrize(
    ("mangled", "name"),
    [
        ("_ZN3BVH9constructERK4Mesh", "BVH::construct"),
        ("_Z9intersectRK4MeshRK15IntersectionRay", "intersect"),
        ("_ZL5boxOfRK4Meshj", "boxOf"),
        ("_ZN12_GLOBAL__N_15splitEv", "split"),
        ("_ZNK3BVH4sizeEv", "BVH::size"),
        ("_ZN3BVHC2Ev", "BVH"),
        ("_ZNSt6vectorIiE4sizeEv", ""),
        ("main", ""),
        ("_Z999x", "x"),
        ("", ""),
    ],
)
def test_names_are_read_out_of_mangled_ones(mangled: str, name: str) -> None:
    """Simple and nested names are; anything rarer gives nothing or a beginning."""
    assert plain_name(mangled) == name


def test_a_name_that_fills_a_page_is_cut() -> None:
    """A function may have any name, but a report has other lines too."""
    calls = replace(samples.CALLS, lines=((f"_Z900{'x' * 900}v", 1),))
    score = replace(samples.loose_boxes(), line=2)
    grade = replace(samples.changed(c5=score), build=replace(samples.BUILD, calls=calls))
    found = place(grade, score)
    assert found is not None
    assert len(found.function) <= NAME_LIMIT


def test_a_line_before_every_function_falls_back_on_the_part() -> None:
    """The place is still named."""
    score = replace(samples.loose_boxes(), line=1)
    found = place(samples.changed(c5=score), score)
    assert found is not None
    assert (found.line, found.function, found.exact) == (1, "BVH::construct", True)


def test_without_a_call_graph_the_function_has_no_line() -> None:
    """Nothing is invented."""
    grade = samples.failing()
    grade = replace(grade, build=replace(samples.BUILD, calls=None))
    found = place(grade, samples.first_hit_wins())
    assert found is not None
    assert (found.line, found.function) == (None, "intersect")


def test_what_waits_for_a_withheld_check_is_withheld_too() -> None:
    """Also over several steps, in any order."""
    fault = replace(samples.check(8), verdict=Verdict.BROKEN)
    middle = replace(samples.check(7), verdict=Verdict.BLOCKED, blocked_by=fault.check)
    last = replace(samples.check(6), verdict=Verdict.BLOCKED, blocked_by=middle.check)
    other = replace(samples.check(5), verdict=Verdict.BLOCKED, blocked_by="bvh.is-readable")
    grade = samples.changed(c5=other, c6=last, c7=middle, c8=fault)
    assert withheld(grade) == {fault.check, middle.check, last.check}


def test_the_worst_failure_is_the_one_that_costs_most() -> None:
    """What it blocks counts with it."""
    cheap = replace(samples.check(2), verdict=Verdict.FAIL, score=0)
    hits = replace(samples.first_hit_wins(), score=15)
    alone = worst(samples.changed(c2=cheap, c7=hits))
    assert alone is not None
    assert alone.check == "hits.closest-wins"
    blocked = replace(
        samples.check(4), verdict=Verdict.BLOCKED, score=0, blocked_by=cheap.check
    )
    together = worst(samples.changed(c2=cheap, c4=blocked, c7=hits))
    assert together is not None
    assert together.check == cheap.check


def test_every_report_takes_the_same_failure_for_the_worst() -> None:
    """With what waits over several steps: terminal, page and hosts."""
    first = replace(samples.check(2), verdict=Verdict.FAIL, score=0)
    middle = replace(samples.check(4), verdict=Verdict.BLOCKED, score=0, blocked_by=first.check)
    last = replace(samples.check(6), verdict=Verdict.BLOCKED, score=0, blocked_by=middle.check)
    # 1 + 9 + 2 points are lost there, and 11 here.
    hits = replace(samples.first_hit_wins(), score=9)
    grade = samples.changed(c2=first, c4=middle, c6=last, c7=hits)
    result = to_json(grade)
    top = worst(grade)
    assert top is not None
    assert top.check == first.check
    assert findings.worst_first(result)[0]["id"] == first.check
    assert told.worst_first(told.entries(result))[0].id == first.check


def test_nothing_is_worst_in_a_perfect_or_an_unstarted_submission() -> None:
    """There is nothing to explain."""
    assert worst(samples.perfect()) is None
    assert worst(samples.starter()) is None
