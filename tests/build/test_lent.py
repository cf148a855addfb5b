"""Nodes that a vector lends, in assembly texts that are written by hand."""

import pytest

from tests.build.test_callgraph import calls

LENDER = "_ZNSt6vectorIN3BVH4NodeESaIS1_EEixEm"
CONSTANT = LENDER.replace("_ZN", "_ZNK")
ASK = "movq\t%rax, %rdi\n\tcall\t_ZNK4AABB7extentsEv@PLT"


def lent(rows: str, lender: str = LENDER) -> set[str]:
    """Give the functions that lend nodes to one that goes on with some rows."""
    head = "\t.type\t_Z1fv, @function\n_Z1fv:\n"
    text = f"{head}\tcallq\t{lender}\n\t{rows}\n\t.size\t_Z1fv, 9\n"
    return {name for _, name in calls(text) if "BVH4Node" in name}


@pytest.mark.parametrize(
    "rows",
    [
        "movl\t24(%rax), %eax",
        ".loc 7 8 9\n\tmovl\t24(%rax), %eax                # remark",
        "movss\t(%rax), %xmm0\n\tmovq\t-8(%rbp), %rax",
        "movl\t24(%rax), %edx\n\tcmpl\t28(%rax), %edx\n\tjne\t.L3",
        "movq\t%rax, %rcx\n\tmovq\t(%rcx), %rax\n\tmovq\t8(%rcx), %rdx\n\tcall\t_Z1gv",
        "leaq\t-8(%rbp), %rax",
        ASK,
    ],
)
def test_a_node_that_is_only_read_comes_from_a_constant_vector(rows: str) -> None:
    """There are only loads, or a question to its box, until its address is gone."""
    assert lent(rows) == {CONSTANT}
    at = LENDER.replace("ixEm", "2atEm")
    assert lent(rows, f"{at}@PLT") == {at.replace("_ZN", "_ZNK")}


@pytest.mark.parametrize(
    "rows",
    [
        "",
        "ret",
        "jne\t.L3",
        "movl\t%edx, 24(%rax)",
        "movl\t$3, 24(%rax)",
        "movl\t24(%rax), %edx\n\taddl\t$1, %edx\n\tmovl\t%edx, 24(%rax)",
        "movq\t%rax, -8(%rbp)",
        "movq\t%rax, %r8\n\tmovq\t-8(%rbp), %rax",
        "leaq\t12(%rax), %rdx\n\tmovq\t-8(%rbp), %rax",
        "addq\t$12, %rax\n\tmovq\t%rax, %rdi\n\tcall\t_ZNK4AABB7extentsEv",
        "movq\t%rax, %rdi\n\tcall\t_ZN4AABB5resetEv",
        "movq\t%rax, %rbx\n\t" + ASK + "\n\tmovl\t%eax, 24(%rbx)",
        "movq\t%rax, %rdx\n\tmovl\t24(%rax), %eax\n\tmovl\t%ecx, 24(%rdx)",
        "movl\t(%rax,%rcx), %eax\n\tmovq\t-8(%rbp), %rax",
        "xchgl\t24(%rax), %ecx",
        "pushq\t%rax",
    ],
)
def test_a_node_that_may_be_changed_does_not(rows: str) -> None:
    """Whatever else happens to its address may lead to a store."""
    assert lent(rows) == {LENDER}


def test_each_node_that_is_lent_counts() -> None:
    """Who reads one and writes to the next one is lent both."""
    read, write = "movl\t24(%rax), %eax", "movl\t%edx, 24(%rax)"
    again = f"\n\tcall\t{LENDER}\n\t"
    assert lent(read + again + write) == lent(write + again + read) == {LENDER, CONSTANT}
    assert lent("nop" + again + read) == {LENDER, CONSTANT}


def test_a_row_of_blanks_behind_a_call_takes_no_time() -> None:
    """Twice as many take twice as long, not four times: a million would take an hour."""
    blanks = " " * 3_000_000
    assert lent(f"movq{blanks}%rax{blanks}") == {LENDER}
