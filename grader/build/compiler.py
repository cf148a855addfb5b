"""Which C++ compiler is used, and what identifies it."""

import os
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


def find_compiler() -> Compiler:
    """Take the compiler that CXX names, else g++, else clang++.

    Raises:
        MissingTool: None of them is installed, or CXX does not name a g++ or clang++.
    """
    wanted = os.environ.get("CXX")
    for candidate in (wanted,) if wanted else CANDIDATES:
        path = shutil.which(candidate)
        if path:
            return _identify(path)
    missing = f"the compiler {wanted} (from CXX)" if wanted else "a C++ compiler"
    message = f"{missing} is not installed; install the Debian package g++ (12 or newer)"
    raise MissingTool(message)


def _identify(path: str) -> Compiler:
    outcome = launch(Order([path, "--version"], seconds=20.0))
    first = outcome.out.decode(errors="replace").split("\n")[0]
    version = re.search(r"(\d+\.\d+\.\d+)", first)
    if outcome.code != 0 or not version:
        message = f"{path} --version did not name a version; set CXX to g++ or clang++"
        raise MissingTool(message)
    name = "clang++" if "clang" in first else "g++"
    return Compiler(path, name, version.group(1))


def sanitizer_runtime(compiler: Compiler) -> str:
    """Path of the shared AddressSanitizer, which must be loaded before Python itself."""
    name = "libasan.so" if compiler.name == "g++" else "libclang_rt.asan-x86_64.so"
    outcome = launch(Order([compiler.path, f"-print-file-name={name}"], seconds=20.0))
    path = Path(outcome.out.decode(errors="replace").strip())
    # A compiler that does not have the file answers with the bare name.
    if outcome.code != 0 or not path.is_absolute():
        message = f"{compiler.title} has no shared AddressSanitizer ({name}); install it"
        raise MissingTool(message)
    return str(path.resolve())
