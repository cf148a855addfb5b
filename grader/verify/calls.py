"""Which calls may happen while a tree is built, those through pointers included?

A function object or a table that only `intersect` fills is not called by `construct`, however
alike its signature is. Where that does not tell either, a call is followed only if every
target that may be meant leads to the same verdict: a guess never costs anybody points.
"""

import re
from collections import defaultdict
from collections.abc import Iterator

from grader.model.stages import Call, CallGraph
from grader.verify.growing import Growing
from grader.verify.mangled import STANDARD, is_lifetime, speaks_of_nodes
from grader.verify.walks import Callees, names_of, reachable

CONSTRUCT = "_ZN3BVH9constructERK4Mesh"
INTERSECT = "_Z9intersectRK4MeshRK15IntersectionRay"
DOOR = "ex03_construct"
"""Calls `construct` for the grader, and for a submission that declares it."""

ANYTHING = "*"
"""How whatever a pointer points to begins; a number behind it is the place of a virtual
function in a table."""

VIRTUAL = "_ZTV"
"""How tables of virtual functions begin."""

OBJECT_CALL = re.compile(r"_ZNKSt8functionIF(?P<signature>.+)EEclE")
OBJECT_TARGET = re.compile(r"_ZNSt17_Function_handlerIF(?P<rest>.+)E9_M_invoke")

ELSEWHERE = re.compile(r"_ZNSt6thread15_M_start_thread|(?!_Z|ex03_)")
"""What calls a pointer that it is given: threads, and functions of C, of which no others are
listed."""

MAX_SIGNATURES = 64
"""More kinds of function objects than this are not followed; a textbook solution has none."""


def callees_of(graph: CallGraph) -> Callees:
    """Who is called by whom while a tree is built, as far as it is certain."""
    takers = _takers(graph)
    elsewhere = _only_of_intersect(graph, takers)
    callees: Callees = defaultdict(set, {DOOR: {CONSTRUCT}})
    for call in (*graph.calls, *_handed_on(graph)):
        # Filling a function object is not yet a call of what it holds.
        if not _inside_the_library(call) and not _is_target(call.callee):
            callees[call.caller].add(call.callee)
    selves = _filled(graph)
    pointers = _pointers(callees, takers)
    builders = set(filter(speaks_of_nodes, names_of(callees)))
    growing = Growing(callees, builders)
    for called, meant in (*pointers, *_objects(graph)):
        targets = meant - elsewhere
        if len(targets) == 1 or growing.all_recur(called, targets):
            growing.add(called, targets)
        growing.add(called, targets & selves)
    return dict(callees)


def _handed_on(graph: CallGraph) -> Iterator[Call]:
    """Addresses whose takers may get them called at once, as by a helper that is given one.

    Who comes to no call through a pointer, as a state that names the next, leaves it to others.
    """
    callers: Callees = defaultdict(set)
    for call in graph.calls:
        if not is_pointer(call.caller):
            callers[call.callee].add(call.caller)
    pointed_at = {call.callee for call in graph.calls if call.caller == ANYTHING}
    hand_on = reachable(callers, filter(_calls_back, names_of(callers)))
    for call in graph.taken:
        if call.caller in hand_on and call.callee in pointed_at:
            yield call


def _calls_back(name: str) -> bool:
    """Tell whether this is a pointer, or a function elsewhere that calls what it is given."""
    return is_pointer(name) or ELSEWHERE.match(name) is not None


def _inside_the_library(call: Call) -> bool:
    """Tell whether a pointer is one of the standard library's own, as in `std::function`."""
    pair = (call.caller, call.callee)
    return any(map(is_pointer, pair)) and any(map(STANDARD.match, pair))


def is_pointer(name: str) -> bool:
    """Tell whether this is no function, but whatever a pointer leads to."""
    return name.startswith(ANYTHING)


def _is_target(name: str) -> bool:
    return OBJECT_TARGET.match(name) is not None


def _is_pointed_at(name: str) -> bool:
    """Tell whether a pointer may be for this function, rather than for the end of an object."""
    return not is_lifetime(name) and not name.startswith("_GLOBAL__")


def _pointers(callees: Callees, takers: Callees) -> list[tuple[str, set[str]]]:
    """Each kind of pointer that is called, and what it may be for; takes its targets out.

    A function that stands nowhere but in tables of virtual functions is called by its place.
    """
    kinds = {name for name in names_of(callees) | {ANYTHING} if is_pointer(name)}
    targets = {kind: set(filter(_is_pointed_at, callees.pop(kind, ()))) for kind in kinds}
    anything = targets.pop(ANYTHING)
    tabled = {name for name in anything if all(map(_is_table, takers.get(name, "?")))}
    placed = [(kind, anything - tabled | meant) for kind, meant in sorted(targets.items())]
    return [(ANYTHING, anything), *placed]


def _is_table(name: str) -> bool:
    return name.startswith(VIRTUAL)


def _takers(graph: CallGraph) -> Callees:
    """Who takes the address of each function."""
    takers: Callees = defaultdict(set)
    for call in graph.taken:
        takers[call.callee].add(call.caller)
    return takers


def _only_of_intersect(graph: CallGraph, takers: Callees) -> set[str]:
    """Functions whose address is taken only by `intersect` and what it alone calls."""
    reaches: Callees = defaultdict(set)
    for call in (*graph.calls, *graph.taken):
        if not is_pointer(call.caller) and not is_pointer(call.callee):
            reaches[call.caller].add(call.callee)
    apart = _from(reaches, INTERSECT) - _from(reaches, CONSTRUCT)
    return {name for name, owners in takers.items() if owners <= apart}


def _from(callees: Callees, name: str) -> set[str]:
    return reachable(callees, [name]) | {name}


def _filled(graph: CallGraph) -> set[str]:
    """What is put into each `std::function` that its own lambda holds; one walk for all."""
    fillers: Callees = defaultdict(set)
    for call in (*graph.calls, *graph.taken):
        if call.caller.startswith("_ZNSt8functionI"):
            fillers[call.caller].add(call.callee)
    return {target for target in reachable(fillers, graph.selves) if _is_target(target)}


def _objects(graph: CallGraph) -> Iterator[tuple[str, set[str]]]:
    """Each function that calls a `std::function`, and what may be in there by its signature."""
    names = sorted({name for call in graph.calls for name in (call.caller, call.callee)})
    calls = [match for name in names if (match := OBJECT_CALL.match(name))]
    targets = [match for name in names if (match := OBJECT_TARGET.match(name))]
    for call in calls[:MAX_SIGNATURES]:
        wanted = f"{call['signature']}E"
        yield call.string, {each.string for each in targets if each["rest"].startswith(wanted)}
