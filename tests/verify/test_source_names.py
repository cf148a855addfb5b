"""Names that are mad, and graphs that are large: recursion is found all the same."""

from itertools import pairwise

import pytest

from grader.model.verdict import Evidence
from grader.verify import source
from grader.verify.source import construct_loops
from tests.verify.test_source import CONSTRUCT, EXTEND, case_of


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


def test_a_name_is_looked_into_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many functions call it: a thousand long ones, called from 160, took minutes."""
    asked: list[str] = []

    def is_lifetime(name: str) -> bool:
        asked.append(name)
        return False

    monkeypatch.setattr(source, "is_lifetime", is_lifetime)
    calls = [(f"_Z1{a}v", f"_Z1{b}v") for a in "abcdef" for b in "uvwxyz"]
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)
    assert len(asked) == len(set(asked))


def test_a_large_graph_is_walked_once() -> None:
    """Ten thousand functions that each call themselves and the next one: no walk for each."""
    names = [f"_Z5f{k:05d}v" for k in range(10_000)]
    chain = [*pairwise(names), *((name, name) for name in names)]
    calls = [(CONSTRUCT, names[0]), *chain]
    assert construct_loops.decide(case_of(*calls)) == Evidence(1, 0)
    assert construct_loops.decide(case_of(*calls, (names[-1], EXTEND))).wrong == 1
    assert construct_loops.decide(case_of(*calls, (names[-1], names[0]))).wrong == 0
