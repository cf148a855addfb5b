"""What compilers and linkers say, as messages with the student's line numbers."""

import pytest

from grader.build.diagnostics import MAX_DIAGNOSTICS, MAX_TEXT, read_diagnostics
from grader.model.stages import Diagnostic

OWN = "src/exercise03.cpp"


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (f"{OWN}:12:5: error: no", Diagnostic(12, 5, "error", "no")),
        (f"{OWN}:12:5: fatal error: no", Diagnostic(12, 5, "error", "no")),
        (f"{OWN}:12:5: warning: hm", Diagnostic(12, 5, "warning", "hm")),
        (f"{OWN}:12:5: note: see", Diagnostic(12, 5, "note", "see")),
        (f"{OWN}:12: error: no column", Diagnostic(12, 0, "error", "no column")),
        ("/a/b/include/aabb.h:7:3: error: no", Diagnostic(0, 0, "error", "aabb.h:7: no")),
        ("cc1plus: fatal error: x: no", Diagnostic(0, 0, "error", "x: no")),
        ("clang++-14: error: no", Diagnostic(0, 0, "error", "no")),
        ("/x/ccA1.s:4: Error: no such", Diagnostic(0, 0, "error", "assembler: no such")),
        ("<command-line>:1:1: error: x", Diagnostic(0, 0, "error", "<command-line>:1: x")),
        (
            "other/exercise03.cpp:3:1: error: x",
            Diagnostic(0, 0, "error", "exercise03.cpp:3: x"),
        ),
    ],
)
def test_a_message_is_split_at_its_place(line: str, expected: Diagnostic) -> None:
    """Only the student's file has line numbers; other files are named without their folder."""
    assert read_diagnostics(line.encode()) == (expected,)


@pytest.mark.parametrize(
    "line",
    [
        "",
        "In file included from src/exercise03.cpp:1:",
        f"{OWN}: In member function 'void BVH::construct(const Mesh&)':",
        "   12 |     x = 1;",
        "   12 | #warning fine // undefined reference to `x'",
        "      | multiple definition of `x'",
        "      |     ^",
        "compilation terminated.",
        "collect2: error: ld returned 1 exit status",
        f"{OWN}:x:5: error: no",
        f"{OWN}:123456789012:5: error: no",
    ],
)
def test_other_lines_are_left_out(line: str) -> None:
    """Source lines, carets and summaries are no messages."""
    assert read_diagnostics(line.encode()) == ()


def test_an_error_in_the_library_is_placed_where_the_student_caused_it() -> None:
    """The compiler names the own line just before; the next message has its own place."""
    text = f"""
/usr/include/c++/12/bits/stl_algo.h: In instantiation of 'void std::sort()':
{OWN}:21:14:   required from here
/usr/include/c++/12/bits/stl_algo.h:1849:4: error: no match
/usr/include/c++/12/bits/stl_algo.h:1850:4: note: candidate
"""
    first, second = read_diagnostics(text.encode())
    assert first == Diagnostic(21, 14, "error", "stl_algo.h:1849: no match")
    assert (second.line, second.text) == (0, "stl_algo.h:1850: candidate")


@pytest.mark.parametrize(
    ("line", "text"),
    [
        (
            "/usr/bin/ld: /tmp/x/aabb.o: in function `AABB::extents() const': aabb.cpp:(.text+"
            "0x0): multiple definition of `AABB::extents() const'; /tmp/x/graded.o:"
            "exercise03.cpp:(.text+0x10): first defined here",
            "link: multiple definition of `AABB::extents() const'",
        ),
        (
            "exercise03.cpp:(.text+0x9): undefined reference to `helper(int)'",
            "link: undefined reference to `helper(int)'",
        ),
    ],
)
def test_the_linker_is_quoted_without_our_folders(line: str, text: str) -> None:
    """The name of the function is what counts; paths of this machine stay here."""
    assert read_diagnostics(line.encode()) == (Diagnostic(0, 0, "error", text),)


@pytest.mark.parametrize("severity", ["warning", "note"])
def test_errors_are_not_crowded_out(severity: str) -> None:
    """Behind a hundred other messages the error is still there, in the order of the file."""
    others = [f"{OWN}:{k}:1: {severity}: {k}" for k in range(1, 101)]
    lines = [*others, f"{OWN}:101:1: error: this", f"{OWN}:102:1: {severity}: last"]
    found = read_diagnostics("\n".join(lines).encode())
    assert len(found) == MAX_DIAGNOSTICS
    assert [each.line for each in found] == [*range(1, MAX_DIAGNOSTICS), 101]


def test_no_more_than_forty_errors_are_kept() -> None:
    """The first errors say most."""
    lines = "\n".join(f"{OWN}:{k}:1: error: {k}" for k in range(1, 101))
    assert [each.line for each in read_diagnostics(lines.encode())] == list(range(1, 41))


@pytest.mark.parametrize(
    "text",
    [
        "<script>alert(1)</script>",
        "\x1b[31mred\x1b[0m",
        "::error file=x::y",
        '=HYPERLINK("x")',
        "{{7*7}}",
        "a" * 5 * MAX_TEXT,
        "no error: src/exercise03.cpp:1:1: error: nested",
    ],
)
def test_texts_are_kept_as_text(text: str) -> None:
    """Nothing in a message is interpreted, and a long one is cut."""
    (found,) = read_diagnostics(f"{OWN}:1:1: error: {text}".encode())
    assert found.text == text[: len(found.text)]
    assert len(found.text) <= 2 * MAX_TEXT
    assert len(found.text) == min(len(text), MAX_TEXT)


@pytest.mark.parametrize(
    "raw", [b"\xff\xfe\x00", b"\x00" * 99, b"\r\n\r\n", b":::::", b"a:1:1: "]
)
def test_bytes_that_are_no_text_break_nothing(raw: bytes) -> None:
    """What is no message is left out."""
    assert read_diagnostics(raw) == ()


def test_a_flood_is_read_in_one_pass() -> None:
    """Twelve megabytes of template noise and one error at the end."""
    noise = b"x" * 60 + b"\n"
    flood = noise * 200_000 + f"{OWN}:9:1: error: here".encode()
    assert read_diagnostics(flood) == (Diagnostic(9, 1, "error", "here"),)


def test_a_name_by_line_directive_is_only_a_name() -> None:
    """A student may call the file what he likes, but no folder is shown."""
    (found,) = read_diagnostics(b"/etc/passwd:5:1: error: x")
    assert found == Diagnostic(0, 0, "error", "passwd:5: x")
