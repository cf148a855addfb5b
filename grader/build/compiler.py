"""Which C++ compiler is used, and what identifies it."""

import os
import platform
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from grader.errors import MissingTool
from grader.sandbox.launch import Order, launch

CANDIDATES = ("g++", "clang++")


@dataclass(frozen=True, slots=True)
class Compiler:
    """One C++20 compiler of this machine."""

    path: str
    name: str
    """`g++` or `clang++`."""

    version: str

    @property
    def title(self) -> str:
        """Name and version for provenance: `g++ 12.2.0`."""
        return f"{self.name} {self.version}"


WRAPPERS = frozenset(("ccache", "sccache", "distcc", "icecc"))
"""Programs that go by a compiler's name."""

_INPUT = re.compile(rb"(?!\x7fELF)[^(]*\bINPUT\s*\(\s*(/[^\s)]+)")


def find_compiler() -> Compiler:
    """Take the compiler that CXX names, else g++, else clang++.

    Raises:
        MissingTool: None of them is installed, or CXX does not name a g++ or clang++.
    """
    wanted = os.environ.get("CXX")
    for candidate in (wanted,) if wanted else CANDIDATES:
        path = _program(candidate)
        if path:
            return _identify(str(Path(path).absolute()))
    missing = f"the compiler {wanted} (from CXX)" if wanted else "a C++ compiler"
    message = f"{missing} is not installed; install the Debian package g++ (12 or newer)"
    raise MissingTool(message)


def _program(name: str) -> str | None:
    """Find a compiler itself, behind those that only keep its products: they need a home."""
    folders = os.environ.get("PATH", os.defpath).split(os.pathsep)
    for k in range(len(folders)):
        path = shutil.which(name, path=os.pathsep.join(folders[k:]))
        if path is None or Path(path).resolve().name not in WRAPPERS:
            return path
    return None


def _identify(path: str) -> Compiler:
    if "++" not in Path(path).name:
        # gcc compiles C++ too, but links no C++ library: every submission would seem wrong.
        message = f"{path} (from CXX) is no C++ compiler; set CXX to g++ or clang++"
        raise MissingTool(message)
    outcome = launch(Order([path, "--version"], seconds=20.0))
    first = outcome.out.decode(errors="replace").split("\n")[0]
    version = re.search(r"(\d+\.\d+\.\d+)", first)
    if outcome.code != 0 or not version:
        message = f"{path} --version did not name a version; set CXX to g++ or clang++"
        raise MissingTool(message)
    name = "clang++" if "clang" in first else "g++"
    return Compiler(path, name, version.group(1))


def sanitizer_runtime(compiler: Compiler) -> str:
    """The libraries that must be loaded before Python itself, as LD_PRELOAD takes them.

    AddressSanitizer first, and then the C++ library: what the sanitizer has to intercept of it,
    such as the throwing of an exception, it looks for when it starts.

    Raises:
        MissingTool: The compiler has no shared AddressSanitizer.
    """
    major = compiler.version.split(".")[0]
    gnu = compiler.name == "g++"
    name = "libasan.so" if gnu else f"libclang_rt.asan-{platform.machine()}.so"
    path = _library(compiler, name)
    if path is None:
        package = f"libgcc-{major}-dev" if gnu else f"libclang-rt-{major}-dev"
        message = (
            f"{compiler.title} has no shared AddressSanitizer ({name}); install the Debian "
            f"package {package}, or set CXX to another compiler"
        )
        raise MissingTool(message)
    standard = _library(compiler, "libstdc++.so.6")
    return " ".join(str(library) for library in (path, standard) if library)


def _library(compiler: Compiler, name: str) -> Path | None:
    """Find a library of a compiler; None if it has none of that name."""
    outcome = launch(Order([compiler.path, f"-print-file-name={name}"], seconds=20.0))
    path = Path(outcome.out.decode(errors="replace").strip())
    # A compiler that does not find the file answers with its bare name.
    found = outcome.code == 0 and path.is_absolute() and path.exists()
    return _meant(path.resolve()) if found else None


def _meant(path: Path) -> Path:
    """Follow a linker script, which Fedora puts where the library should be."""
    with path.open("rb") as file:
        script = _INPUT.match(file.read(4096))
    return Path(script[1].decode()) if script else path
