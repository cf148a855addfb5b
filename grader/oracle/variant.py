"""Which variant of Mitsuba works on this machine?

Theory of operation. `scalar_rgb` always works. `llvm_ad_rgb` is faster, but needs an LLVM of
version 19 or later, and a wrong one does not raise but aborts the process. So each library
that could do is tried in a child interpreter before this one touches it.
"""

import os
import re
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from grader.sandbox.launch import Order, launch

OLDEST_LLVM = 19
LIBRARY_VARIABLE = "DRJIT_LIBLLVM_PATH"
FOLDERS = (
    "/usr/lib/x86_64-linux-gnu",
    "/usr/lib/aarch64-linux-gnu",
    "/usr/lib64",
    "/usr/lib",
    "/usr/local/lib",
    *(f"/usr/lib/llvm-{version}/lib" for version in range(30, OLDEST_LLVM - 1, -1)),
)
PROBE_SECONDS = 30.0
PROBE = """
import mitsuba
mitsuba.set_variant("llvm_ad_rgb")
import drjit
assert drjit.sum(drjit.arange(mitsuba.Float, 1000))[0] == 499500
scene = mitsuba.load_dict({"type": "scene", "ball": {"type": "sphere"}})
hit = scene.ray_intersect(mitsuba.Ray3f([0, 0, -3], [0, 0, 1]))
assert hit.t[0] == 2
print("works")
"""


@dataclass(frozen=True, slots=True)
class Variant:
    """A variant of Mitsuba that was seen to work."""

    name: str
    """`scalar_rgb` or `llvm_ad_rgb`."""

    library: Path | None
    """The LLVM library that `llvm_ad_rgb` needs."""

    because: str
    """Why this one, for people: `libLLVM.so.19.1 works`."""


@cache
def working_variant() -> Variant:
    """Try the LLVM libraries of this machine, newest first; fall back on `scalar_rgb`."""
    libraries = llvm_libraries()
    for library in libraries:
        if _works(library):
            return Variant("llvm_ad_rgb", library, f"{library.name} works")
    found = ", ".join(library.name for library in libraries)
    because = f"{found} does not work" if found else f"no LLVM >= {OLDEST_LLVM} found"
    return Variant("scalar_rgb", None, because)


def llvm_libraries() -> tuple[Path, ...]:
    """List the LLVM libraries that may do: the one the user names, or all, newest first."""
    named = os.environ.get(LIBRARY_VARIABLE)
    if named:
        return (Path(named),) if Path(named).is_file() else ()
    found: dict[Path, int] = {}
    for folder in FOLDERS:
        for path in sorted(Path(folder).glob("libLLVM*.so*")):
            version = re.fullmatch(r"libLLVM(?:-|\.so\.)(\d+)[.\w]*", path.name)
            if version and int(version[1]) >= OLDEST_LLVM:
                found.setdefault(path.resolve(), int(version[1]))
    return tuple(sorted(found, key=lambda path: (-found[path], path)))


def _works(library: Path) -> bool:
    """Run a tiny Mitsuba program with this library in a child that may abort."""
    environment = {**os.environ, LIBRARY_VARIABLE: str(library)}
    order = Order(
        # -P: where the grader was started may lie a stranger's mitsuba.py.
        argv=(sys.executable, "-P", "-c", PROBE),
        seconds=PROBE_SECONDS,
        environment=environment,
    )
    outcome = launch(order)
    return outcome.code == 0 and outcome.out.strip() == b"works"
