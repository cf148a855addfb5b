"""The eight headers, as a submission may include them."""

import itertools
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.student_stub.library import STUB, run

NAMES = ["aabb", "bvh", "common", "intersection", "mesh", "point3d", "ray", "triangle"]
STANDARD = [
    "algorithm",
    "array",
    "bit",
    "cmath",
    "cstddef",
    "cstdint",
    "iostream",
    "limits",
    "numeric",
    "queue",
    "span",
    "stack",
    "utility",
    "vector",
]
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]


def includes(*headers: str) -> str:
    """Make the text of a file that includes `headers` and nothing else."""
    return "".join(f'#include "{name}.h"\n' for name in headers)


def errors(compiler: str, file: Path, *options: str | Path) -> str:
    """Check the syntax of one file; return what the compiler complains about."""
    return run(compiler, "-fsyntax-only", *FLAGS, *options, "-I", STUB / "include", file).stderr


@pytest.mark.parametrize("compiler", ["g++", "clang++"])
def test_each_header_compiles_alone(compiler: str, tmp_path: Path) -> None:
    """No header needs another one, or the standard library, to be included before it."""
    files = [tmp_path / f"{name}.cpp" for name in NAMES]
    for name, file in zip(NAMES, files, strict=True):
        file.write_text(includes(name))
    with ThreadPoolExecutor(2) as pool:
        assert list(pool.map(lambda file: errors(compiler, file), files)) == [""] * 8


def test_all_ordered_pairs_compile(tmp_path: Path) -> None:
    """Two headers in either order compile, and twice the same one does too.

    The standard library is precompiled: 56 times it would take most of a minute.
    """
    standard = tmp_path / "standard.h"
    standard.write_text("".join(f"#include <{name}>\n" for name in STANDARD))
    made = run("clang++", *FLAGS, "-x", "c++-header", standard, "-o", f"{standard}.pch")
    assert made.returncode == 0, made.stderr
    prepared = ["-include-pch", f"{standard}.pch"]
    files = []
    for a, b in itertools.permutations(NAMES, 2):
        files.append(tmp_path / f"{a}_{b}.cpp")
        files[-1].write_text(includes(a, b, a))
    with ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda file: errors("clang++", file, *prepared), files)
        assert "".join(found) == ""
    assert len(files) == 56


def test_the_headers_bring_in_the_standard_library(tmp_path: Path) -> None:
    """What existing submissions use without including it is there."""
    file = tmp_path / "uses.cpp"
    file.write_text(
        includes("common")
        + """
        size_t uses(uint32_t n) {
            std::vector<int> v(n);
            std::array<int, 2> a{};
            std::span<int> s(v);
            std::queue<int> q;
            std::stack<int> t;
            std::priority_queue<int> p;
            std::iota(s.begin(), s.end(), a[0]);
            std::nth_element(v.begin(), v.begin(), v.end());
            std::cout << std::bit_width(n) << std::sqrt(2.0f) << std::endl;
            std::ptrdiff_t d = std::numeric_limits<int8_t>::max();
            return q.size() + t.size() + p.size() + std::pair{d, 1u}.second;
        }
        """
    )
    assert errors("g++", file) == ""


def test_the_names_of_a_submission_do_not_collide(tmp_path: Path) -> None:
    """Free functions that submissions define, and `*this = {}`, compile with all headers."""
    file = tmp_path / "own.cpp"
    file.write_text(
        includes(*NAMES)
        + """
        Point3D triangleCenter(const Triangle& t) { return (t.v1 + t.v2 + t.v3) / 3; }
        std::ostream& operator<<(std::ostream& out, const Point3D& p) { return out << p.x; }
        Intersection intersect(const Mesh& m, const BVH::Node&, const IntersectionRay& r) {
            return intersect(m, r);
        }
        Point3D operator*(float s, const Point3D& p) { return p * s; }
        Point3D twice(const Point3D& p) { return 2.0F * p + 2 * p + 2.0 * p; }
        struct Access {};
        struct Counters {};
        Access counters;
        void BVH::construct(const Mesh& mesh) {
            *this = {};
            nodes.push_back(Node{mesh.getBounds(), 0, 0});
            std::cout << mesh.getBounds().center();
        }
        """
    )
    assert errors("g++", file) == ""


def test_only_a_finite_t_is_a_hit(tmp_path: Path) -> None:
    """Not what a wrong division leaves in t either."""
    (tmp_path / "hit.cpp").write_text(
        '#include "intersection.h"\n'
        "int main() {\n"
        "    Intersection hit;\n"
        "    for (const float t : {infinity, -infinity, infinity - infinity}) {\n"
        "        hit.t = t;\n"
        "        if (hit) return 1;\n"
        "    }\n"
        "    hit.t = 3e38F;\n"
        "    return hit ? 0 : 2;\n"
        "}\n"
    )
    program = tmp_path / "hit"
    made = run("g++", *FLAGS, "-I", STUB / "include", tmp_path / "hit.cpp", "-o", program)
    assert made.returncode == 0, made.stderr
    assert run(program).returncode == 0
