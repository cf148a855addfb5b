"""Submissions that a viewer has to bear, made from the given code."""

from grader import resources
from tests.compiled import STARTER

HERE = "    Intersection closest;\n"
END = "    return closest;\n"
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


BORDER = -0.35
RIGHT = f"if (ray.direction.x > {BORDER}f)"
"""Of the picture that tests look at."""

CRASH = "*reinterpret_cast<volatile int*>(sizeof(char) - 1) = 1;"
HANG = "for (volatile bool on = true; on;) {}"
CRASHES_AT_THE_RIGHT = tracing(f"{RIGHT} {{ {CRASH} }}")
HANGS_AT_THE_RIGHT = tracing(f"{RIGHT} {{ {HANG} }}")
STEEP = "if (ray.direction.y > 5.0f)"
"""Of no picture, whose directions have length 1."""

CRASHES_AT_STEEP_RAYS = tracing(f"{STEEP} {{ {CRASH} }}")
HANGS_AT_STEEP_RAYS = tracing(f"{STEEP} {{ {HANG} }}")
CRASHES_IN_CONSTRUCT = constructing(CRASH)
THROWS = tracing('throw "on purpose";')
LEAVES = tracing(f"{RIGHT} {{ std::exit(0); }}")


def reference() -> str:
    """Return the model solution."""
    return resources.reference_source().read_text(encoding="utf-8")
