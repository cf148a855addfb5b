"""How are checks decided on cases, so that our own fault never looks like a student's?"""

import time
import traceback
from collections.abc import Iterable, Iterator, Sequence

from grader.errors import failed_here
from grader.model.cases import Case
from grader.model.stages import Stop
from grader.model.verdict import Evidence, Example, Finding, Verdict
from grader.verify.check import Check

NOTHING = Evidence(0, 0)
UNPROVEN = Evidence(0, 0, (Example("there is nothing here that could show it to be right"),))


class Examiner:
    """Decides checks case by case and remembers what failed where."""

    def __init__(self, checks: Sequence[Check]) -> None:
        self._checks = checks
        self._verdicts: dict[tuple[str, str], Verdict] = {}
        self.seconds: dict[str, float] = {each.id: 0.0 for each in checks}
        """Wall seconds that each check took so far."""

    def examine(self, cases: Iterable[Case]) -> Iterator[Finding]:
        """Decide every check that looks at this kind of case, in the order of the report."""
        for case in cases:
            for each in self._checks:
                if looks_at(each, case):
                    finding = self._decide(each, case)
                    if finding:
                        self._verdicts[each.id, case.name] = finding.verdict
                        yield finding

    def _decide(self, each: Check, case: Case) -> Finding | None:
        """Decide one check; None if the worker ended too early, or did too little, to tell."""
        for need in each.needs:
            earlier = self._verdicts.get((need, case.name))
            if earlier not in (Verdict.PASS, None):
                return Finding(each.id, case.name, Verdict.BLOCKED, NOTHING, need)
        started = time.monotonic()
        try:
            evidence = each.decide(case)
        except Exception as fault:  # noqa: BLE001 - any fault of a check is ours: it becomes BROKEN
            return Finding(
                *(each.id, case.name, Verdict.BROKEN, NOTHING, failed_here(fault)),
                traceback=traceback.format_exc(limit=8),
            )
        finally:
            self.seconds[each.id] += time.monotonic() - started
        if evidence.examined == 0:
            return _of_nothing(each, case, evidence)
        if evidence.stop is not Stop.FINISHED and not evidence.wrong:
            return None
        verdict = Verdict.FAIL if evidence.wrong else Verdict.PASS
        return Finding(each.id, case.name, verdict, evidence)


def looks_at(each: Check, case: Case) -> bool:
    """Tell whether a check is decided on a case."""
    return isinstance(case, each.kind) and each.when(getattr(case, "trial", None))


def _of_nothing(each: Check, case: Case, evidence: Evidence) -> Finding | None:
    """Say why nothing was examined; None if that says nothing of the submission."""
    if evidence.stop is not Stop.FINISHED or evidence.too_small:
        return None
    if evidence.hidden_by:
        return Finding(each.id, case.name, Verdict.BLOCKED, NOTHING, evidence.hidden_by)
    # A right submission would have given this check something to look at.
    return Finding(each.id, case.name, Verdict.FAIL, UNPROVEN)
