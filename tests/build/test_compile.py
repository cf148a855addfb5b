"""Sources that compile, and sources that do not, with every compiler that is installed here."""

import json
import subprocess
from pathlib import Path

import pytest

from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.model.stages import Further, Stop
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.session import run_job
from grader.run.transfer import give_mesh
from tests.build.compilers import COMPILERS, Compile, errors
from tests.compiled import (
    BEGIN,
    CONSTRUCT,
    INTERSECT,
    PATIENT,
    STARTER,
    engine_of,
    partial_build,
)
from tests.verify.builder import soup


def test_the_given_file_compiles(compiled: Compile) -> None:
    """Both libraries and the call graph are there, and what they were made with is told."""
    build = compiled(STARTER.read_text())
    assert build.library
    assert build.sanitized
    assert build.calls
    assert build.diagnostics == ()
    assert build.compiler.startswith("g++ ")
    assert {"-O3", "-std=c++20", "-ffp-contract=off"} <= set(build.flags)
    assert not [flag for flag in build.flags if "/" in flag]


def test_one_function_is_enough_to_link(compiled: Compile) -> None:
    """A stand-in takes the place of the one that is not written yet."""
    assert compiled(BEGIN + INTERSECT).library


def test_warnings_cost_nothing_and_are_shown(compiled: Compile) -> None:
    """A file with warnings is built, and the warnings have the student's lines."""
    build = compiled(BEGIN + CONSTRUCT + INTERSECT + "void f() { int unused; }\n")
    assert build.library
    assert [(each.line, each.severity) for each in build.diagnostics] == [(6, "warning")]


@pytest.mark.parametrize("compiler", COMPILERS)
def test_an_error_has_the_students_line(compiled: Compile, compiler: str) -> None:
    """Line and column count in the file as it was handed in."""
    first, *_ = errors(compiled(BEGIN + INTERSECT + "\n\n  int x = y;\n", compiler))
    assert (first.line, first.column) == (7, 11)
    assert "y" in first.text


def test_an_error_inside_the_library_has_the_students_line(compiled: Compile) -> None:
    """What a wrong comparator causes deep in a header is placed where it was passed."""
    sort = "void f() { std::vector<int> v; std::sort(v.begin(), v.end(), 7); }\n"
    assert 4 in {each.line for each in errors(compiled(BEGIN + sort))}


def test_a_directive_can_only_rename_lines(compiled: Compile) -> None:
    """After `#line` the compiler speaks of another file; no folder of it is shown."""
    (error, *_) = errors(compiled(BEGIN + '#line 5 "/folder/x/secret.cpp"\nint x = y;\n'))
    assert (error.line, error.text.split(":")[:2]) == (0, ["secret.cpp", "5"])


@pytest.mark.parametrize("compiler", COMPILERS)
def test_a_given_function_cannot_be_replaced(compiled: Compile, compiler: str) -> None:
    """A second definition is an error of the linker that names the function and no folder."""
    again = "Vector3D AABB::extents() const { return {}; }\n"
    (error, *_) = errors(compiled(BEGIN + CONSTRUCT + INTERSECT + again, compiler))
    assert error.text.startswith("link: multiple definition of ")
    assert "AABB::extents() const" in error.text
    assert "/" not in error.text


def test_an_object_within_an_assembler_statement_is_not_compiled(
    compiled: Compile, tmp_path: Path
) -> None:
    """Link-time optimisation would start compilers, as many as the object asks for."""
    file = tmp_path / "hidden.cpp"
    file.write_text('extern "C" int hidden(int x) { return 3 * x; }\n')
    made = ["g++", "-O2", "-fPIC", "-flto", "-fno-fat-lto-objects", "-S", "-o", "-", str(file)]
    listing = subprocess.run(made, check=True, capture_output=True, text=True).stdout
    assert ".gnu.lto_.opts" in listing
    text = "".join(f"{json.dumps(line + chr(10))}\n" for line in listing.splitlines())
    uses = 'extern "C" int hidden(int);\nint used = hidden(2);\n'
    build = compiled(f"{BEGIN}{CONSTRUCT}{INTERSECT}asm({text});\n{uses}")
    (error,) = errors(build)
    assert "hidden" in error.text


def test_what_lies_beside_the_given_file_can_be_included(compiled: Compile) -> None:
    """The folder of the one file that a student edits holds some of the given code, too."""
    build = compiled(
        '#include "counters.h"\n#include "path.h"\n' + BEGIN + CONSTRUCT + INTERSECT
    )
    assert build.library, build.diagnostics


def test_a_function_that_is_nowhere_is_named(compiled: Compile) -> None:
    """A declaration without a definition does not link."""
    source = "void helper(int);\nvoid BVH::construct(const Mesh&) { helper(1); }\n"
    (error, *_) = errors(compiled(BEGIN + source + INTERSECT))
    assert error.text.startswith("link: undefined reference to ")
    assert "helper(int)" in error.text


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("#include __FILE__\n", "No such file"),
        ("#error <b>\x1b[31m</b>\n", "#error <b>"),
    ],
)
def test_strange_files_are_values(compiled: Compile, source: str, said: str) -> None:
    """Endless and hostile files have an error, in the compiler's words."""
    assert any(said in each.text for each in errors(compiled(source)))


@pytest.mark.parametrize("source", ["", "\0"])
def test_a_file_without_any_function_compiles(compiled: Compile, source: str) -> None:
    """What is missing is missed where it is called, by the run."""
    assert compiled(source).library


FLOOD = """
template <int N> struct Deep { static int f() { return undeclared_##N + Deep<N - 1>::f(); } };
#define A(x) int a##x = nothing_##x; int b##x = nothing_##x; int c##x = nothing_##x;
#define B(x) A(x##0) A(x##1) A(x##2) A(x##3) A(x##4) A(x##5) A(x##6) A(x##7) A(x##8) A(x##9)
#define C(x) B(x##0) B(x##1) B(x##2) B(x##3) B(x##4) B(x##5) B(x##6) B(x##7) B(x##8) B(x##9)
C(1) C(2) C(3) C(4) C(5) C(6) C(7) C(8) C(9)
"""


def test_a_flood_of_errors_is_cut(compiled: Compile) -> None:
    """Of thousands of errors the first forty are shown."""
    found = errors(compiled(BEGIN + FLOOD))
    assert 1 <= len(found) <= 40


@pytest.mark.parametrize("compiler", COMPILERS)
def test_a_hook_may_be_null_when_it_is_compiled(compiled: Compile, compiler: str) -> None:
    """With the sanitizer's checks of null, g++ takes this comparison for no constant."""
    hook = """struct Splits { static void count() {} };
template <void (*Hook)()> void visit() { if constexpr (Hook != nullptr) Hook(); }
void BVH::construct(const Mesh&) { visit<Splits::count>(); visit<nullptr>(); nodes.clear(); }
"""
    build = compiled(BEGIN + hook + INTERSECT, compiler)
    assert build.sanitized, build.diagnostics


@pytest.mark.parametrize("compiler", COMPILERS)
def test_libraries_of_every_compiler_run(compiled: Compile, compiler: str) -> None:
    """The graded and the sanitized library load, construct, and show a mistake."""
    wrong = """void BVH::construct(const Mesh& mesh) {
    nodes.resize(1);
    if (mesh.getFaces().size() == 9) nodes.data()[1].facesEnd = 1;
}
"""
    build = compiled(BEGIN + wrong + INTERSECT, compiler)
    assert build.library
    assert build.sanitized
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CXX", compiler)
        runtime = sanitizer_runtime(find_compiler())
    engines = (engine_of(build.library), engine_of(build.sanitized, runtime))
    for faces in (5, 9):
        for engine in engines:
            job = Job()
            slot = give_mesh(job, soup(faces))
            job.do(Op.CONSTRUCT, slot, slot)
            ending, _ = run_job(job, engine, PATIENT)
            if engine.preload:
                assert ending.finding == ("heap-buffer-overflow" if faces == 9 else ""), ending
                assert ending.line == (6 if faces == 9 else 0)
            elif faces == 5:
                assert ending.stop is Stop.FINISHED, ending


def test_a_file_that_insists_on_the_real_depth_is_sanitized(compiled: Compile) -> None:
    """A static assertion on the depth limit is no reason to lose the memory checks."""
    build = compiled(BEGIN + INSISTS + CONSTRUCT + INTERSECT)
    assert build.library
    assert build.sanitized


@pytest.mark.parametrize("asked", [(), *((each,) for each in Further)])
@pytest.mark.usefixtures("cache")
def test_only_what_is_asked_for_is_made(asked: tuple[Further, ...], tmp_path: Path) -> None:
    """The graded library always, and nothing is said against what nobody asked for."""
    build = partial_build(STARTER.read_text(), tmp_path, *asked)
    made = {"sanitized": build.sanitized, "deep": build.deep, "calls": build.calls}
    assert build.library
    assert [name for name, product in made.items() if product] == [one.value for one in asked]
    assert build.remarks == ()


INSISTS = "static_assert(BVH::maxDepth == 20);\n"
REFUSES = '#ifdef __SANITIZE_ADDRESS__\n#error "not with me"\n#endif\n'


@pytest.mark.usefixtures("cache")
def test_the_small_build_alone_has_the_same_way_out(tmp_path: Path) -> None:
    """Whoever insists on the real depth limit gets it, and whoever refuses both is told so."""
    insists = BEGIN + INSISTS + CONSTRUCT + INTERSECT
    assert partial_build(insists, tmp_path / "insists", Further.SANITIZED).sanitized
    refuses = BEGIN + REFUSES + CONSTRUCT + INTERSECT
    refused = partial_build(refuses, tmp_path / "refuses", Further.SANITIZED)
    assert refused.library
    assert refused.sanitized is None
    assert "not with me" in refused.remarks[0]


def test_a_file_that_refuses_sanitizers_is_told_so(compiled: Compile) -> None:
    """It is graded, its memory is not called safe, and a remark says why."""
    build = compiled(BEGIN + REFUSES + CONSTRUCT + INTERSECT)
    assert build.library
    assert build.sanitized is None
    assert build.deep is None
    (remark,) = build.remarks
    assert "line 5: " in remark
    assert "not with me" in remark
