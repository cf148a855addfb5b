"""Where the given code is compiled once, so that a submission costs one file.

CMake configures `student_stub` without any submission and builds the framework's objects. The
commands that compile and link a submission are CMake's own (`compile_commands.json` and the
Makefile generator's `link.txt`), so a grade cannot drift from what a student builds by hand.
The standard headers that `common.h` brings along are precompiled, which saves a third of the
time of every compilation. Only those: what a submission writes before it includes the
exercise's own headers still takes effect on them.
A workspace is keyed by the content of the stub, the compiler and the options; it is used only
if its last step, a stamp, was written.
"""

import fcntl
import hashlib
import json
import os
import shlex
import shutil
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from grader import resources
from grader.build.compiler import Compiler
from grader.errors import BuildFault, MissingTool
from grader.model.stages import SOURCE_PATH
from grader.sandbox.launch import Order, launch
from grader.tolerances import SMALL_MAX_DEPTH

LAYOUT = 9
"""Changes when this file builds something else from the same stub."""

FRAMEWORK_SECONDS = 300.0
STANDARD_HEADERS = "standard.h"
GRAPH_HEADERS = "standard-graph.h"
INTRINSICS = "intrinsics"
INTRINSIC_HEADERS = ("xmm", "emm", "tmm", "smm", "wmm", "amm", "imm", "x86")
"""Names, as in `immintrin.h`, of the headers that a file may include."""

UNOPTIMISED = """\
#pragma GCC system_header
#pragma push_macro("__OPTIMIZE__")
#undef __OPTIMIZE__
#include_next <{}intrin.h>
#pragma pop_macro("__OPTIMIZE__")
"""
"""Stands before g++'s own header, which has to see what is true: where nothing is inlined, an
intrinsic with an immediate operand is a macro, or it does not compile."""


@dataclass(frozen=True, slots=True)
class Flavour:
    """One way to build everything: a name and its CMake options."""

    name: str
    options: tuple[str, ...]


GRADED = Flavour("graded", ("-DCMAKE_BUILD_TYPE=Release",))
SANITIZED = Flavour(
    "sanitized",
    (
        "-DCMAKE_BUILD_TYPE=None",
        "-DEX03_SANITIZE=ON",
        f"-DEX03_MAX_DEPTH={SMALL_MAX_DEPTH}",
        "-DCMAKE_CXX_FLAGS=-fno-sanitize-recover=all",
    ),
)


@dataclass(frozen=True, slots=True)
class Workspace:
    """The compiled framework of one flavour, and how to add one submission to it."""

    compile_command: tuple[str, ...]
    """Compiler and flags, without source, output and `-c`."""

    graph_command: tuple[str, ...]
    """The same without optimisation, so that the call graph holds every call; never run."""

    link_words: tuple[str, ...]
    """Flags and the framework's objects, without compiler, submission and output."""

    folder: Path
    """Where all of it lies."""

    compiler_folders: tuple[Path, ...]
    """Where the compiler lies, if not among the system's programs."""

    @property
    def linking(self) -> tuple[str, ...]:
        """What makes a library of a submission, which lies where the given file lay.

        It comes first, so that its functions win over the weak stand-ins.
        """
        return (*self.compile_command, SOURCE_PATH, *self.link_words)

    @property
    def listing(self) -> tuple[str, ...]:
        """What makes the assembly text of a submission."""
        return (*self.graph_command, "-S", SOURCE_PATH)


def workspace(compiler: Compiler, flavour: Flavour) -> Workspace:
    """Return the framework of one flavour, compiled now if it is not in the cache.

    Raises:
        BuildFault: Our own framework did not compile; the message has the log.
        MissingTool: CMake or make is not installed.
    """
    stub = resources.stub_folder()
    folder = resources.shared_cache("framework") / _key(stub, compiler, flavour)
    stamp = folder / "complete"
    with _locked(folder.with_suffix(".lock")):
        # Its commands name the folder, so one that was moved is of no use.
        if not stamp.exists() or stamp.read_text() != str(folder):
            shutil.rmtree(folder, ignore_errors=True)
            _compile_framework(stub, folder, compiler, flavour)
            _write_intrinsics(folder / INTRINSICS)
            _precompile(folder, compiler, flavour)
            _let_all_read(folder)
            stamp.write_text(str(folder))
    return _read_commands(folder)


def _key(stub: Path, compiler: Compiler, flavour: Flavour) -> str:
    digest = hashlib.sha256(repr((LAYOUT, compiler, flavour)).encode())
    for path in _framework_files(stub):
        digest.update(f"{path.relative_to(stub)}\0".encode() + path.read_bytes() + b"\0")
    return digest.hexdigest()[:24]


def _framework_files(stub: Path) -> list[Path]:
    wanted = [stub / "CMakeLists.txt"]
    for name in ("include", "src", "abi", "preview"):
        wanted += sorted(path for path in (stub / name).iterdir() if path.is_file())
    return wanted


@contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Keep other grader processes from building the same workspace at the same time."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _compile_framework(stub: Path, folder: Path, compiler: Compiler, flavour: Flavour) -> None:
    copy = folder / "stub"
    for path in _framework_files(stub):
        target = copy / path.relative_to(stub)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)
    build = str(folder / "build")
    cmake, make = _program("cmake"), _program("make")
    configure = [cmake, "-S", str(copy), "-B", build, "-G", "Unix Makefiles"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={make}"]
    configure += [f"-DCMAKE_CXX_COMPILER={compiler.path}", "-DEX03_UNITY=ON"]
    _step([*configure, *flavour.options], compiler)
    _step([cmake, "--build", build, "--target", "framework", "confined"], compiler)


def _program(name: str) -> str:
    """Find a program on the caller's path, which our children do not see."""
    path = shutil.which(name)
    if path is None:
        raise MissingTool(f"{name} is not installed; install the Debian package {name}")
    return path


def _write_intrinsics(folder: Path) -> None:
    folder.mkdir()
    for name in INTRINSIC_HEADERS:
        (folder / f"{name}intrin.h").write_text(UNOPTIMISED.format(name))


def _precompile(folder: Path, compiler: Compiler, flavour: Flavour) -> None:
    """Precompile the standard headers of common.h, once for each way to use this flavour."""
    common = (folder / "stub" / "include" / "common.h").read_text()
    names = [line for line in common.splitlines() if line.startswith("#include <")]
    plain = _read_commands(folder)
    # Without the depth limit, which no standard header sees: the precompiled ones then serve
    # the build with the small limit and the one with the real limit.
    ways = {STANDARD_HEADERS: with_real_depth(plain.compile_command)}
    if flavour is GRADED:
        ways[GRAPH_HEADERS] = plain.graph_command
    ending = ".gch" if compiler.name == "g++" else ".pch"

    def precompile(name: str) -> None:
        header = folder / name
        header.write_text("\n".join(names) + "\n")
        output = header.with_suffix(f".h{ending}")
        _step([*ways[name], "-x", "c++-header", str(header), "-o", str(output)], compiler)

    with ThreadPoolExecutor(len(ways)) as pool:
        list(pool.map(precompile, ways))


def with_real_depth(command: tuple[str, ...]) -> tuple[str, ...]:
    """Take the small depth limit out of a command."""
    return tuple(word for word in command if not word.startswith("-DEX03_MAX_DEPTH"))


def _let_all_read(folder: Path) -> None:
    """Whatever the caller's umask: a confined compiler may be another user."""
    for root, _, names in os.walk(folder):
        Path(root).chmod(0o755)
        for name in names:
            path = Path(root) / name
            path.chmod(path.stat().st_mode | 0o444)


def _step(command: Sequence[str], compiler: Compiler) -> None:
    outcome = launch(Order(command, FRAMEWORK_SECONDS))
    if outcome.code != 0 or outcome.timed_out:
        log = (outcome.out + outcome.err).decode(errors="replace")[-4000:]
        message = f"the framework did not build with {compiler.title}:\n{log}"
        raise BuildFault(message)


def _read_commands(folder: Path) -> Workspace:
    build = folder / "build"
    commands = json.loads((build / "compile_commands.json").read_text())
    source = str(folder / "stub" / SOURCE_PATH)
    mine = next(entry for entry in commands if entry["file"] == source)
    words = shlex.split(mine["command"])
    object_name = words[words.index("-o") + 1]
    plain = [word for word in words if word not in ("-c", "-o", object_name, source)]
    # As beside the file that a student edits: what lies in that folder can be included.
    plain += ["-iquote", str(folder / "stub" / "src")]
    # Needed by the listing only; but a file could ask whether it is there, and be another one.
    plain += ["-isystem", str(folder / INTRINSICS)]
    graph = [word for word in plain if not word.startswith("-O")] + ["-O0", "-g1", "-w"]
    # Also where the file asks for another level: a tail call would be a loop there.
    graph += ["-fno-optimize-sibling-calls"]
    # So that a file cannot show the reader of calls another code than it runs.
    graph += ["-D__OPTIMIZE__=1", "-U__NO_INLINE__"]
    link = shlex.split((build / "CMakeFiles/exercise03.dir/link.txt").read_text())
    library = link[link.index("-o") + 1]
    objects = [
        str(build / word) if word.endswith(".o") else word
        for word in link
        if word not in ("-o", library, object_name)
    ]
    return Workspace(
        compile_command=(*plain, *_included(folder / STANDARD_HEADERS)),
        graph_command=(*graph, *_included(folder / GRAPH_HEADERS)),
        link_words=tuple(objects[1:]),
        folder=folder,
        compiler_folders=_elsewhere(Path(words[0])),
    )


def _elsewhere(compiler: Path) -> tuple[Path, ...]:
    """Folder above `bin` of a compiler that is none of the system's."""
    real = compiler.resolve()
    return () if real.is_relative_to("/usr") else (real.parent.parent,)


def _included(header: Path) -> tuple[str, ...]:
    return ("-include", str(header)) if header.exists() else ()
