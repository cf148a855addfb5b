"""The page of a submission says what its result says."""

import copy
import re
from dataclasses import replace
from typing import Any

import pytest

from grader.model.stages import Rejected, Submission
from grader.report.as_json import to_json
from grader.report.hints import cause_in
from grader.report.html.findings import failures, idle_parts, worst_first
from grader.report.html.submission import NOTHING, to_html
from tests.report import samples
from tests.report.html.pages import Reader, page_of


def test_the_score_and_the_parts_are_told() -> None:
    """As in the result."""
    told = Reader(page_of("failing")).text
    assert "10.5 of 50 points" in " ".join(told.split())
    assert "a) BVH construction" in told
    assert "3 of 9 checks failed. 1 of 9 checks could not be decided." in told


def test_a_withheld_score_is_no_number() -> None:
    """Our own fault is told as ours."""
    told = Reader(page_of("broken")).text
    assert "score withheld" in told
    assert "failed in these checks, which costs no points; your score is withheld:" in told
    assert "Embree and the rule of closest hits disagree on ray 3" in told


@pytest.mark.parametrize("given", [samples.SUBMISSION, Rejected("s0428", "no folder")])
def test_what_we_failed_to_grade_is_not_said_to_be_wrong(given: Submission | Rejected) -> None:
    """As where a clerk died: whether it compiles, nobody knows."""
    grade = replace(samples.broken(), build=None, submission=given)
    told = Reader(to_html(to_json(grade), None, "en")).text
    assert "The score is withheld: the grader itself failed" in told
    assert "does not compile" not in told
    assert "There is no file" not in told


def test_full_marks_leave_nothing_to_fix() -> None:
    """No empty section."""
    text = page_of("perfect")
    assert "All 9 checks pass." in text
    assert "What to fix" not in text


def test_every_check_has_a_line_with_sign_and_word() -> None:
    """And a blocked one names what it waits for."""
    told = Reader(page_of("failing")).text
    for check, *_ in samples.CHECKS:
        assert check in told
    for line in ("✓ pass", "✗ fail", "\N{EN DASH} blocked", "waits for bvh.boxes-are-tight"):
        assert line in told


def test_the_most_expensive_failure_comes_first() -> None:
    """With what waits for it, over several steps."""
    result = to_json(samples.failing())
    assert [one["id"] for one in worst_first(result)] == [
        "hits.closest-wins",
        "bvh.boxes-are-tight",
        "hits.survives-every-ray",
    ]
    last = next(one for one in result["checks"] if one["id"] == "hits.closest-wins")
    first = next(one for one in result["checks"] if one["id"] == "work.uses-the-tree")
    last |= {"verdict": "blocked", "score": 0, "blocked_by": "work.uses-the-tree"}
    first |= {"verdict": "blocked", "score": 0, "blocked_by": "hits.survives-every-ray"}
    assert worst_first(result)[0]["id"] == "hits.survives-every-ray"


def test_a_failure_tells_everything_that_is_known() -> None:
    """What happened, both values, the smallest example, the cause, the place, how to repeat."""
    result = to_json(samples.failing())
    models = [{"check": "other.check"}, {"check": "bvh.boxes-are-tight"}]
    table: dict[str, Any] = {"check": "bvh.boxes-are-tight", "columns": []}
    seen = {"models": models, "tables": [table]}
    (one,) = [each for each in failures(result, seen, str) if "boxes" in each.check]
    facts = {label: text for label, text, _ in one.facts}
    assert one.happened == "node 1 of 3 triangles: one of them reaches out"
    assert facts["expected"] == "node 1 box.max = (1.25, 1, 0)"
    assert facts["got"] == "node 1 box.max = (0.75, 1, 0)"
    assert one.smallest is not None
    assert one.smallest.size == "5 faces"
    assert one.smallest.message == "node 1: box is too small"
    assert [text for _, text, _ in one.smallest.facts] == [
        "node 1 box.max = (0.5, 1, 0)",
        "node 1 box.max = (0.25, 1, 0)",
    ]
    assert facts["look at"] == "src/exercise03.cpp:7 in boxOf"
    assert one.cause.endswith("This explains 60 of 61 places.")
    assert one.waiting == ("bvh.children-partition-their-parent",)
    assert one.model == 1
    assert one.table == table
    again, replay, view = (command for _, command in one.commands)
    assert again == "bvhgrade check src/exercise03.cpp --seed 41 --only bvh.boxes-are-tight"
    file = "bvhgrade-out/counterexamples/bvh.boxes-are-tight.json"
    assert replay == f"bvhgrade check src/exercise03.cpp --seed 41 --replay {file}"
    assert view == f"bvhgrade view src/exercise03.cpp --check {file}"
    assert len(one.hints) == 2


def test_the_smallest_example_is_drawn_node_by_node(views: dict[str, Any]) -> None:
    """As the sheet's figure: a column a node, the first difference marked in both rows."""
    page = to_html(to_json(samples.failing()), views, "de")
    (table,) = re.findall(r'<table class="nodes">.*?</table>', page, re.DOTALL)
    assert table.count("<td") == 14
    assert table.count('class="f"') == 2
    marked = '<th scope="col" class="f">1 <span class="unseen">erster Unterschied</span></th>'
    assert marked in table
    assert '<th scope="row">erwartet</th>' in table
    assert "<code>0 4 | 1 2 3</code>" in page


def test_the_smallest_input_tells_its_own_values() -> None:
    """They are others than those of the large case; where it was lost is told, too."""
    text = page_of("failing")
    block = text[text.index('id="fix-hits.closest-wins"') :]
    block = block[: block.index('class="command"')]
    large, small = block.split("The smallest input that fails: 5 faces, 1 ray")
    assert "<code>t = 1.25</code>" in large
    assert "ray 0: t is 2.5, but face 1 is hit at 1.5" in small
    assert "<code>a hit on face 1 at t = 1.5</code>" in small
    assert "was never visited after node 0" in small
    assert block.count("<h3>") == 1


def test_an_older_result_lacks_what_the_smallest_input_said() -> None:
    """Its size is known all the same."""
    result = to_json(samples.failing())
    for check in result["checks"]:
        if found := check["counterexample"]:
            check["counterexample"] = {key: found[key] for key in ("faces", "rays", "file")}
    text = to_html(result, None, "en")
    assert "The smallest input that fails: 5 faces, 1 ray" in text
    assert "ray 0: t is 2.5" not in text


def test_pixels_that_the_check_allows_are_no_mistake(views: dict[str, Any]) -> None:
    """A cross stands at a picture only if the check of pictures failed."""
    result = to_json(samples.failing())
    allowed = to_html(result, views, "en")
    assert "They are few enough to pass." in allowed
    result["checks"][-1] |= {"id": "image.equals-mitsuba", "verdict": "fail"}
    failed = to_html(result, views, "en")
    assert "They are few enough to pass." not in failed
    assert '<p><span class="verdict f">✗ fail</span> 1,600 of 262,144' in failed
    assert '<p><span class="verdict p">✓ pass</span> All 65,536' in failed


def test_how_many_are_wrong_stands_apart_from_the_first() -> None:
    """A count, and then the first wrong place."""
    result = to_json(samples.failing())
    (one,) = [
        each for each in failures(result, NOTHING, str) if each.check == "hits.closest-wins"
    ]
    assert one.happened == "61 of 4,000 wrong, first in `nested`"
    assert one.where == "ray 17: a closer hit was missed"


def test_a_hidden_check_names_no_command_and_is_the_instructor_s() -> None:
    """Nobody can repeat it, and the page says that it is not for the student."""
    result = to_json(samples.failing())
    sentences = {"en": "not to be handed out", "de": "nicht zum Weitergeben"}
    for how in ("visible", "hidden", "after_due_date"):
        for check in result["checks"]:
            check["visibility"] = how
        hidden = how != "visible"
        assert all(not (one.commands and hidden) for one in failures(result, NOTHING, str))
        for language, sentence in sentences.items():
            page = Reader(to_html(result, NOTHING, language)).text
            assert (sentence in page) == hidden


def test_parts_that_were_not_started_are_told_once() -> None:
    """Also if their checks wait for one another, and not if they wait for the compiler."""
    result = to_json(samples.starter())
    assert idle_parts(result) == ["a", "b"]
    chained = next(one for one in result["checks"] if one["id"] == "hits.closest-wins")
    chained["blocked_by"] = "work.uses-the-tree"
    assert idle_parts(result) == ["a", "b"]
    assert Reader(page_of("starter")).text.count("Part a is not started") == 1
    assert idle_parts(to_json(samples.uncompiled())) == []


def test_the_compiler_is_quoted() -> None:
    """With the student's line numbers."""
    told = Reader(page_of("uncompiled")).text
    assert "src/exercise03.cpp:7:16: error: 'class Mesh' has no member" in told
    assert "The file does not compile" in told
    assert "two exercise03.cpp" in Reader(page_of("rejected")).text


@pytest.mark.parametrize("name", ["perfect", "uncompiled"])
def test_a_run_without_isolation_has_a_banner(name: str) -> None:
    """Nobody overlooks it; a compiler reads the file too."""
    grade = getattr(samples, name)()
    exposed = replace(grade, provenance=replace(grade.provenance, isolation="none"))
    assert "NOT ISOLATED" in to_html(to_json(exposed), None, "en")
    assert "NOT ISOLATED" not in page_of(name)


def test_where_no_file_was_read_nothing_was_exposed() -> None:
    """Nothing was compiled."""
    grade = samples.rejected()
    exposed = replace(grade, provenance=replace(grade.provenance, isolation="none"))
    assert "NOT ISOLATED" not in to_html(to_json(exposed), None, "en")


def test_both_sentences_of_a_cause_are_translated() -> None:
    """They stand in one field of the result."""
    words = {"A.": "B.", "This explains {fits} of {places} places.": "{fits} aus {places}"}
    told = cause_in(
        "A. This explains 1,000 of 2,000 places.", lambda text: words.get(text, text)
    )
    assert told == "B. 1,000 aus 2,000"
    assert cause_in("", str) == ""


def test_the_page_speaks_german() -> None:
    """Every text of ours."""
    told = Reader(page_of("failing", "de")).text
    assert "Was zu beheben ist" in told
    assert "What to fix" not in told
    assert "bestanden" in told


def test_cells_and_titles_speak_german(views: dict[str, Any]) -> None:
    """What a ray met, what a scene is called, and that nothing shut the program in."""
    seen = copy.deepcopy(views)
    seen["tables"][0]["columns"][0] = [0, "hit", "miss"]
    seen["pictures"][0]["title"] = "Stanford dragon"
    result = to_json(samples.failing())
    result["provenance"]["isolation"] = "none"
    page = to_html(result, seen, "de")
    assert "<td>getroffen</td>" in page
    assert "<td>verfehlt</td>" in page
    assert ">Stanford-Drache</h3>" in page
    assert "<dt>Abschottung</dt><dd><code>keine</code></dd>" in page
    assert "von 262.144 Pixeln weichen ab" in page
