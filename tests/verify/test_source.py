"""Recursion in call graphs that are written by hand."""

from itertools import pairwise

import pytest

from grader.model.cases import SourceCase
from grader.model.stages import Call, CallGraph
from grader.model.verdict import Evidence
from grader.verify.source import construct_loops

CONSTRUCT = "_ZN3BVH9constructERK4Mesh"
INTERSECT = "_Z9intersectRK4MeshRK15IntersectionRay"
EXTEND = "_ZN4AABB6extendERK7Point3D"
GROW = "_ZNSt6vectorIN3BVH4NodeESaIS1_EE9push_backEOS1_"
FACES = "_ZN3BVH14getFaceIndicesERKNS_4NodeE"
SPLIT = "_ZL5splitRSt6vectorIN3BVH4NodeESaIS1_EEj"
SORT = "_Z9quicksortPjS_RK4Mesh"
LAMBDA = "_ZZN3BVH9constructERK4MeshENKUlRT_jE_clIS3_EEDaS4_j"
COMPARE = "_ZZL5splitRN3BVH4NodeERK4MeshENKUljjE_clEjj"
SORT_BY_LAMBDA = "_Z9quicksortIPjZL5splitRN3BVH4NodeERK4MeshEUljjE_EvT_S7_T0_"


def case_of(*calls: tuple[str, str], **lines: int) -> SourceCase:
    """Make the case of a call graph; lines are named by constants of this file."""
    named = tuple((globals()[name], line) for name, line in lines.items())
    return SourceCase("source", CallGraph(tuple(Call(*call) for call in calls), named))


RIGHT = {
    "nothing": (),
    "a loop": (
        (CONSTRUCT, EXTEND),
        (CONSTRUCT, GROW),
        (CONSTRUCT, "_ZSt11nth_elementIPjEvT_S1_S1_"),
    ),
    "a sorting helper": ((CONSTRUCT, EXTEND), (CONSTRUCT, SORT), (SORT, SORT)),
    "sorting in turns": ((CONSTRUCT, SORT), (SORT, "_Z4leftPj"), ("_Z4leftPj", SORT)),
    "a sorting helper for a comparator beside nodes": (
        (CONSTRUCT, SPLIT),
        (SPLIT, SORT_BY_LAMBDA),
        (SORT_BY_LAMBDA, SORT_BY_LAMBDA),
        (SORT_BY_LAMBDA, COMPARE),
    ),
    "recursion in intersect": ((CONSTRUCT, EXTEND), (INTERSECT, INTERSECT), (INTERSECT, FACES)),
    "recursion in what only intersect calls": (
        (CONSTRUCT, EXTEND),
        (INTERSECT, SPLIT),
        (SPLIT, SPLIT),
        (SPLIT, FACES),
    ),
    "recursion of the library": (
        (CONSTRUCT, GROW),
        (GROW, GROW),
        (CONSTRUCT, "_ZSt16__introsort_loopIP4NodeEvT_S2_"),
        ("_ZSt16__introsort_loopIP4NodeEvT_S2_", "_ZSt16__introsort_loopIP4NodeEvT_S2_"),
    ),
    "many paths to one function": (
        (CONSTRUCT, SPLIT),
        (CONSTRUCT, "_Z3twov"),
        ("_Z3twov", SPLIT),
        (SPLIT, EXTEND),
    ),
    "no construct at all": ((INTERSECT, SPLIT), (SPLIT, SPLIT)),
}

WRONG = {
    "itself": ((CONSTRUCT, CONSTRUCT), (CONSTRUCT, EXTEND)),
    "a helper": ((CONSTRUCT, SPLIT), (SPLIT, SPLIT)),
    "a helper without nodes in its name": (
        (CONSTRUCT, "_ZL4stepj"),
        ("_ZL4stepj", "_ZL4stepj"),
        ("_ZL4stepj", GROW),
    ),
    "a helper that touches nodes far below": (
        (CONSTRUCT, "_ZL4stepj"),
        ("_ZL4stepj", "_ZL4stepj"),
        ("_ZL4stepj", "_ZL3onev"),
        ("_ZL3onev", "_ZL3twov"),
        ("_ZL3twov", FACES),
    ),
    "in turns": ((CONSTRUCT, "_ZL3onev"), ("_ZL3onev", SPLIT), (SPLIT, "_ZL3onev")),
    "through construct": (
        (CONSTRUCT, "_ZL3onev"),
        ("_ZL3onev", CONSTRUCT),
        (CONSTRUCT, EXTEND),
    ),
    "in turns of three": (
        (CONSTRUCT, "_ZL3onev"),
        ("_ZL3onev", "_ZL3twov"),
        ("_ZL3twov", "_ZL5threev"),
        ("_ZL5threev", "_ZL3onev"),
        ("_ZL5threev", EXTEND),
    ),
    "a lambda": ((CONSTRUCT, LAMBDA), (LAMBDA, LAMBDA), (LAMBDA, GROW)),
    "through the library": (
        (CONSTRUCT, "_ZSt8for_eachIPjEvT_S1_"),
        ("_ZSt8for_eachIPjEvT_S1_", LAMBDA),
        (LAMBDA, "_ZSt8for_eachIPjEvT_S1_"),
        (LAMBDA, EXTEND),
    ),
}


@pytest.mark.parametrize("calls", RIGHT.values(), ids=RIGHT.keys())
def test_a_loop_may_call_whatever_it_likes(calls: tuple[tuple[str, str], ...]) -> None:
    """Loops, sorting helpers, the library's recursion and part b are all allowed."""
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)


@pytest.mark.parametrize("calls", WRONG.values(), ids=WRONG.keys())
@pytest.mark.parametrize("backwards", [False, True])
def test_recursion_over_nodes_is_found(
    calls: tuple[tuple[str, str], ...], backwards: bool
) -> None:
    """Direct, mutual, through lambdas and through the library, in any order of the calls."""
    evidence = construct_loops.decide(case_of(*(calls[::-1] if backwards else calls)))
    assert (evidence.examined, evidence.wrong) == (1, 1)


def test_the_line_of_the_function_is_named() -> None:
    """The message and the evidence point at the function, if its line is known."""
    calls = ((CONSTRUCT, SPLIT), (SPLIT, SPLIT))
    evidence = construct_loops.decide(case_of(*calls, CONSTRUCT=30, SPLIT=12))
    assert evidence.line == 12
    assert evidence.examples[0].message.startswith("line 12: this function calls itself")
    unknown = construct_loops.decide(case_of(*calls))
    assert unknown.line == 0
    assert unknown.examples[0].message.startswith("a function that construct calls: ")


def erased(signature: str, place: str) -> tuple[str, str]:
    """Give the names of calling a `std::function` and of one target with that signature."""
    call = f"_ZNKSt8functionIF{signature}EEclEj"
    return (
        call,
        f"_ZNSt17_Function_handlerIF{signature}EZ{place}EUljE_E9_M_invokeERKSt9_Any_dataOj",
    )


CALL, TARGET = erased("vj", "N3BVH9constructERK4Mesh")


def test_the_only_target_of_a_function_object_is_followed() -> None:
    """A lambda in a `std::function` that calls the object which holds it is recursion."""
    calls = ((CONSTRUCT, CALL), (TARGET, LAMBDA), (LAMBDA, CALL), (LAMBDA, GROW))
    assert construct_loops.decide(case_of(*calls)).wrong == 1


def test_two_targets_of_one_signature_leave_a_doubt() -> None:
    """Which of two lambdas is meant cannot be told, so nobody is blamed for a guess."""
    other = erased("vj", "L4sortv")[1]
    calls = ((CONSTRUCT, CALL), (TARGET, LAMBDA), (LAMBDA, CALL), (LAMBDA, GROW), (other, SORT))
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)


@pytest.mark.parametrize("signature", ["vi", "vjj", "jj"])
def test_a_target_of_another_signature_is_not_followed(signature: str) -> None:
    """Only a function object with the same arguments and result can hold the lambda."""
    target = erased(signature, "N3BVH9constructERK4Mesh")[1]
    calls = ((CONSTRUCT, CALL), (target, LAMBDA), (LAMBDA, CALL), (LAMBDA, GROW))
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)


@pytest.mark.parametrize(
    "name",
    ["_Z99999999999999999999x", "_Z", "", "Z", "_ZL", "_Z3", "\ufffd", "_ZZZZZ", "4Node"],
)
def test_names_that_no_compiler_makes_break_nothing(name: str) -> None:
    """Names are the student's; cut or mad ones are compared like all others."""
    evidence = construct_loops.decide(case_of((CONSTRUCT, name), (name, name), (name, EXTEND)))
    assert evidence.wrong == 1


def test_a_capital_letter_in_a_name_is_no_scope() -> None:
    """A Z inside an identifier does not hide the nodes behind it."""
    name = "_ZL7ZZsplitRSt6vectorIN3BVH4NodeESaIS1_EEj"
    assert construct_loops.decide(case_of((CONSTRUCT, name), (name, name))).wrong == 1


def test_a_large_graph_is_walked_once() -> None:
    """Ten thousand functions that each call themselves and the next one: no walk for each."""
    names = [f"_Z5f{k:05d}v" for k in range(10_000)]
    chain = [*pairwise(names), *((name, name) for name in names)]
    calls = [(CONSTRUCT, names[0]), *chain]
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)
    assert construct_loops.decide(case_of(*calls, (names[-1], EXTEND))).wrong == 1
    assert construct_loops.decide(case_of(*calls, (names[-1], names[0]))).wrong == 0
