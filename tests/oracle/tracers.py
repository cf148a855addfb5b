"""Compiles the ways of writing a ray tracer that the rule of closest hits must not reject."""

import ctypes
import shutil
import subprocess
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from grader.model.mesh import Bvh, Floats, Mesh, Rays
from grader.resources import stub_folder

SOURCES = Path(__file__).with_name("rule")

TRIANGLES = (
    "given",
    "plane at v1",
    "plane at v3",
    "plane, unit normal",
    "plane n.p = c",
    "Moeller-Trumbore",
    "half-open edges",
    "watertight",
    "dot barycentrics",
    "area barycentrics",
    "projected barycentrics",
    "Cramer",
    "volumes",
)
"""The triangle tests of `rule/triangles.h`, as `rule/tracer.cpp` numbers them."""

BOXES = ("given", "division", "min and max", "sign")
REALS = ("float", "double")
UNSOUND_IF_FUSED = ("watertight",)
"""Where a product is not rounded, ax cy - ay cx is not 0 for equal corners, so that this test
hits faces without area from anywhere. It is a mistake of whoever asks for FMA; the grader does
not, and so this test is not compiled with it here.
"""

MULTIPLY_ADD = ("-ffp-contract=fast", "-mfma")


class Scene(ctypes.Structure):
    """What is traced, laid out as `Scene` in `rule/tracer.cpp`."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("vertices", "faces", "low", "high")),
        *((name, ctypes.c_void_p) for name in ("begin", "end", "order")),
        ("nodes", ctypes.c_uint64),
        *((name, ctypes.c_void_p) for name in ("origin", "direction", "t_min", "t_max")),
        ("rays", ctypes.c_uint64),
    )


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """Who compiles the tracers, and how."""

    compiler: str
    level: int
    """Of optimisation, 0 to 3."""

    fused: bool
    """Whether a product and a sum are rounded once, by FMA."""

    def __str__(self) -> str:
        """Word it as a column of the report."""
        return f"{self.compiler} -O{self.level}{' fma' if self.fused else ''}"


@dataclass(frozen=True, slots=True)
class Way:
    """One way to write a ray tracer."""

    triangle: int
    """Index into `TRIANGLES`."""

    box: int
    """Index into `BOXES`."""

    early: bool
    """Whether the ray is cut at the closest hit so far."""

    real: str
    """One of `REALS`."""


@dataclass(frozen=True)
class Tracer:
    """All ways, compiled with one arithmetic."""

    arithmetic: Arithmetic
    path: Path

    @cached_property
    def library(self) -> ctypes.CDLL:
        """Load it."""
        return ctypes.CDLL(str(self.path))

    def trace(self, mesh: Mesh, tree: Bvh, rays: Rays, way: Way) -> Floats:
        """Return (R,) float32, t of each ray's closest hit; infinite for a miss."""
        arrays = (mesh.vertices, mesh.faces, tree.low, tree.high, tree.begin, tree.end)
        lines = (rays.origin, rays.direction, rays.t_min, rays.t_max)
        kept = [np.ascontiguousarray(each) for each in (*arrays, tree.order, *lines)]
        places = [each.ctypes.data for each in kept]
        count = len(rays.t_min)
        scene = Scene(*places[:7], len(tree.end), *places[7:], count)
        choice = (ctypes.c_int * 3)(way.triangle, way.box, way.early)
        t = np.empty(count, dtype=np.float32)
        entry = getattr(self.library, f"rule_trace_{way.real}")
        entry(ctypes.byref(scene), choice, t.ctypes.data_as(ctypes.c_void_p))
        return t


def can_fuse() -> bool:
    """Tell whether this processor has FMA; where -mfma is unknown, it always has."""
    flags = Path("/proc/cpuinfo").read_text(errors="replace").split()
    return "fma" in flags


def every_arithmetic() -> list[Arithmetic]:
    """List both compilers, all levels, FMA off and on."""
    return [
        Arithmetic(compiler, level, fused)
        for compiler in ("g++", "clang++")
        for level in range(4)
        for fused in ((False, True) if can_fuse() else (False,))
    ]


def compiled(arithmetic: Arithmetic, folder: Path) -> Tracer:
    """Compile all ways with one arithmetic, the given tests of the framework included."""
    stub = stub_folder()
    path = folder / f"{arithmetic}.so".replace(" ", "")
    compiler = shutil.which(arithmetic.compiler)
    assert compiler, f"{arithmetic.compiler} is not installed"
    command = [
        compiler,
        *("-std=c++20", f"-O{arithmetic.level}", "-fPIC", "-shared"),
        *(MULTIPLY_ADD if arithmetic.fused else ("-ffp-contract=off",)),
        *(f"-I{each}" for each in (stub / "include", stub / "src", stub / "abi", SOURCES)),
        str(SOURCES / "tracer.cpp"),
        *(str(stub / "src" / f"{name}.cpp") for name in ("intersection", "path")),
        *("-o", str(path)),
    ]
    subprocess.run(command, check=True, timeout=300)
    return Tracer(arithmetic, path)
