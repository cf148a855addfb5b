"""Who calls whom, and who builds nodes, while calls through pointers are added one by one.

A student decides how large the graph is and how many kinds of pointers there are, so nothing is
walked over anew for each of them that did not change.
"""

from collections.abc import Collection, Iterable

from grader.verify.walks import Callees, reachable, reverse

MOST_STEPS = 2_000_000
"""Calls that are walked over to tell what pointers are for; of a textbook solution it is some
hundred. Where that is not enough no further call is followed, which costs nobody points."""


class Growing:
    """A call graph to which calls are added."""

    def __init__(self, callees: Callees, builders: Collection[str]) -> None:
        """Take the calls that are certain.

        Args:
            callees: Who is called by whom; it grows.
            builders: Functions that work on nodes.
        """
        self._callees = callees
        self._callers = reverse(callees)
        self._builders = frozenset(builders)
        self._building = reachable(self._callers, builders)
        self._steps = 0

    def add(self, caller: str, targets: Iterable[str]) -> None:
        """Add calls."""
        builds = False
        for target in targets:
            self._callees.setdefault(caller, set()).add(target)
            self._callers.setdefault(target, set()).add(caller)
            builds |= target in self._building or target in self._builders
        waiting = [caller] if builds and caller not in self._building else []
        self._building.update(waiting)
        while waiting:
            fresh = self._callers.get(waiting.pop(), set()) - self._building
            self._building |= fresh
            waiting += fresh

    def all_recur(self, call: str, targets: Collection[str]) -> bool:
        """Tell whether every target makes the same call again and builds nodes.

        Then one of them calls itself in the end, whichever is meant where. A target that only
        sorts may call itself, and one that calls nothing ends it.
        """
        left = set(targets)
        if not left <= self._building:
            return False
        seen: set[str] = set()
        waiting = [call]
        while waiting and left and self._steps <= MOST_STEPS:
            callers = self._callers.get(waiting.pop(), set())
            self._steps += len(callers)
            fresh = callers - seen
            seen |= fresh
            left -= fresh
            waiting += fresh
        return not left
