"""Does the file compile, and does `construct` loop instead of calling itself?"""

import re
from collections.abc import Iterable

from grader.model.cases import BuildCase, SourceCase
from grader.model.stages import Call, CallGraph
from grader.model.verdict import Evidence, Example
from grader.verify.check import check, one

CONSTRUCT = "_ZN3BVH9constructERK4Mesh"
TREE_TYPES = re.compile(r"(?<!\d)(4Node|4AABB)|_ZN?K?3BVH12getFaceIndices")
"""Mangled names that speak of nodes or boxes: whoever calls these builds the tree.

A sorting helper only touches face indices and centres, so it never reaches one of them.
"""

TOKEN = re.compile(r"S[0-9A-Z]*_|T\d*_|L[a-z]n?\d+E|(?P<length>\d+)|.")
"""Pieces of a mangled name; an identifier is its length and that many letters.

Source: Itanium C++ ABI, section 5.1, "External Names (a.k.a. Mangling)".
"""

STANDARD = re.compile(r"_ZN?K?(St|Sa|Ss|9__gnu_cxx)|_Zn|_Zd")
FUNCTION_CALL = re.compile(r"_ZNKSt8functionIF(?P<signature>.+)EEclE")
FUNCTION_TARGET = re.compile(r"_ZNSt17_Function_handlerIF(?P<rest>.+)E9_M_invoke")


@check(BuildCase, "build.compiles")
def compiles(case: BuildCase) -> Evidence:
    """The file compiles and links with the given code."""
    examples = tuple(Example(text, "no error", "an error") for text in case.errors[:3])
    return Evidence(1, 1, examples) if examples else one(None)


@check(SourceCase, "source.construct-loops")
def construct_loops(case: SourceCase) -> Evidence:
    """`construct` uses a loop: no function that builds nodes calls itself, even indirectly.

    Recursion inside sorting helpers is allowed. Source: exercise sheet, part a, "using a loop,
    not recursion".
    """
    callees = _callees(case.graph)
    called = _reachable(callees, (CONSTRUCT,)) | {CONSTRUCT}
    builders = _reachable(_reverse(callees), filter(_speaks_of_nodes, _names(callees)))
    for name in sorted(_in_cycles(callees) & called):
        if name in builders and not STANDARD.match(name):
            line = dict(case.graph.lines).get(name, 0)
            where = f"line {line}" if line else "a function that construct calls"
            text = f"{where}: this function calls itself, but construct must use a loop"
            example = Example(text, "a loop over the nodes", "recursion")
            return Evidence(1, 1, (example,), line=line)
    return one(None)


def _speaks_of_nodes(name: str) -> bool:
    """Whether a function has to do with nodes or boxes, and not only with sorting.

    Where it was written does not count: the comparator inside `split(Node&)`, and a quicksort
    that is made for this comparator, carry the name of `split` in theirs.
    """
    at = 2
    while (token := TOKEN.match(name, at)) and token[0] != "Z":
        at = token.end() + int((token["length"] or "0")[:6])
    return TREE_TYPES.search(name[:at]) is not None


def _callees(graph: CallGraph) -> dict[str, set[str]]:
    """Who is called by whom, with calls through `std::function` resolved by signature.

    If several functions share a signature, nothing says which one is meant: such a call is
    followed only if there is one target, so that nobody is blamed for a guess.
    """
    callees: dict[str, set[str]] = {}
    for call in graph.calls:
        if not _inside_the_library(call):
            callees.setdefault(call.caller, set()).add(call.callee)
    targets: dict[str, set[str]] = {}
    names = _names(callees)
    calls = {name: match["signature"] for name in names if (match := FUNCTION_CALL.match(name))}
    for name in names:
        match = FUNCTION_TARGET.match(name)
        for signature in set(calls.values()) if match else ():
            if match and match["rest"].startswith(f"{signature}E"):
                targets.setdefault(signature, set()).add(name)
    for name, signature in calls.items():
        known = targets.get(signature, set())
        if len(known) == 1:
            callees.setdefault(name, set()).update(known)
    return callees


def _inside_the_library(call: Call) -> bool:
    """Tell whether a pointer is one of the standard library's own, as in `std::function`."""
    pair = (call.caller, call.callee)
    return "*" in pair and any(STANDARD.match(name) for name in pair)


def _names(callees: dict[str, set[str]]) -> set[str]:
    """Every function that calls or is called."""
    return set(callees).union(*callees.values())


def _reverse(callees: dict[str, set[str]]) -> dict[str, set[str]]:
    """Who calls each function."""
    callers: dict[str, set[str]] = {}
    for caller, called in callees.items():
        for name in called:
            callers.setdefault(name, set()).add(caller)
    return callers


def _reachable(callees: dict[str, set[str]], start: Iterable[str]) -> set[str]:
    """Everything that some of `start` may call, itself only if it can be called again."""
    found: set[str] = set()
    waiting = list(start)
    while waiting:
        for name in callees.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found


def _in_cycles(callees: dict[str, set[str]]) -> set[str]:
    """Every function that may call itself, directly or through others.

    Source: S. R. Kosaraju's two walks; linear, since a student decides how large the graph is.
    """
    callers = _reverse(callees)
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


def _by_end(callees: dict[str, set[str]]) -> list[str]:
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
