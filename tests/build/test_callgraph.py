"""Call graphs of assembly texts that are written by hand."""

import pytest

from grader.build import callgraph
from grader.build.callgraph import Tangled, read_assembly

GNU = """
\t.file\t"exercise03.cpp"
\t.type\t_ZL4growi, @function
_ZL4growi:
.LFB1:
\t.file 1 "src/exercise03.cpp"
\t.loc 1 7 1
\tpushq\t%rbp
\t.loc 1 8 1
\tcall\t_ZL4growi
\tcall\t_ZN4AABB6extendERK7Point3D@PLT
\t.size\t_ZL4growi, .-_ZL4growi
\t.type\t_ZL5tableB0, @object
_ZL5tableB0:
\t.quad\t_ZL4growi
\t.quad\t_ZL5other
\t.size\t_ZL5tableB0, 16
\t.type\tmain, @function
main:
\t.file 2 "/usr/include/c++/12/bits/stl_algo.h"
\t.loc 2 99 1
\tleaq\t_ZL4growi(%rip), %rax
\tcall\t*%rax
\tcall\tmemcpy@PLT
\tjmp\t_ZL4growi
\t.size\tmain, .-main
"""

CLANG = """
\t.type\t_ZL4growi,@function
_ZL4growi:                        # @_ZL4growi
\t.file\t1 "/tmp/x" "src/exercise03.cpp"
\t.loc\t1 7 0                     # src/exercise03.cpp:7:0
\tcallq\t_ZL4growi
\tcallq\t_ZN4AABB6extendERK7Point3D@PLT
\t.size\t_ZL4growi, .Lfunc_end0-_ZL4growi
\t.type\tmain,@function
main:                             # @main
\tmovq\t_ZL4growi@GOTPCREL(%rip), %rax
\tcallq\t*%rax
\tcallq\t_ZL4growi
\t.size\tmain, .Lfunc_end1-main
"""


def calls(text: str) -> set[tuple[str, str]]:
    """Read the calls of a text."""
    return {(call.caller, call.callee) for call in read_assembly(text.encode()).calls}


@pytest.mark.parametrize("text", [GNU, CLANG], ids=["g++", "clang++"])
def test_direct_calls_and_pointers_are_listed(text: str) -> None:
    """A call, a tail call, and a function whose address is taken, which anything may call."""
    assert {
        ("_ZL4growi", "_ZL4growi"),
        ("_ZL4growi", "_ZN4AABB6extendERK7Point3D"),
        ("main", "_ZL4growi"),
        ("main", "*"),
        ("*", "_ZL4growi"),
    } == calls(text)


def test_functions_of_c_that_call_what_they_are_given_are_listed() -> None:
    """No other functions of C are."""
    text = GNU.replace("memcpy", "qsort")
    assert calls(text) - calls(GNU) == {("main", "qsort")}


def test_a_call_of_our_own_door_is_listed() -> None:
    """It leads back into the file, unlike other functions of C."""
    text = GNU.replace("memcpy", "ex03_construct")
    assert calls(text) - calls(GNU) == {("main", "ex03_construct")}


@pytest.mark.parametrize("text", [GNU, CLANG], ids=["g++", "clang++"])
def test_functions_have_their_first_own_line(text: str) -> None:
    """Lines of other files are not the student's."""
    assert read_assembly(text.encode()).lines == (("_ZL4growi", 7),)


def test_line_zero_names_no_place() -> None:
    """Lines count from 1; inline assembly writes what it likes before the function's own."""
    text = GNU.replace("\t.loc 1 7 1", "\t.loc 1 0 0\n\t.loc 1 7 1")
    assert read_assembly(text.encode()).lines == (("_ZL4growi", 7),)


@pytest.mark.parametrize("directive", [".set", ".equ"])
def test_a_constructor_of_two_names_is_one_function(directive: str) -> None:
    """Callers name the one, the body has the other; other equal numbers are no functions."""
    text = (
        "\t.type\t_ZN1SC2Ei, @function\n_ZN1SC2Ei:\n\tcall\t_ZN1SC1Ei\n\t.size\t_ZN1SC2Ei, 9\n"
        f"\t{directive}\t_ZN1SC1Ei,_ZN1SC2Ei\n\t{directive}\t_ZN1SC1Ev, 7\n"
    )
    assert calls(text) == {("_ZN1SC2Ei", "_ZN1SC1Ei"), ("_ZN1SC1Ei", "_ZN1SC2Ei")}


def test_who_takes_an_address_is_listed() -> None:
    """By a table of its name, by one without a name, by code; a call takes nothing."""
    functions = "".join(f"\t.type\t_Z{k}v, @function\n" for k in range(4))
    text = (
        f"{functions}_Z0v:\n\tleaq\t16+_ZTV1S(%rip), %rdx\n\tleaq\t_Z1v(%rip), %rax\n"
        "\tcall\t_Z2v\n\t.size\t_Z0v, 9\n\t.type\t_ZTV1S, @object\n\t.size\t_ZTV1S, 16\n"
        "_ZTV1S:\n\t.quad\t0\n\t.quad\t_Z2v\n.LC3:\n\t.quad\t_Z3v\n"
    )
    taken = {(each.caller, each.callee) for each in read_assembly(text.encode()).taken}
    assert taken == {("_Z0v", "_ZTV1S"), ("_Z0v", "_Z1v"), ("_ZTV1S", "_Z2v"), ("*", "_Z3v")}
    assert ("_Z0v", "_Z1v") not in calls(text)


@pytest.mark.parametrize(
    ("row", "name"),
    [
        ("movq\tmalloc@GOTPCREL(%rip), %rax", "malloc"),
        ("movq\t_Znwm@GOTPCREL(%rip), %rax", "_Znwm"),
        ("adrp\tx0, :got:free", "free"),
    ],
)
def test_a_pointer_may_be_for_a_function_of_c(row: str, name: str) -> None:
    """Who hands `malloc` around has a pointer more that is not for the file's own function."""
    text = f"\t.type\t_Z1fv, @function\n_Z1fv:\n\t{row}\n\t.size\t_Z1fv, 9\n"
    assert ("*", name) in calls(text)


@pytest.mark.parametrize("name", ["stderr", "_ZSt4cout", "_ZTIi", "__pthread_key_create"])
def test_a_pointer_is_never_for_a_variable_of_the_library(name: str) -> None:
    """Nor for what the library looks up for itself."""
    text = (
        f"\t.type\t_Z1fv, @function\n_Z1fv:\n\tmovq\t{name}@GOTPCREL(%rip), %rax\n"
        "\t.size\t_Z1fv, 9\n"
    )
    assert not {each for pointer, each in calls(text) if pointer == "*"}


@pytest.mark.parametrize("quote", ["", '"'])
def test_names_beyond_ascii_stay_apart(quote: str) -> None:
    """Two functions whose names differ only in an umlaut are two functions."""
    a, o = (f"{quote}_ZL2{letter}i{quote}" for letter in "äö")
    types = f"\t.type\t{a}, @function\n\t.type\t{o}, @function\n"
    text = f"{types}{a}:\n\tcall\t{o}\n\t.size\t{a}, 1\n{o}:\n\tret\n\t.size\t{o}, 1\n"
    assert calls(text) == {("_ZL2äi", "_ZL2öi")}


@pytest.mark.parametrize(
    "raw", [b"", b"\xff" * 99, b"\t.type\t\xff\xfe, @function\n\xff\xfe:\n\tcall\t\xff\xfe\n"]
)
def test_bytes_that_are_no_text_break_nothing(raw: bytes) -> None:
    """Names are compared, not understood."""
    graph = read_assembly(raw)
    assert all(call.caller.isprintable() for call in graph.calls)


def test_a_huge_text_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Beyond a number of calls no more are listed."""
    monkeypatch.setattr(callgraph, "MAX_CALLS", 10)
    body = "".join(f"\tcall\t_Z{k}v\n" for k in range(1000))
    assert len(calls(f"\t.type\tmain, @function\nmain:\n{body}\t.size\tmain, 9\n")) == 10


@pytest.mark.parametrize(("limit", "most"), [("MAX_ROWS", 2), ("MAX_BYTES", 9)])
def test_a_text_that_is_too_long_is_not_read(
    monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    """The reader is the grader itself, which no limit ends."""
    monkeypatch.setattr(callgraph, limit, most)
    assert calls("1234\n6789") == set()
    with pytest.raises(callgraph.Tangled):
        calls("1234\n\n6789")


def test_functions_that_overlap_are_not_read() -> None:
    """Each row would be read once for every one of them."""
    many = range(callgraph.MOST_OWNERS + 1)
    heads = "".join(f"\t.type\tf{k}, @function\nf{k}:\n" for k in many)
    ends = "".join(f"\t.size\tf{k}, 1\n" for k in many)
    with pytest.raises(callgraph.Tangled):
        calls(heads + ends)


@pytest.mark.parametrize(("limit", "most"), [("MAX_ROWS", 50), ("MAX_BYTES", 500)])
def test_a_row_counts_once_for_each_function_around_it(
    monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    """It is read so often: 900,000 rows in sixteen functions took minutes."""
    monkeypatch.setattr(callgraph, limit, most)
    rows = "\tret xxx\n" * 35
    one, two = (f"\t.type\tf{k}, @function\nf{k}:\n" for k in range(2))
    ends = "\t.size\tf0, 1\n\t.size\tf1, 1\n"
    assert calls(one + rows + ends) == set()
    with pytest.raises(callgraph.Tangled):
        calls(one + two + rows + ends)


def test_a_name_is_kept_once_for_all_its_calls() -> None:
    """200,000 pairs of long names would be gigabytes."""
    row = "\t.type\t{0}, @function\n{0}:\n\tcall\t_Z1gv\n\t.size\t{0}, 9\n"
    first, second = read_assembly((row.format("_Z1av") + row.format("_Z1bv")).encode()).calls
    assert first.callee is second.callee


def test_endless_names_are_not_read(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever looks into them would take as long as they are."""
    monkeypatch.setattr(callgraph, "MOST_NAMED", 10)
    row = "\t.type\t_Z1fv, @function\n_Z1fv:\n\tcall\t{}\n\t.size\t_Z1fv, 9\n"
    assert calls(row.format("_Z1g"))
    with pytest.raises(callgraph.Tangled):
        calls(row.format("_Z9gggggggggv"))


def test_a_row_of_blanks_takes_no_time() -> None:
    """Twice as many take twice as long, not four times: a million would take an hour."""
    blanks = " " * 3_000_000
    assert calls(f"\tmovq{blanks}\n\tmovq {blanks}%rax{blanks}\n") == set()


FORGED = """
\t.type\t_ZL4growi, @function
_ZL4growi:
\tcall\t_Z5firstv
\t.size\t_ZL4growi, 1
\t.type\telsewhere, @function
elsewhere:
\tcall\t_ZL4growi
\t.size\telsewhere, 1
\tcall\t_Z4lastv
\t.size\t_ZL4growi, .-_ZL4growi
"""


def test_labels_of_inline_assembly_hide_no_call() -> None:
    """Whatever is written between the beginning and the end of a function belongs to it."""
    wanted = {("_ZL4growi", name) for name in ("_Z5firstv", "_ZL4growi", "_Z4lastv")}
    assert calls(FORGED) == wanted | {("elsewhere", "_ZL4growi")}
    unclosed = FORGED.replace("\t.size\telsewhere, 1\n", "")
    assert calls(unclosed) == wanted


def test_an_instruction_without_end_is_not_read() -> None:
    """Each name in its comment would be kept; a table's text may be as long as it likes."""
    head = b".type f, @function\nf:\n%s\n.size f, .-f\n"
    names = b" ".join(b"_Z%da" % k for k in range(100))
    assert not read_assembly(head % (b'.string "' + names + b'"')).taken
    with pytest.raises(Tangled):
        read_assembly(head % (b"nop # " + names))


def within(*rows: str) -> str:
    """Write a function with some rows of inline assembly in it."""
    body = "".join(f"\t{row}\n" for row in rows)
    return f"\t.type\tgrow, @function\ngrow:\n{body}\t.size\tgrow, .-grow\n"


@pytest.mark.parametrize(
    "rows",
    [
        (".byte 0xe8", ".long grow - . - 4"),
        (".reloc ., R_X86_64_PLT32, grow-4",),
        ("nop; call grow",),
        ("call other", ".set other, grow"),
    ],
)
def test_a_call_that_no_compiler_spells_so_is_one(rows: tuple[str, ...]) -> None:
    """In bytes, behind another instruction, or by a second name."""
    made = calls(within(*rows))
    assert ("grow", "grow") in made or {("grow", "other"), ("other", "grow")} <= made


@pytest.mark.parametrize(
    "row",
    [
        "\t.macro again\n\tcall grow\n\t.endm",
        "nop; .rept 2",
        '\t.type\t"gr ow", @function',
        f"\t.type\tg{'w' * (1 << 16)}, @function",
    ],
)
def test_what_no_compiler_writes_is_not_read(row: str) -> None:
    """Text that makes text, and functions whose names cannot be read."""
    with pytest.raises(Tangled):
        read_assembly((row + "\n" + within("call other")).encode())


def test_words_of_a_string_are_no_directive() -> None:
    """A program may print what it likes."""
    text = within("call grow") + '\t.string\t"a; .macro b"\n'
    assert calls(text) == {("grow", "grow")}
