"""Closures in assembly texts that are written by hand."""

import pytest

from grader.build.callgraph import read_assembly
from grader.build.captures import Frame

MADE = "_ZNSt8functionIFvmEEC1IZN3BVH9constructERK4MeshEUlmE_vEEOT_"
ASSIGNED = "_ZNSt8functionIFvmEEaSIZ1fvEUlmE_EERS1_OT_"
COPIED = "_ZNSt8functionIFvmEEC1ERKS1_"

GNU = """
\tmovq\t-216(%rbp), %rax
\tmovq\t%rax, -80(%rbp)
\tleaq\t-176(%rbp), %rax
\tmovq\t%rax, -72(%rbp)
\tleaq\t-80(%rbp), %rdx
\tleaq\t-176(%rbp), %rax
\tmovq\t%rdx, %rsi
\tmovq\t%rax, %rdi
\tcall\tFILL
"""

CLANG = """
\tleaq\t-184(%rbp), %rdi
\tmovq\t%rdi, -240(%rbp)                # 8-byte Spill
\tmovq\t-240(%rbp), %rdi                # 8-byte Reload
\tmovq\t%rax, -216(%rbp)
\tmovq\t%rdi, -208(%rbp)
\tleaq\t-216(%rbp), %rsi
\tcallq\tFILL
"""


def filled(text: str, fill: str) -> set[str]:
    """Follow the rows of one function."""
    frame = Frame()
    rows = text.replace("FILL", fill).encode().splitlines()
    return {name.decode() for row in rows if (name := frame.read(row))}


@pytest.mark.parametrize("text", [GNU, CLANG], ids=["g++", "clang++"])
@pytest.mark.parametrize("fill", [MADE, ASSIGNED])
def test_a_lambda_that_holds_its_own_object_is_seen(text: str, fill: str) -> None:
    """One of the pointers in the closure is the address that is filled."""
    assert filled(text, fill) == {fill}


@pytest.mark.parametrize("text", [GNU, CLANG], ids=["g++", "clang++"])
@pytest.mark.parametrize("fill", [COPIED, "_ZNKSt8functionIFvmEEclEm", "_Z4fillPvS_"])
def test_other_calls_fill_nothing(text: str, fill: str) -> None:
    """Copying an object, calling it, and functions of other names."""
    assert filled(text, fill) == set()


def test_another_object_in_the_closure_is_not_the_own_one() -> None:
    """What is beside the closure, or in it but at another address, says nothing."""
    other = GNU.replace(
        "-176(%rbp), %rax\n\tmovq\t%rax, -72", "-144(%rbp), %rax\n\tmovq\t%rax, -72"
    )
    assert filled(other, MADE) == set()
    assert filled(GNU.replace("-72(%rbp)", "-64(%rbp)"), MADE) == set()
    assert filled(GNU.replace("-72(%rbp)", "-88(%rbp)"), MADE) == set()


def test_a_closure_is_read_once() -> None:
    """Its place on the stack may hold another one later."""
    again = GNU + "\tleaq\t-80(%rbp), %rsi\n\tleaq\t-176(%rbp), %rdi\n\tcall\tFILL\n"
    assert filled(GNU, MADE) == {MADE}
    assert filled(again.replace("FILL", "_Z4nonev", 1), MADE) == {MADE}
    assert filled(again.replace("FILL", MADE, 1), ASSIGNED) == {MADE}


def test_each_function_has_a_frame_of_its_own() -> None:
    """What one function laid out is not in the closure of the next one."""
    half = GNU.index("\tleaq\t-80")
    head = "\t.type\t_Z1fv, @function\n\t.type\t_Z1gv, @function\n_Z1fv:\n"
    one, two = GNU.replace("FILL", MADE)[:half], GNU.replace("FILL", MADE)[half:]
    end, next_one = "\t.size\t_Z1fv, 9\n", "_Z1gv:\n"
    assert read_assembly(f"{head}{one}{two}{end}".encode()).selves == (MADE,)
    apart = f"{head}{one}{end}{next_one}{two}\t.size\t_Z1gv, 9\n"
    assert read_assembly(apart.encode()).selves == ()
