"""How the engine turns what a check says, or its failing, into a finding."""

from collections.abc import Callable

import numpy as np
import pytest

from grader.errors import failed_here
from grader.model.cases import BuildCase
from grader.model.stages import Stop
from grader.model.verdict import Evidence, Example, Finding, Verdict
from grader.verify.check import Check, check, judged, one
from grader.verify.engine import Examiner
from tests.verify.builder import build, soup, tree_case

CASE = BuildCase("build", ())
WRONG = Example("where: what")


def saying(evidence: Evidence, id: str = "t.first", needs: tuple[str, ...] = ()) -> Check:
    """Make a check that always says the same."""

    @check(BuildCase, id, needs=needs)
    def decide(_: BuildCase) -> Evidence:
        """It holds."""
        return evidence

    return decide


def raising(error: Exception, id: str = "t.first") -> Check:
    """Make a check with a fault of our own."""

    @check(BuildCase, id)
    def decide(_: BuildCase) -> Evidence:
        """It holds."""
        raise error

    return decide


def examined(*checks: Check) -> list[Finding]:
    """Decide some checks on one case."""
    return list(Examiner(checks).examine([CASE]))


@pytest.mark.parametrize(
    ("evidence", "verdict"),
    [
        (Evidence(1, 0), Verdict.PASS),
        (Evidence(9, 1, (WRONG,)), Verdict.FAIL),
        (Evidence(1, 1), Verdict.FAIL),
        (Evidence(1, 1, (WRONG,), Stop.CRASHED), Verdict.FAIL),
    ],
)
def test_evidence_decides(evidence: Evidence, verdict: Verdict) -> None:
    """Something wrong fails, nothing wrong of something examined passes."""
    (found,) = examined(saying(evidence))
    assert (found.check, found.case, found.verdict) == ("t.first", "build", verdict)
    assert found.evidence == evidence


def test_nothing_examined_is_never_a_pass() -> None:
    """A check without anything to look at fails, and says why."""
    (found,) = examined(saying(Evidence(0, 0)))
    assert found.verdict is Verdict.FAIL
    assert "nothing here" in found.evidence.examples[0].message


@pytest.mark.parametrize("stop", [each for each in Stop if each is not Stop.FINISHED])
def test_a_worker_that_ended_too_early_to_tell_gives_no_finding(stop: Stop) -> None:
    """Its end is judged elsewhere, once."""
    assert examined(saying(Evidence(0, 0, stop=stop))) == []


@pytest.mark.parametrize(
    "error",
    [ValueError("x"), IndexError("x"), MemoryError(), RecursionError(), AssertionError()],
)
def test_our_own_fault_is_broken_with_its_traceback(error: Exception) -> None:
    """A fault of a check never looks like a student's, and the other checks go on."""
    broken, fine = examined(raising(error), saying(Evidence(1, 0), "t.second"))
    assert broken.verdict is Verdict.BROKEN
    assert broken.reason == failed_here(error)
    assert "test_engine.py" in broken.traceback
    assert broken.evidence == Evidence(0, 0)
    assert fine.verdict is Verdict.PASS


@pytest.mark.parametrize("stop", [KeyboardInterrupt, SystemExit])
def test_the_users_interrupt_is_no_fault(stop: type[BaseException]) -> None:
    """Ctrl-C ends the run and becomes no verdict."""

    @check(BuildCase, "t.first")
    def decide(_: BuildCase) -> Evidence:
        """It holds."""
        raise stop

    with pytest.raises(stop):
        examined(decide)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (saying(Evidence(1, 0)), Verdict.PASS),
        (saying(Evidence(1, 1)), Verdict.BLOCKED),
        (saying(Evidence(0, 0)), Verdict.BLOCKED),
        (raising(ValueError()), Verdict.BLOCKED),
        (saying(Evidence(0, 0, stop=Stop.CRASHED)), Verdict.PASS),
    ],
)
def test_a_check_is_blocked_unless_what_it_needs_passed(first: Check, second: Verdict) -> None:
    """The blocker is named; where the needed check said nothing, nothing is blocked."""
    found = examined(first, saying(Evidence(1, 0), "t.second", ("t.first",)))[-1]
    assert found.verdict is second
    assert found.reason == ("t.first" if second is Verdict.BLOCKED else "")


def test_a_check_may_leave_a_case_to_another_one() -> None:
    """What is hidden by another mistake is BLOCKED; what is too small to tell is left out."""
    hidden = saying(Evidence(0, 0, hidden_by="t.first"), "t.second")
    small = saying(Evidence(0, 0, too_small=True), "t.third")
    found = examined(saying(Evidence(1, 1)), hidden, small)
    assert [each.check for each in found] == ["t.first", "t.second"]
    assert (found[1].verdict, found[1].reason) == (Verdict.BLOCKED, "t.first")


def test_a_blocked_check_blocks_what_needs_it() -> None:
    """A chain of needs ends with the first failure."""
    found = examined(
        saying(Evidence(1, 1)),
        saying(Evidence(1, 0), "t.second", ("t.first",)),
        saying(Evidence(1, 0), "t.third", ("t.second",)),
    )
    assert [each.verdict for each in found[1:]] == [Verdict.BLOCKED] * 2
    assert found[2].reason == "t.second"


def test_needs_hold_per_case_and_across_calls() -> None:
    """A failure in one case blocks nothing in another, even if both came separately."""

    @check(BuildCase, "t.first")
    def compiles(case: BuildCase) -> Evidence:
        """It compiles."""
        return one(WRONG if case.errors else None)

    examiner = Examiner([compiles, saying(Evidence(1, 0), "t.second", ("t.first",))])
    verdicts = [
        [found.verdict for found in examiner.examine([case])]
        for case in (BuildCase("bad", ("error",)), BuildCase("good", ()))
    ]
    assert verdicts == [[Verdict.FAIL, Verdict.BLOCKED], [Verdict.PASS, Verdict.PASS]]


def test_checks_only_see_their_kind_of_case() -> None:
    """A check of builds is not asked about a tree."""
    mesh = soup(5)
    case = tree_case(mesh, build(mesh))
    assert list(Examiner([raising(ValueError())]).examine([case])) == []


def test_time_is_taken_also_of_a_check_that_broke() -> None:
    """Every check has its seconds, those that never ran included."""
    examiner = Examiner([raising(ValueError()), saying(Evidence(1, 0), "t.second")])
    assert examiner.seconds == {"t.first": 0.0, "t.second": 0.0}
    list(examiner.examine([CASE]))
    assert all(seconds > 0 for seconds in examiner.seconds.values())


def worded(place: int) -> Example:
    """Word one wrong place."""
    return Example(f"place {place}")


@pytest.mark.parametrize("size", [0, 1, 5])
@pytest.mark.parametrize("wrong", [0, 1, 5])
def test_a_mask_is_counted_and_its_first_three_places_worded(size: int, wrong: int) -> None:
    """All wrong places count, three are shown."""
    mask = np.arange(size + wrong) >= size
    evidence = judged(mask, worded)
    assert (evidence.examined, evidence.wrong) == (size + wrong, wrong)
    assert [each.message for each in evidence.examples] == [
        f"place {size + k}" for k in range(min(wrong, 3))
    ]


def test_a_check_is_named_by_the_first_line_of_its_sentence() -> None:
    """The title is what is true of a right submission, without the full stop."""
    named: Callable[[BuildCase], Evidence] = saying(Evidence(1, 0)).decide
    assert named.__doc__ == "It holds."
    assert saying(Evidence(1, 0)).title == "It holds"
