"""Calls through pointers in assembly texts that are written by hand."""

import pytest

from grader.build.pointers import Pointers
from tests.build.test_callgraph import calls

GNU = """
\tmovq\t-8(%rbp), %rax
\tmovq\t(%rax), %rax
\taddq\t$16, %rax
\tmovq\t(%rax), %rdx
\tmovq\t-8(%rbp), %rax
\tmovq\t%rax, %rdi
\tcall\t*%rdx
"""

CLANG = """
\tmovq\t-8(%rbp), %rdi                  # 8-byte Reload
\tmovq\t(%rdi), %rax
\tcallq\t*16(%rax)                       # virtual
"""

CATCH = """
\tcall\t__cxa_begin_catch@PLT
\tmovq\t%rax, -8(%rbp)
\tmovq\t$3, %rax
.L9:
"""

TEXTS = pytest.mark.parametrize("text", [GNU, CLANG], ids=["g++", "clang++"])


def called(text: str) -> str:
    """Follow rows up to the last one, which calls."""
    pointers = Pointers()
    *rows, last = text.encode().strip().splitlines()
    for row in rows:
        pointers.read(row.strip())
    return pointers.called(last.strip()).decode()


@TEXTS
def test_a_virtual_function_is_called_by_its_place(text: str) -> None:
    """The object holds a table, and what stands in there at some distance is called."""
    assert called(text) == "*16"
    assert called(text.replace("16", "8")) == "*8"


@TEXTS
@pytest.mark.parametrize("distance", ["12", "-8", "512", "123456789"])
def test_what_stands_in_no_table_may_be_anything(text: str, distance: str) -> None:
    """Entries have eight bytes, and nobody writes a hundred virtual functions."""
    assert called(text.replace("16", distance)) == "*"


@pytest.mark.parametrize(
    "text",
    [
        "call\t*%rdx",
        "call\t*-8(%rbp)",
        "call\t*_ZL4hook(%rip)",
        "blr\tx1",
        "movq\t-8(%rbp), %rax\nmovq\t16(%rax), %rax\ncall\t*%rax",
        GNU.replace("\taddq", ".L3:\n\taddq"),
        GNU.replace("\taddq", "\tcall\t_Z1fv\n\taddq"),
        GNU.replace("addq\t$16", "addq\t%rcx"),
        GNU.replace("addq\t$16", "subq\t$16"),
        GNU.replace("\tmovq\t(%rax), %rdx", "\tmovq\t(%rax,%rcx), %rdx"),
        GNU.replace("\tmovq\t(%rax), %rdx", "\tmovq\t%rax, %rcx\n\tmovq\t(%rcx), %rdx"),
        GNU.replace("call\t*%rdx", "addq\t$8, %rdx\n\tcall\t*%rdx"),
    ],
)
def test_all_other_pointers_may_be_for_anything(text: str) -> None:
    """Those to functions, to members, and whatever is not understood."""
    assert called(text) == "*"


@TEXTS
def test_what_an_error_says_is_no_call_of_a_submission(text: str) -> None:
    """The third virtual function of what a handler caught is the library's `what`."""
    assert called(CATCH + text) == ""
    assert called(CATCH + text.replace("16", "24")) == "*24"
    assert called(CATCH + text.replace("-8", "-16")) == "*16"
    assert called(CATCH + "\tmovq\t%rdi, -8(%rbp)\n" + text) == "*16"
    assert called(CATCH.replace("__cxa_begin_catch", "_Z1fv") + text) == "*16"


TABLES = """
\t.type\t_ZTV1D, @object
\t.size\t_ZTV1D, 72
_ZTV1D:
\t.quad\t0
\t.quad\t_ZTI1D
\t.quad\t0
\t.quad\t__cxa_pure_virtual
\t.quad\t_ZN1D1fEv
\t.quad\t-8
\t.quad\t_ZTI1D
\t.quad\t_ZThn8_N1D1gEv
\t.type\t_ZL5table, @object
_ZL5table:
\t.quad\t_ZN1D1fEv
"""


def test_a_virtual_function_stands_at_its_place() -> None:
    """It counts from the type; a second base begins anew, and other tables have no places."""
    functions = "".join(
        f"\t.type\t{name}, @function\n{name}:\n\t.size\t{name}, 1\n"
        for name in ("_ZN1D1fEv", "_ZThn8_N1D1gEv")
    )
    assert calls(functions + TABLES) == {
        ("*", "_ZN1D1fEv"),
        ("*16", "_ZN1D1fEv"),
        ("*", "_ZThn8_N1D1gEv"),
        ("*0", "_ZThn8_N1D1gEv"),
    }


def test_a_label_with_a_remark_calls_nothing() -> None:
    """`clang++` names each function once more behind its label."""
    text = "\t.type\t_Z1fv,@function\n_Z1fv:          # @_Z1fv\n\tret\n\t.size\t_Z1fv, 1\n"
    assert calls(text) == set()
