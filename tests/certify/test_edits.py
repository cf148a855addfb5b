"""Edits hit code, all kinds of it, and nothing else; a mutant is told in its own words."""

import pytest

from grader.certify.edits import edits
from grader.certify.mutants import chosen_mutants, mutants_of, originals


def texts(source: str, kind: str) -> set[str]:
    """Every source that edits of one kind make."""
    code = source.encode()
    return {edit.applied(code).decode() for edit in edits(code) if edit.kind == kind}


@pytest.mark.parametrize(
    ("kind", "source", "edited"),
    [
        ("operator", "int f() { return a < b; }", "int f() { return a <= b; }"),
        ("operator", "void f() { a += b; }", "void f() { a = b; }"),
        ("operator", "void f() { ++a; }", "void f() { --a; }"),
        ("operands", "int f() { return a - b; }", "int f() { return b - a; }"),
        ("constant", "int f() { return 4; }", "int f() { return (4 + 1); }"),
        ("name", "int f() { return a.min; }", "int f() { return a.max; }"),
        ("name", "uint32_t f();", "uint16_t f();"),
        ("condition", "void f() { if (a) g(); }", "void f() { if (!(a)) g(); }"),
        ("condition", "int f() { return a && b; }", "int f() { return b; }"),
        ("sign", "int f() { return !a; }", "int f() { return a; }"),
        ("dropped", "void f() { g(); }", "void f() { ; }"),
        ("dropped", "int f() { return a; }", "int f() { return {}; }"),
        ("order", "void f() { g();  h(); }", "void f() { h();  g(); }"),
        ("arguments", "void f() { g(a, b); }", "void f() { g(b, a); }"),
        ("branches", "int f() { return a ? b : c; }", "int f() { return a ? c : b; }"),
        ("copied", "void f() { int& a = b; }", "void f() { int a = b; }"),
    ],
)
def test_an_edit_of_each_kind(kind: str, source: str, edited: str) -> None:
    """One place is different, and only that one."""
    assert edited in texts(source, kind)


def test_what_is_no_code_is_left_alone() -> None:
    """Comments, strings and names of headers are no place for a mistake."""
    source = b'#include <max>\n// a < b, 4\nauto f = "a < 4";\n/* return 1; */\n'
    assert edits(source) == []


def test_no_two_mutants_are_equal() -> None:
    """Nor is one its original; each tells the lines that differ."""
    source = originals()["reference/src/exercise03.cpp"].read_bytes()
    mutants = list(mutants_of("reference/src/exercise03.cpp", source))
    assert len({mutant.source for mutant in mutants} | {source}) == len(mutants) + 1
    assert len(mutants) > 300
    for mutant in mutants:
        before, after = mutant.change.split(" -> ", 1)
        assert before in " ".join(source.decode().split())
        assert before != after
        assert before.split()[0] in source.decode().splitlines()[mutant.line - 1]


def test_a_sample_is_drawn_from_a_seed() -> None:
    """The same twice, others with another seed, all of them if there are fewer."""
    first = chosen_mutants(20, 1, "queue")
    assert first == chosen_mutants(20, 1, "queue")
    assert first != chosen_mutants(20, 2, "queue")
    assert len(first) == 20
    assert len(chosen_mutants(10**6, 1, "queue")) == len(chosen_mutants(10**6, 2, "queue"))
