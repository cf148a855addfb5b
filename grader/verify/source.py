"""Does the file compile, and does `construct` loop instead of calling itself?"""

import re

from grader.model.cases import BuildCase, SourceCase
from grader.model.stages import CallGraph
from grader.model.verdict import Evidence, Example
from grader.verify.check import check, one

CONSTRUCT = "_ZN3BVH9constructERK4Mesh"
TREE_TYPES = re.compile(r"(?<!\d)(4Node|4AABB)|_ZN?K?3BVH12getFaceIndices")
"""Mangled names that speak of nodes or boxes: whoever calls these builds the tree.

A sorting helper only touches face indices and centres, so it never reaches one of them.
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
    for name in sorted(_reachable(callees, CONSTRUCT) | {CONSTRUCT}):
        if STANDARD.match(name):
            continue
        below = _reachable(callees, name)
        if name in below and _builds(below | {name}):
            lines = dict(case.graph.lines)
            line = lines.get(name, 0)
            where = f"line {line}" if line else "a function that construct calls"
            text = f"{where}: this function calls itself, but construct must use a loop"
            example = Example(text, "a loop over the nodes", "recursion")
            return Evidence(1, 1, (example,), line=line)
    return one(None)


def _builds(names: set[str]) -> bool:
    """Whether a cycle has to do with nodes or boxes, and not only with sorting."""
    return any(TREE_TYPES.search(name) for name in names)


def _callees(graph: CallGraph) -> dict[str, set[str]]:
    """Who is called by whom, with calls through `std::function` resolved by signature.

    If several functions share a signature, nothing says which one is meant: such a call is
    followed only if there is one target, so that nobody is blamed for a guess.
    """
    callees: dict[str, set[str]] = {}
    for call in graph.calls:
        callees.setdefault(call.caller, set()).add(call.callee)
    targets: dict[str, set[str]] = {}
    names = set(callees).union(*callees.values()) if callees else set()
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


def _reachable(callees: dict[str, set[str]], start: str) -> set[str]:
    """Everything that `start` may call, itself only if it can be called again."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        for name in callees.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found
