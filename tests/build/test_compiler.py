"""Which compiler is chosen, and what is said if there is none."""

from pathlib import Path

import pytest

from grader.build.compiler import Compiler, find_compiler, sanitizer_runtime
from grader.errors import MissingTool


def program(folder: Path, name: str, says: str) -> Path:
    """Put a program into a folder that prints some text."""
    path = folder / name
    path.write_text(f"#!/bin/sh\ncat <<'EOF'\n{says}\nEOF\n")
    path.chmod(0o755)
    return path


@pytest.fixture(autouse=True)
def without_cxx(monkeypatch: pytest.MonkeyPatch) -> None:
    """Forget the caller's compiler."""
    monkeypatch.delenv("CXX", raising=False)


@pytest.mark.parametrize(
    ("name", "says", "title"),
    [
        ("g++", "g++ (Debian 12.2.0-14+deb12u1) 12.2.0\nCopyright", "g++ 12.2.0"),
        ("c++", "c++ (GCC) 14.2.1 20240801 (Red Hat 14.2.1-1)", "g++ 14.2.1"),
        ("x86_64-linux-gnu-g++-13", "x86_64-linux-gnu-g++-13 (Ubuntu) 13.2.0", "g++ 13.2.0"),
        ("clang++", "Debian clang version 14.0.6\nTarget: x", "clang++ 14.0.6"),
        ("clang++-19", "Ubuntu clang version 19.1.7 (3)", "clang++ 19.1.7"),
    ],
)
def test_cxx_names_the_compiler(
    name: str, says: str, title: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Any g++ or clang++ is taken, under the name and version that it gives itself."""
    path = program(tmp_path, name, says)
    monkeypatch.setenv("CXX", str(path))
    compiler = find_compiler()
    assert (compiler.title, compiler.path) == (title, str(path))


@pytest.mark.parametrize("names", [("g++", "clang++"), ("clang++",)])
def test_without_cxx_the_first_that_is_installed_is_taken(
    names: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """g++ is preferred, clang++ is used where it is alone."""
    for name in names:
        program(tmp_path, name, "clang version 14.0.6" if "clang" in name else "g++ 12.2.0")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find_compiler().name == names[0]


@pytest.mark.parametrize(
    ("name", "says", "sentence"),
    [
        ("gcc", "gcc (Debian) 12.2.0", "gcc .from CXX. is no C.. compiler; set CXX to g.. or"),
        ("clang", "clang version 14.0.6", "clang .from CXX. is no C.. compiler"),
        ("my++", "hello", "my.. --version did not name a version; set CXX to g.. or clang"),
    ],
)
def test_another_program_is_refused(
    name: str, says: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A plain gcc would compile every submission and link none."""
    monkeypatch.setenv("CXX", str(program(tmp_path, name, says)))
    with pytest.raises(MissingTool, match=sentence):
        find_compiler()


@pytest.mark.parametrize("cxx", ["nonsense", "/no/such/g++", "g++ -O3"])
def test_a_compiler_that_is_not_there_is_named(
    cxx: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The sentence says where the name came from and what to install."""
    monkeypatch.setenv("CXX", cxx)
    with pytest.raises(MissingTool) as fault:
        find_compiler()
    assert str(fault.value) == (
        f"the compiler {cxx} (from CXX) is not installed; "
        "install the Debian package g++ (12 or newer)"
    )


def test_a_machine_without_a_compiler_is_told_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without CXX the sentence does not speak of it."""
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(MissingTool, match=r"^a C\+\+ compiler is not installed; install"):
        find_compiler()


@pytest.mark.parametrize("name", ["g++", "clang++"])
def test_the_sanitizer_of_an_installed_compiler_is_found(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The runtime and the C++ library are files, with all links followed, in this order."""
    monkeypatch.setenv("CXX", name)
    paths = [Path(word) for word in sanitizer_runtime(find_compiler()).split()]
    assert ["asan" in path.name for path in paths] == [True, False]
    for path in paths:
        assert path.is_file()
        assert path == path.resolve()


@pytest.mark.parametrize(
    ("name", "package"), [("g++", "libgcc-12-dev"), ("clang++", "libclang-rt-12-dev")]
)
@pytest.mark.parametrize("says", ["libasan.so", "/no/such/libasan.so"])
def test_a_missing_sanitizer_is_named_with_its_package(
    name: str, package: str, says: str, tmp_path: Path
) -> None:
    """A compiler that does not find its runtime answers with the bare name."""
    compiler = Compiler(str(program(tmp_path, name, says)), name, "12.2.0")
    with pytest.raises(MissingTool, match=f"{package}, or set CXX to another compiler"):
        sanitizer_runtime(compiler)


def test_a_linker_script_leads_to_the_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Fedora puts a text with the true path where the library should be."""
    library = tmp_path / "libasan.so.8.0.0"
    library.write_bytes(b"\x7fELF INPUT ( /nowhere )")
    script = tmp_path / "libasan.so"
    script.write_text(f"/* GNU ld script */\nINPUT ( {library} )\n")
    for answer in (script, library):
        path = program(tmp_path, "g++", f"{answer}")
        found = sanitizer_runtime(Compiler(str(path), "g++", "14.2.1"))
        assert found.split() == [str(library)] * 2


def test_what_goes_by_a_compilers_name_is_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Fedora puts a folder of links to ccache first; alone, it is no compiler."""
    first, second = tmp_path / "ccache-links", tmp_path / "bin"
    for folder in (first, second):
        folder.mkdir()
    (first / "g++").symlink_to(program(tmp_path, "ccache", "g++ 12.2.0"))
    monkeypatch.setenv("PATH", str(first))
    with pytest.raises(MissingTool):
        find_compiler()
    own = program(second, "g++", "g++ 12.2.0")
    monkeypatch.setenv("PATH", f"{first}:{second}:/usr/bin:/bin")
    assert find_compiler().path == str(own)
