"""Virtual functions in call graphs that are written by hand."""

import pytest

from grader.verify.source import construct_loops
from tests.verify.test_source import CONSTRUCT, EXTEND, GROW, Pairs, taking_case

RUN, HOOK, END = "_ZN5Split3runEv", "_ZL4hookv", "_ZN5SplitD0Ev"
TABLE = "_ZTV5Split"

CALLS = ((CONSTRUCT, "*16"), ("*", RUN), ("*16", RUN), ("*", END), ("*8", END), (RUN, GROW))
TAKEN = ((TABLE, RUN), (TABLE, END), (CONSTRUCT, TABLE))


@pytest.mark.parametrize(
    ("more", "wrong"),
    [
        (((RUN, "*16"),), 1),
        (((RUN, "*"),), 1),
        (((RUN, "*8"),), 0),
        (((RUN, "*24"),), 0),
        (((RUN, "*24"), ("*", HOOK), ("*24", HOOK), (HOOK, "*16")), 1),
        (((RUN, "*16"), ("*", HOOK), ("*24", HOOK), (HOOK, EXTEND)), 1),
        (((RUN, "*16"), ("*", HOOK), ("*16", HOOK), (HOOK, EXTEND)), 0),
    ],
)
def test_a_virtual_function_is_followed_by_its_place(more: Pairs, wrong: int) -> None:
    """Deleting an object, or calling another function of it, is no call of this one."""
    taken = (*TAKEN, (TABLE, HOOK))
    assert construct_loops.decide(taking_case((*CALLS, *more), taken)).wrong == wrong


@pytest.mark.parametrize("taker", [CONSTRUCT, "_ZL5table", "*"])
def test_what_stands_elsewhere_too_may_be_called_from_any_place(taker: str) -> None:
    """A table that somebody wrote by hand is called in the same way."""
    calls = ((CONSTRUCT, "*24"), ("*", RUN), (RUN, GROW), (RUN, "*24"))
    assert construct_loops.decide(taking_case(calls, ((taker, RUN),))).wrong == 1
    assert construct_loops.decide(taking_case(calls, ((TABLE, RUN),))).wrong == 0


def test_the_librarys_virtual_functions_are_not_followed() -> None:
    """A thread begins through one that holds a lambda, and what() is one, too."""
    state = "_ZNSt6thread11_State_implIN5SplitEE6_M_runEv"
    calls = (*CALLS, (RUN, "*24"), ("*", state), ("*24", state), (state, RUN))
    assert construct_loops.decide(taking_case(calls, TAKEN)).wrong == 0


STATES = ("_ZL5fetchR1M", "_ZL5splitR1M")
RUNNER, STATE = "_ZL3runR1M", "_ZN5StateC1EPFS_R1ME"
MACHINE = (
    (CONSTRUCT, RUNNER),
    (RUNNER, "*"),
    *((state, STATE) for state in STATES),
    *(("*", state) for state in STATES),
    (STATES[1], GROW),
)
NEXT = ((CONSTRUCT, STATES[0]), STATES, STATES[::-1])


@pytest.mark.parametrize(
    ("more", "wrong"),
    [
        ((), 0),
        (((STATE, "*"),), 1),
        (((STATE, "qsort"),), 1),
        (((STATES[0], "qsort"),), 0),
        (((STATE, "_ZNSt6thread15_M_start_threadESt10unique_ptr"),), 1),
        (((STATES[0], "_ZSt20__throw_length_errorPKc"),), 0),
        (((STATES[0], STATES[1]), STATES[::-1]), 1),
    ],
)
def test_who_only_names_the_next_state_does_not_call_it(more: Pairs, wrong: int) -> None:
    """It does where it comes to a call through a pointer, or gives it to one who calls it."""
    assert construct_loops.decide(taking_case((*MACHINE, *more), NEXT)).wrong == wrong
