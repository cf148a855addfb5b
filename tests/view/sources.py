"""Submissions that a viewer has to bear, made from the given code."""

from tests.compiled import STARTER

HERE = "    Intersection closest;\n"
AHEAD = "    *this = {};\n"


def given() -> str:
    """Return the given code: one node, and a loop over all faces."""
    return STARTER.read_text(encoding="utf-8")


def tracing(first: str) -> str:
    """Return the given code with something else at the start of `intersect`."""
    assert HERE in given()
    return given().replace(HERE, f"    {first}\n{HERE}")


def constructing(first: str) -> str:
    """Return the given code with something else at the start of `construct`."""
    assert AHEAD in given()
    return given().replace(AHEAD, f"{AHEAD}    {first}\n")


CRASH = "*reinterpret_cast<volatile int*>(sizeof(char) - 1) = 1;"
HANG = "for (volatile bool on = true; on;) {}"
CRASHES_AT_THE_RIGHT = tracing(f"if (ray.direction.x > 0.1f) {{ {CRASH} }}")
HANGS_AT_THE_RIGHT = tracing(f"if (ray.direction.x > 0.1f) {{ {HANG} }}")
CRASHES_IN_CONSTRUCT = constructing(CRASH)
THROWS = tracing('throw "on purpose";')
LEAVES = tracing("if (ray.direction.x > 0.1f) { std::exit(0); }")
MISSES = tracing("if (ray.direction.x > 0.1f) { return {}; }")
