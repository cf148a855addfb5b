"""No text, whatever it holds, keeps the reader of calls from an answer."""

from hypothesis import given
from hypothesis import strategies as st

from grader.build.callgraph import Tangled, read_assembly
from grader.model.stages import Call, CallGraph

BEGIN, END = "\t.type\t_Z1fv, @function\n_Z1fv:\n", "\n\t.size\t_Z1fv, .-_Z1fv\n"
VERBS = [
    *("movq", "movl", "addq", "leaq", "call", "callq", "jmp", "bl", "blr", "adrp", "ldr"),
    *(".type", ".size", ".set", ".loc", ".file", ".quad", ".section", ".long", "_Z1gv:"),
]
OPERANDS = [
    *("%rax", "%rbp", "%rdi", "%rdx", "x0", "$8", "$", "-", "1", "99999999999", "@function"),
    *("_Z1fv", "_Z1gv", "_ZTV1A", "qsort", "f@GOTPCREL(%rip)", ":got:f", "_Z1fv(%rip)"),
    *('"src/exercise03.cpp"', "_ZNSt9exceptionD2Ev", "__cxa_begin_catch", "@object", "+16"),
]
distances = st.sampled_from(["", "-", "-8", "8", "-0", "999999999", "+8", "0x8", "--8"])
memory = st.builds(
    "{}{}({})".format, st.sampled_from(["", "*"]), distances, st.sampled_from(["%rax", "%rbp"])
)
operands = st.sampled_from(OPERANDS) | memory | memory.map("*{}".format) | st.text(max_size=3)
loads = st.builds("movq\t{}, {}".format, memory, st.sampled_from(["%rax", "-8(%rbp)"]))
calls = st.builds("call\t*{}".format, memory)
others = st.builds(
    "{}\t{}".format, st.sampled_from(VERBS), st.lists(operands, max_size=3).map(", ".join)
)
rows = loads | calls | others


@given(st.lists(rows, max_size=40))
def test_any_text_has_a_graph_or_is_tangled(rows: list[str]) -> None:
    """Inline assembly may write any row, comments included."""
    for text in ("\n".join(rows), BEGIN + "\n".join(f"\t{row}" for row in rows) + END):
        try:
            assert isinstance(read_assembly(text.encode()), CallGraph)
        except Tangled:
            continue


def test_a_lone_minus_is_no_distance() -> None:
    """No assembler takes it, but in a comment it may stand."""
    rows = "\tmovq\t-(%rax), %rdx\n\tcall\t*-(%rax)"
    assert Call("_Z1fv", "*") in read_assembly((BEGIN + rows + END).encode()).calls
