"""What is known of a submission becomes a grade, and our own faults are nobody's."""

import pytest

from grader.model.verdict import Verdict
from grader.options import Options
from grader.selection import select
from grader.summary import Summary
from tests.report import samples
from tests.verify.test_work import altered

TREE = "work.uses-the-tree"


@pytest.mark.parametrize("only", [(), (TREE,)])
def test_contradicting_witnesses_fail_nobody(only: tuple[str, ...]) -> None:
    """Not even who ignores the tree, for what is lost from an altered one the answers say."""
    case, _ = altered(0)
    selection = select(None, only)
    for faults in ((), ((case.name, "the rule and Embree contradict each other"),)):
        summary = Summary(selection, Options(1, None, only, lambda *_: None), "none")
        summary.broken(faults)
        summary.examine([case])
        grade = summary.grade(samples.SUBMISSION, samples.BUILD, [case.trial])
        (found,) = (one for one in grade.checks if one.check == TREE)
        assert found.verdict is (Verdict.BROKEN if faults else Verdict.FAIL)
        assert summary.closed(TREE) is not bool(faults)
        assert grade.needs_review is bool(faults)
