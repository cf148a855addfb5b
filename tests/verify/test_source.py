"""Recursion in call graphs that are written by hand."""

from collections.abc import Iterator
from dataclasses import replace

import pytest

from grader.model.cases import SourceCase
from grader.model.stages import Call, CallGraph
from grader.model.verdict import Evidence
from grader.verify.source import construct_loops

Pairs = tuple[tuple[str, str], ...]

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
    "through the grader's door": ((CONSTRUCT, "ex03_construct"), (CONSTRUCT, EXTEND)),
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


OTHER = erased("vj", "L4sortv")[1]
RECURSIVE = ((CONSTRUCT, CALL), (TARGET, LAMBDA), (LAMBDA, CALL), (LAMBDA, GROW))
FILL = "_ZNSt8functionIFvjEEC1IZN3BVH9constructERK4MeshEUljE_vEEOT_"
FILL_TOO = FILL.replace("C1", "C2")


def taking_case(calls: Pairs, taken: Pairs = (), selves: tuple[str, ...] = ()) -> SourceCase:
    """Make the case of a call graph in which addresses are taken."""
    pairs = (tuple(Call(*call) for call in part) for part in (calls, taken))
    calls_made, addresses = pairs
    return SourceCase("source", CallGraph(calls_made, (), addresses, selves))


def test_two_targets_of_one_signature_leave_a_doubt() -> None:
    """Which of two lambdas is meant cannot be told, so nobody is blamed for a guess."""
    assert construct_loops.decide(taking_case((*RECURSIVE, (OTHER, SORT)))) == Evidence(1, 0)


def test_what_only_intersect_fills_is_no_target_of_construct() -> None:
    """A recursive lambda of part b with the same signature leaves no doubt in part a."""
    calls = (*RECURSIVE, (OTHER, SORT), (INTERSECT, CALL), (INTERSECT, SPLIT), (SPLIT, SORT))
    only_there = ((CONSTRUCT, TARGET), (SPLIT, OTHER))
    assert construct_loops.decide(taking_case(calls, only_there)).wrong == 1
    in_both = (*only_there, (CONSTRUCT, OTHER))
    assert construct_loops.decide(taking_case(calls, in_both)).wrong == 0


def test_recursion_of_part_b_alone_is_not_followed() -> None:
    """A loop in construct calls its own object, a lambda of `intersect` calls itself."""
    loop = ((CONSTRUCT, CALL), (OTHER, GROW), (INTERSECT, CALL), *RECURSIVE[1:])
    taken = ((CONSTRUCT, OTHER), (INTERSECT, TARGET))
    assert construct_loops.decide(taking_case(loop, taken)) == Evidence(1, 0)


def test_two_targets_that_both_call_again_leave_no_doubt() -> None:
    """Whichever is meant, one of them ends up in itself, unless one of them only sorts."""
    again = (*RECURSIVE, (OTHER, SPLIT), (SPLIT, CALL), (SPLIT, GROW))
    assert construct_loops.decide(taking_case(again)).wrong == 1
    sorts = (*RECURSIVE, (OTHER, SORT), (SORT, CALL))
    assert construct_loops.decide(taking_case(sorts)) == Evidence(1, 0)


def test_an_object_that_holds_itself_is_its_own_target() -> None:
    """The closure says which of two is meant: it holds the address of its own object."""
    calls = (*RECURSIVE, (OTHER, SORT), (FILL, FILL_TOO))
    taken = ((FILL_TOO, TARGET), ("_Z3twov", OTHER))
    assert construct_loops.decide(taking_case(calls, taken, (FILL,))).wrong == 1
    assert construct_loops.decide(taking_case(calls, taken)).wrong == 0


class Counted(tuple[Call, ...]):
    """Calls that know how often somebody went through all of them."""

    passes = 0

    def __iter__(self) -> Iterator[Call]:
        """Begin once more."""
        self.passes += 1
        return super().__iter__()


def test_many_objects_that_hold_themselves_are_walked_once() -> None:
    """Inline assembly can write 190,000 of them: all calls are not read for each."""
    passes = []
    for fills in ((FILL,), (FILL, *(f"{FILL}{k}" for k in range(50)))):
        calls = (*RECURSIVE, (OTHER, SORT), *((name, FILL_TOO) for name in fills))
        taken = ((FILL_TOO, TARGET), ("_Z3twov", OTHER))
        graph = taking_case(calls, taken, fills).graph
        counted = Counted(graph.calls)
        counting = SourceCase("source", replace(graph, calls=counted))
        assert construct_loops.decide(counting).wrong == 1
        passes.append(counted.passes)
    assert passes[0] == passes[1]


def test_tasks_in_a_queue_are_a_loop() -> None:
    """A lambda that fills objects with calls of itself does not call itself."""
    calls = ((CONSTRUCT, CALL), (TARGET, LAMBDA), (LAMBDA, FILL), (FILL, FILL_TOO))
    queue = (*calls, (FILL_TOO, TARGET), (LAMBDA, GROW))
    assert construct_loops.decide(taking_case(queue, ((FILL_TOO, TARGET),))).wrong == 0


END, END_TOO = (f"_ZZN3BVH9constructERK4MeshEN5GuardD{k}Ev" for k in (1, 2))
COPY = "_ZN4TreeaSERKS_"


@pytest.mark.parametrize("name", [END, END.replace("D1", "C1"), COPY])
@pytest.mark.parametrize(("far", "wrong"), [(EXTEND, 1), ("_ZN3BVH4NodeC1Ev", 0)])
def test_objects_that_own_each_other_may_end_recursively(
    name: str, far: str, wrong: int
) -> None:
    """Copying and clearing a tree is no way to build it; extending boxes is."""
    calls = ((CONSTRUCT, name), (name, END_TOO), (END_TOO, name), (END_TOO, far))
    assert construct_loops.decide(case_of(*calls)).wrong == wrong


@pytest.mark.parametrize("name", ["_ZL9mergeSortP4Node", SORT])
@pytest.mark.parametrize("below", ["_ZN4AABBC1Ev", "_ZN4AABBaSERKS_", "_Z4leftPj"])
def test_records_to_be_sorted_may_hold_boxes(name: str, below: str) -> None:
    """A list of the student's own nodes is sorted recursively."""
    calls = ((CONSTRUCT, name), (name, name), (name, below))
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)


POINTED = (
    ("*", SPLIT),
    (SPLIT, "_Z3fewPFvjE"),
    ("_Z3fewPFvjE", "*"),
    (CONSTRUCT, "_Z3fewPFvjE"),
)


@pytest.mark.parametrize("other", [END, "_GLOBAL__sub_I_exercise03.cpp"])
def test_the_only_target_of_pointers_is_followed(other: str) -> None:
    """Destructors in a table, and what runs before `main`, are not what is called."""
    assert construct_loops.decide(case_of(*POINTED, ("*", other))).wrong == 1


def test_pointers_to_several_functions_leave_a_doubt() -> None:
    """A helper that calls what it is given is shared by the loop and by what the loop calls."""
    assert construct_loops.decide(case_of(*POINTED, ("*", EXTEND))) == Evidence(1, 0)
    taken = ((INTERSECT, INTERSECT), (CONSTRUCT, SPLIT))
    calls = (*POINTED, ("*", INTERSECT))
    assert construct_loops.decide(taking_case(calls, taken)).wrong == 1


@pytest.mark.parametrize("signature", ["vi", "vjj", "jj"])
def test_a_target_of_another_signature_is_not_followed(signature: str) -> None:
    """Only a function object with the same arguments and result can hold the lambda."""
    target = erased(signature, "N3BVH9constructERK4Mesh")[1]
    calls = ((CONSTRUCT, CALL), (target, LAMBDA), (LAMBDA, CALL), (LAMBDA, GROW))
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)
