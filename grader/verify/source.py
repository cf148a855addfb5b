"""Does the file compile, and does `construct` loop instead of calling itself?"""

import re

from grader.model.cases import BuildCase, SourceCase
from grader.model.verdict import Evidence, Example
from grader.verify.calls import CONSTRUCT, STANDARD, callees_of
from grader.verify.check import check, one
from grader.verify.walks import Callees, in_cycles, names_of, reachable, reverse

TREE_TYPES = re.compile(r"(?<!\d)(4Node|4AABB)|_ZN?K?3BVH14getFaceIndices")
"""Mangled names that speak of nodes or boxes: whoever calls these builds the tree.

A sorting helper only touches face indices and centres, so it never reaches one of them.
"""

TOKEN = re.compile(r"S[0-9A-Z]*_|T\d*_|L[a-z]n?\d+E|(?P<length>\d+)|.")
"""Pieces of a mangled name; an identifier is its length and that many letters.

Source: Itanium C++ ABI, section 5.1, "External Names (a.k.a. Mangling)".
"""

TREE_WORK = re.compile(
    r"_ZN4AABB6extend|_ZNK?3BVH14getFaceIndices"
    r"|_ZNK?St6vectorIN3BVH4NodeESaIS\w?_EE(?![CD]\d|aS|\d+_M_)"
)
"""Mangled names of what no copy and no clean-up of a tree ever calls."""


@check(BuildCase, "build.compiles")
def compiles(case: BuildCase) -> Evidence:
    """The file compiles and links with the given code."""
    examples = tuple(Example(text, "no error", "an error") for text in case.errors[:3])
    return Evidence(1, 1, examples) if examples else one(None)


@check(SourceCase, "source.construct-loops")
def construct_loops(case: SourceCase) -> Evidence:
    """`construct` uses a loop: no function that builds nodes calls itself, even indirectly.

    Recursion inside sorting helpers is allowed. Source: exercise sheet, part a, "using a loop,
    not recursion".
    """
    callees = callees_of(case.graph, _speaks_of_nodes)
    called = reachable(callees, (CONSTRUCT,)) | {CONSTRUCT}
    for name in sorted(_recursive_builders(callees) & called):
        if not STANDARD.match(name):
            line = dict(case.graph.lines).get(name, 0)
            where = f"line {line}" if line else "a function that construct calls"
            text = f"{where}: this function calls itself, but construct must use a loop"
            example = Example(text, "a loop over the nodes", "recursion")
            return Evidence(1, 1, (example,), line=line)
    return one(None)


def _recursive_builders(callees: Callees) -> set[str]:
    """Functions that call themselves and build nodes on the way.

    Nodes that own their children are copied and destroyed recursively without a word of the
    student's: a circle through a constructor or destructor counts only if it works on nodes.
    """
    callers, names = reverse(callees), names_of(callees)
    lasting = {
        name: {each for each in called if not _is_lifetime(each)}
        for name, called in callees.items()
        if not _is_lifetime(name)
    }
    plain = in_cycles(lasting) & reachable(callers, filter(_speaks_of_nodes, names))
    return plain | in_cycles(callees) & reachable(callers, filter(TREE_WORK.match, names))


def _is_lifetime(name: str) -> bool:
    """Tell whether a function is a constructor or destructor of the student's."""
    at = 2
    while not STANDARD.match(name) and (token := TOKEN.match(name, at)):
        at = token.end() + int((token["length"] or "0")[:6])
        if token[0] in ("C", "D") and name[at : at + 1].isdigit():
            return True
    return False


def _speaks_of_nodes(name: str) -> bool:
    """Whether a function has to do with nodes or boxes, and not only with sorting.

    Where it was written does not count: the comparator inside `split(Node&)`, and a quicksort
    that is made for this comparator, carry the name of `split` in theirs.
    """
    at = 2
    while (token := TOKEN.match(name, at)) and token[0] != "Z":
        at = token.end() + int((token["length"] or "0")[:6])
    return TREE_TYPES.search(name[:at]) is not None


