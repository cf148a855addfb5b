"""Walks over call graphs: who reaches whom, and who calls itself."""

from collections.abc import Iterable

Callees = dict[str, set[str]]
"""Who is called by whom."""


def names_of(callees: Callees) -> set[str]:
    """Every function that calls or is called."""
    return set(callees).union(*callees.values())


def reverse(callees: Callees) -> Callees:
    """Who calls each function."""
    callers: Callees = {}
    for caller, called in callees.items():
        for name in called:
            callers.setdefault(name, set()).add(caller)
    return callers


def reachable(callees: Callees, start: Iterable[str]) -> set[str]:
    """Everything that some of `start` may call, itself only if it can be called again."""
    found: set[str] = set()
    waiting = list(start)
    while waiting:
        for name in callees.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found


def in_cycles(callees: Callees) -> set[str]:
    """Every function that may call itself, directly or through others.

    Source: S. R. Kosaraju's two walks; linear, since a student decides how large the graph is.
    """
    callers = reverse(callees)
    left = set(callers)
    cyclic = {name for name, called in callees.items() if name in called}
    for root in reversed(_by_end(callees)):
        group, waiting = [], [root] if root in left else []
        left.discard(root)
        while waiting:
            group.append(name := waiting.pop())
            fresh = callers.get(name, set()) & left
            left -= fresh
            waiting += fresh
        if len(group) > 1:
            cyclic.update(group)
    return cyclic


def _by_end(callees: Callees) -> list[str]:
    """All callers in the order in which a walk into the depth is done with them."""
    seen: set[str] = set()
    done: list[str] = []
    for root in callees:
        waiting = [(root, iter(callees[root]))] if root not in seen else []
        seen.add(root)
        while waiting:
            _, rest = waiting[-1]
            below = next((each for each in rest if each in callees and each not in seen), None)
            if below is None:
                done.append(waiting.pop()[0])
            else:
                seen.add(below)
                waiting.append((below, iter(callees[below])))
    return done
